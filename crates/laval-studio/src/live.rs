//! Answers over a connection that stays open: of each change a message to the server and one back for each answer, without the time that a request of its own takes.
//!
//! ```text
//! page     {"answer": {...}, "lang": "en"}    the body of `POST api/answer`, with a serial number of its own
//! page     {"cancel": 7}                      the answer with this serial number is no longer wanted
//! server   {"serial": 7, "want": "modes", ...}   as the lines of `POST api/answer`, one or more of them
//! ```

use crate::abandon::Abandon;
use crate::routes::defect;
use crate::server::State;
use crate::{answer, behind};
use axum::extract::ws::{Message, Utf8Bytes, WebSocket};
use laval::report::Language;
use laval::study::Cancel;
use serde::Deserialize;
use serde_json::{Value as Json, json};
use std::cell::RefCell;
use std::collections::HashMap;
use std::panic::{AssertUnwindSafe, catch_unwind};
use std::sync::Arc;
use std::time::{Duration, Instant};
use tokio::sync::mpsc::{UnboundedSender, unbounded_channel};
use tokio::task::spawn_blocking;

/// Most answers of one page that are computed or wait at a time.
const MOST: usize = 32;

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct Received {
    answer: Option<answer::Request>,
    lang: Option<String>,
    cancel: Option<i64>,
}

/// What a thread that computes an answer hands over.
enum Step {
    Line(String),
    /// The answer is complete; of modes, whether they took less than [`BRIEF`].
    End {
        brief: Option<bool>,
    },
}

/// Where modes took no longer the last time, those after a changed number are computed without a thread of their own: waking it and the server again takes as long as they do.
const BRIEF: Duration = Duration::from_millis(5);

/// Serves one page until it closes the connection; its computations then end.
pub(crate) async fn live(state: Arc<State>, mut socket: WebSocket) {
    let (sender, mut lines) = unbounded_channel::<(i64, Step)>();
    let mut open: HashMap<i64, Abandon> = HashMap::new();
    let mut brief = false;
    loop {
        tokio::select! {
            message = socket.recv() => match message {
                Some(Ok(Message::Text(text))) => {
                    let Ok(Received { answer, lang, cancel }) = serde_json::from_str(&text) else { return };
                    if let Some(serial) = cancel {
                        open.remove(&serial);
                    }
                    if let Some(request) = answer {
                        let language = lang.and_then(|l| l.parse().ok()).unwrap_or(state.options.language);
                        if open.len() >= MOST {
                            return;
                        }
                        if brief && request.follows() {
                            let (begun, written) = (Instant::now(), RefCell::new(Vec::new()));
                            compute(&state, &request, language, &Cancel::default(), &|line| written.borrow_mut().push(line));
                            brief = begun.elapsed() < BRIEF;
                            // one message: the browser runs a task of its own for each
                            if socket.send(Message::Text(Utf8Bytes::from(written.into_inner().join("\n")))).await.is_err() {
                                return;
                            }
                            continue;
                        }
                        // another machine may take longer: known when it is computed
                        brief &= !request.quick();
                        let (serial, abandon) = (request.serial, Abandon::default());
                        begin(&state, request, language, &abandon, sender.clone());
                        open.insert(serial, abandon);
                    }
                }
                // pings are answered by the library
                Some(Ok(Message::Ping(_) | Message::Pong(_))) => {}
                _ => return,
            },
            Some((serial, step)) = lines.recv() => match step {
                // lines of cancelled answers are not sent
                Step::Line(line) if open.contains_key(&serial) => {
                    if socket.send(Message::Text(Utf8Bytes::from(line))).await.is_err() {
                        return;
                    }
                }
                Step::Line(_) => {}
                Step::End { brief: short } => {
                    brief = short.unwrap_or(brief);
                    drop(open.remove(&serial));
                }
            },
        }
    }
}

/// Computes an answer on a thread of its own.
fn begin(state: &Arc<State>, request: answer::Request, language: Language, abandon: &Abandon, sender: UnboundedSender<(i64, Step)>) {
    let (state, cancel) = (state.clone(), abandon.cancel());
    let quick = request.quick();
    let work = move || {
        let begun = Instant::now();
        // where nothing receives, the page has gone
        let send = |step| drop(sender.send((request.serial, step)));
        compute(&state, &request, language, &cancel, &|line| send(Step::Line(line)));
        send(Step::End { brief: quick.then(|| begun.elapsed() < BRIEF) });
    };
    if quick {
        spawn_blocking(work);
    } else {
        behind::spawn(work);
    }
}

/// The lines of an answer; a defect is one of them.
fn compute(state: &State, request: &answer::Request, language: Language, cancel: &Cancel, line: &dyn Fn(String)) {
    let send = |value: Json| line(value.to_string());
    let done = catch_unwind(AssertUnwindSafe(|| answer::answer(&state.machines, request, language, cancel, &send)));
    if done.is_err() {
        send(json!({ "want": null, "serial": request.serial, "error": language.said(&defect().sentence()) }));
    }
}
