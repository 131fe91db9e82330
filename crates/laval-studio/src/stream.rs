//! Bodies of answers that are sent piece by piece.

use crate::abandon::Abandon;
use axum::body::{Body, Bytes};
use axum::http::header::{CONTENT_TYPE, HeaderValue};
use axum::response::Response;
use futures_core::Stream;
use std::convert::Infallible;
use std::pin::Pin;
use std::task::{Context, Poll};
use tokio::sync::mpsc::{self, UnboundedReceiver, UnboundedSender};

/// Takes the pieces.
pub(crate) type Sender = UnboundedSender<Bytes>;

/// Pieces as they come; with it ends the computation that makes them.
struct Pieces {
    pieces: UnboundedReceiver<Bytes>,
    _abandon: Abandon,
}

impl Stream for Pieces {
    type Item = Result<Bytes, Infallible>;
    fn poll_next(mut self: Pin<&mut Self>, cx: &mut Context<'_>) -> Poll<Option<Self::Item>> {
        self.pieces.poll_recv(cx).map(|p| p.map(Ok))
    }
}

/// An answer and what fills it.
pub(crate) fn streamed(kind: &'static str, abandon: Abandon) -> (Sender, Response) {
    let (sender, pieces) = mpsc::unbounded_channel();
    let mut response = Response::new(Body::from_stream(Pieces { pieces, _abandon: abandon }));
    response.headers_mut().insert(CONTENT_TYPE, HeaderValue::from_static(kind));
    (sender, response)
}
