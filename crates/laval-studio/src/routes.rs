//! Which address answers what.

use crate::abandon::Abandon;
use crate::folder::Unsaved;
use crate::guard::guard;
use crate::server::State;
use crate::stream::streamed;
use crate::{answer, behind, check, edit, folder, live, page, query, ranges, reach, runs, share, start};
use axum::Router;
use axum::body::{Body, Bytes};
use axum::extract::ws::WebSocketUpgrade;
use axum::extract::{DefaultBodyLimit, Path, Request, State as Shared};
use axum::http::header::{CONTENT_TYPE, HeaderValue};
use axum::http::{StatusCode, Uri};
use axum::middleware::from_fn;
use axum::response::Response;
use axum::routing::{get, post};
use laval::diagnostic::{Diagnostic, Diagnostics};
use laval::report::Language;
use laval::study::Cancel;
use laval::text;
use serde::de::DeserializeOwned;
use serde_json::{Value as Json, json};
use std::panic::{AssertUnwindSafe, catch_unwind};
use std::sync::{Arc, PoisonError};
use tokio::task::spawn_blocking;

type Studio = Arc<State>;

/// Largest body of a request, bytes.
const LARGEST: usize = 2 << 20;
const JSON: &str = "application/json";

pub(crate) fn routes(state: Studio) -> Router {
    let guarded = state.clone();
    let mut app = Router::new()
        .route("/{token}/api/start", get(start))
        .route("/{token}/api/open", get(open))
        .route("/{token}/api/save", post(save))
        .route("/{token}/api/check", post(check))
        .route("/{token}/api/answer", post(answer))
        .route("/{token}/api/live", get(live))
        .route("/{token}/api/edit", post(edit))
        .route("/{token}/api/ranges", post(ranges))
        .route("/{token}/api/reach", post(reach))
        .route("/{token}/api/share", post(share))
        .route("/{token}/api/runs", get(list).post(run))
        .route("/{token}/api/runs/{id}/report", get(report))
        .route("/{token}/api/runs/{id}/{what}", post(steer));
    for (name, kind, content) in page::FILES {
        app = app.route(&format!("/{{token}}/{name}"), get(async move || whole(StatusCode::OK, kind, content)));
    }
    app.fallback(async || StatusCode::NOT_FOUND)
        .layer(DefaultBodyLimit::max(LARGEST))
        .layer(from_fn(move |request: Request, next| guard(guarded.clone(), request, next)))
        .with_state(state)
}

fn whole(status: StatusCode, kind: &'static str, body: impl Into<Body>) -> Response {
    let mut response = Response::new(body.into());
    *response.status_mut() = status;
    response.headers_mut().insert(CONTENT_TYPE, HeaderValue::from_static(kind));
    response
}

fn json_of(value: &Json) -> Response {
    whole(StatusCode::OK, JSON, value.to_string())
}

/// The language that the page has chosen.
fn language(state: &State, uri: &Uri) -> Language {
    query::value(uri.query(), "lang").and_then(|l| l.parse().ok()).unwrap_or(state.options.language)
}

/// A sentence instead of an answer.
fn refusal(status: StatusCode, d: &Diagnostic, language: Language) -> Response {
    whole(status, JSON, json!({ "error": language.said(&d.sentence()) }).to_string())
}

/// What a request holds.
fn read<T: DeserializeOwned>(body: &Bytes, language: Language) -> Result<T, Box<Response>> {
    serde_json::from_slice(body).map_err(|e| {
        let d = Diagnostic::error("studio.request", text!("the request cannot be read: {e}", e = e.to_string()));
        Box::new(refusal(StatusCode::BAD_REQUEST, &d, language))
    })
}

/// A defect of the program.
pub(crate) fn defect() -> Diagnostic {
    Diagnostic::error("studio.defect", text!("this is a defect of the program, not of your file: the computation failed"))
}

/// Computes an answer on a thread of its own; it ends when the connection is closed.
async fn computed(language: Language, work: impl FnOnce(&Cancel) -> Result<Json, Diagnostics> + Send + 'static) -> Response {
    let abandon = Abandon::default();
    let cancel = abandon.cancel();
    let done = spawn_blocking(move || catch_unwind(AssertUnwindSafe(|| work(&cancel)))).await;
    drop(abandon);
    match done {
        Ok(Ok(Ok(value))) => json_of(&value),
        Ok(Ok(Err(found))) => refusal(StatusCode::UNPROCESSABLE_ENTITY, &found.into_error(), language),
        _ => refusal(StatusCode::INTERNAL_SERVER_ERROR, &defect(), language),
    }
}

fn one(d: Diagnostic) -> Diagnostics {
    Diagnostics(vec![d])
}

async fn start(Shared(state): Shared<Studio>, uri: Uri) -> Response {
    let language = language(&state, &uri);
    computed(language, move |_| Ok(start::start(&state, language))).await
}

async fn open(Shared(state): Shared<Studio>, uri: Uri) -> Response {
    let language = language(&state, &uri);
    let of = |name| query::value(uri.query(), name);
    let (file, example) = (of("file"), of("example"));
    computed(language, move |_| start::open(&state, file.as_deref(), example.as_deref()).map_err(one)).await
}

