//! Admitted requests: those of the page of this server, from this computer, with the token.

use crate::server::State;
use axum::extract::Request;
use axum::http::header::{self, HeaderMap, HeaderName, HeaderValue};
use axum::http::{Method, StatusCode};
use axum::middleware::Next;
use axum::response::{IntoResponse, Response};
use std::sync::Arc;

/// What the page may do: its own scripts and styles, requests to this server, and pictures in its text.
const POLICY: &str = "default-src 'none'; script-src 'self'; style-src 'self'; connect-src 'self'; img-src 'self' data:; base-uri 'none'; \
    form-action 'none'; frame-ancestors 'none'";

/// The same of a page that notebooks of this computer may show in a frame.
const POLICY_FRAMED: &str = "default-src 'none'; script-src 'self'; style-src 'self'; connect-src 'self'; img-src 'self' data:; base-uri 'none'; \
    form-action 'none'; frame-ancestors http://localhost:* http://127.0.0.1:*";

/// Headers of every answer.
const ALWAYS: [(HeaderName, &str); 6] = [
    (header::CONTENT_SECURITY_POLICY, POLICY),
    (header::X_CONTENT_TYPE_OPTIONS, "nosniff"),
    // the address holds the token
    (header::REFERRER_POLICY, "no-referrer"),
    (header::CACHE_CONTROL, "no-store"),
    (header::X_FRAME_OPTIONS, "DENY"),
    (HeaderName::from_static("cross-origin-resource-policy"), "same-origin"),
];

/// Refuses what does not come from the page, and adds the headers.
pub(crate) async fn guard(state: Arc<State>, request: Request, next: Next) -> Response {
    let mut response = match admitted(&state, &request) {
        Ok(()) => next.run(request).await,
        Err(status) => status.into_response(),
    };
    let framed = state.options.framed;
    for (name, value) in ALWAYS {
        let value = match name {
            header::CONTENT_SECURITY_POLICY if framed => POLICY_FRAMED,
            header::X_FRAME_OPTIONS if framed => continue,
            _ => value,
        };
        // a report of a run brings the policy of its own scripts
        response.headers_mut().entry(name).or_insert(HeaderValue::from_static(value));
    }
    response
}

fn admitted(state: &State, request: &Request) -> Result<(), StatusCode> {
    let headers = request.headers();
    // a name that another server has given to the loopback address is none of this one
    if !own_host(state.port, text(headers, &header::HOST).or(request.uri().host())) {
        return Err(StatusCode::MISDIRECTED_REQUEST);
    }
    let token = request.uri().path().strip_prefix('/').and_then(|p| p.split('/').next()).unwrap_or_default();
    if !same(token.as_bytes(), state.token.as_bytes()) {
        return Err(StatusCode::FORBIDDEN);
    }
    let origin = text(headers, &header::ORIGIN);
    let foreign = origin.is_some_and(|o| !o.strip_prefix("http://").is_some_and(|h| own_host(state.port, Some(h))));
    let site = headers.get("sec-fetch-site").map(|v| v.as_bytes());
    // the page itself, in the frame of a notebook
    let frame = state.options.framed && *request.method() == Method::GET && headers.get("sec-fetch-dest").is_some_and(|d| d == "iframe");
    if foreign || site.is_some_and(|s| s != b"same-origin" && s != b"none") && !frame {
        return Err(StatusCode::FORBIDDEN);
    }
    match *request.method() {
        // browsers open connections of any page to any server, and name the page
        Method::GET if headers.contains_key(header::UPGRADE) && origin.is_none() => Err(StatusCode::FORBIDDEN),
        Method::GET => Ok(()),
        Method::POST if origin.is_none() => Err(StatusCode::FORBIDDEN),
        Method::POST => match text(headers, &header::CONTENT_TYPE).map(|t| t.split(';').next().unwrap_or_default().trim()) {
            Some("application/json") => Ok(()),
            _ => Err(StatusCode::UNSUPPORTED_MEDIA_TYPE),
        },
        _ => Err(StatusCode::METHOD_NOT_ALLOWED),
    }
}

/// A header that stands once and is text.
fn text<'a>(headers: &'a HeaderMap, name: &HeaderName) -> Option<&'a str> {
    let mut all = headers.get_all(name).iter();
    let one = all.next()?;
    if all.next().is_some() {
        return Some("");
    }
    Some(one.to_str().unwrap_or_default())
}

fn own_host(port: u16, host: Option<&str>) -> bool {
    let Some((name, own)) = host.and_then(|h| h.rsplit_once(':')) else { return false };
    own.parse() == Ok(port) && own.bytes().all(|b| b.is_ascii_digit()) && matches!(name, "127.0.0.1" | "localhost")
}

/// Compares in a time that does not depend on where the two differ.
fn same(a: &[u8], b: &[u8]) -> bool {
    a.len() == b.len() && a.iter().zip(b).fold(0, |d, (x, y)| d | (x ^ y)) == 0
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn hosts_are_those_of_the_loopback_address_and_the_port() {
        assert!(own_host(8000, Some("127.0.0.1:8000")) && own_host(8000, Some("localhost:8000")));
        for other in ["127.0.0.1", "127.0.0.1:80", "example.org:8000", "127.0.0.1.example.org:8000", "localhost:+8000", ":8000", ""] {
            assert!(!own_host(8000, Some(other)), "{other}");
        }
        assert!(!own_host(8000, None));
        assert!(same(b"abc", b"abc") && !same(b"abc", b"abd") && !same(b"abc", b"ab"));
    }
}