async fn save(Shared(state): Shared<Studio>, uri: Uri, body: Bytes) -> Response {
    let language = language(&state, &uri);
    let request: start::Save = match read(&body, language) {
        Ok(request) => request,
        Err(response) => return *response,
    };
    let saved = spawn_blocking(move || {
        let start::Save { file, text, base, force } = &request;
        folder::save(&state.options.folder, file, text, base.as_deref(), *force).map(|()| json!({ "file": file }))
    });
    match saved.await {
        Ok(Ok(value)) => json_of(&value),
        Ok(Err(Unsaved::Changed(d))) => refusal(StatusCode::CONFLICT, &d, language),
        Ok(Err(Unsaved::Wrong(d))) => refusal(StatusCode::UNPROCESSABLE_ENTITY, &d, language),
        Err(_) => refusal(StatusCode::INTERNAL_SERVER_ERROR, &defect(), language),
    }
}

async fn check(Shared(state): Shared<Studio>, uri: Uri, body: Bytes) -> Response {
    let language = language(&state, &uri);
    match read::<check::Request>(&body, language) {
        Ok(request) => {
            let work = move |_: &Cancel| {
                let (text, answer) = check::check(&state.machines, &request, language)?;
                *state.shown.lock().unwrap_or_else(PoisonError::into_inner) = Some(text);
                Ok(answer)
            };
            computed(language, work).await
        }
        Err(response) => *response,
    }
}

async fn edit(Shared(state): Shared<Studio>, uri: Uri, body: Bytes) -> Response {
    let language = language(&state, &uri);
    match read::<edit::Request>(&body, language) {
        Ok(request) => computed(language, move |_| edit::edit(&state.machines, &request)).await,
        Err(response) => *response,
    }
}

async fn ranges(Shared(state): Shared<Studio>, uri: Uri, body: Bytes) -> Response {
    let language = language(&state, &uri);
    match read::<ranges::Request>(&body, language) {
        Ok(request) => computed(language, move |cancel| ranges::ranges(&state.machines, &request, cancel)).await,
        Err(response) => *response,
    }
}

async fn reach(Shared(state): Shared<Studio>, uri: Uri, body: Bytes) -> Response {
    let language = language(&state, &uri);
    match read::<reach::Request>(&body, language) {
        Ok(request) => computed(language, move |cancel| reach::reach(&state.machines, &request, language, cancel)).await,
        Err(response) => *response,
    }
}

async fn answer(Shared(state): Shared<Studio>, uri: Uri, body: Bytes) -> Response {
    let language = language(&state, &uri);
    let request = match read::<answer::Request>(&body, language) {
        Ok(request) => request,
        Err(response) => return *response,
    };
    let abandon = Abandon::default();
    let cancel = abandon.cancel();
    let (sender, response) = streamed("application/x-ndjson", abandon);
    behind::spawn(move || {
        let send = |value: Json| {
            // the page has gone
            let _ = sender.send(Bytes::from(format!("{value}\n")));
        };
        let done = catch_unwind(AssertUnwindSafe(|| answer::answer(&state.machines, &request, language, &cancel, &send)));
        if done.is_err() {
            send(json!({ "want": null, "serial": request.serial, "error": language.said(&defect().sentence()) }));
        }
    });
    response
}

async fn live(Shared(state): Shared<Studio>, upgrade: WebSocketUpgrade) -> Response {
    upgrade.max_message_size(LARGEST).max_frame_size(LARGEST).on_upgrade(move |socket| live::live(state, socket))
}

async fn share(Shared(state): Shared<Studio>, uri: Uri, body: Bytes) -> Response {
    let language = language(&state, &uri);
    let request = match read::<share::Request>(&body, language) {
        Ok(request) => request,
        Err(response) => return *response,
    };
    let abandon = Abandon::default();
    let cancel = abandon.cancel();
    let done = spawn_blocking(move || share::share(&state.machines, &request, language, &cancel)).await;
    drop(abandon);
    match done {
        Ok(Ok(html)) => whole(StatusCode::OK, "text/html; charset=utf-8", html),
        Ok(Err(found)) => refusal(StatusCode::UNPROCESSABLE_ENTITY, &found.into_error(), language),
        Err(_) => refusal(StatusCode::INTERNAL_SERVER_ERROR, &defect(), language),
    }
}

async fn run(Shared(state): Shared<Studio>, uri: Uri, body: Bytes) -> Response {
    let language = language(&state, &uri);
    match read::<runs::Request>(&body, language) {
        Ok(request) => computed(language, move |_| state.runs.begin(&request, language)).await,
        Err(response) => *response,
    }
}

async fn list(Shared(state): Shared<Studio>, uri: Uri) -> Response {
    json_of(&state.runs.list(language(&state, &uri)))
}

fn unknown_run(language: Language) -> Response {
    let d = Diagnostic::error("studio.run", text!("there is no such run"));
    refusal(StatusCode::NOT_FOUND, &d, language)
}

async fn steer(Shared(state): Shared<Studio>, Path((_, id, what)): Path<(String, String, String)>, uri: Uri) -> Response {
    let language = language(&state, &uri);
    match (state.runs.find(&id), what.as_str()) {
        (Some(run), "pause") => run.pause(),
        (Some(run), "resume") => run.resume(),
        (Some(run), "cancel") => run.cancel(),
        _ => return unknown_run(language),
    }
    json_of(&json!({}))
}

async fn report(Shared(state): Shared<Studio>, Path((_, id)): Path<(String, String)>, uri: Uri) -> Response {
    let language = language(&state, &uri);
    match state.runs.find(&id).and_then(|r| r.page()) {
        Some(html) => share::page(html),
        None => unknown_run(language),
    }
}
