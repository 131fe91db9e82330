//! One HTML file of designs side by side, and reports of runs in the page.

use crate::machines::Machines;
use axum::body::Body;
use axum::http::header::{CONTENT_SECURITY_POLICY, CONTENT_TYPE, HeaderValue};
use axum::response::Response;
use laval::diagnostic::{Diagnostic, Diagnostics};
use laval::file::Loaded;
use laval::report::{self, Language, Report};
use laval::run;
use laval::study::{self, Cancel, Context, Silent};
use laval::text;
use serde::Deserialize;
use std::sync::Arc;

/// `POST api/share`.
#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub(crate) struct Request {
    text: String,
    #[serde(default)]
    pins: Vec<Pin>,
}

#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields)]
struct Pin {
    name: String,
    text: String,
}

/// Most designs in one file.
const MOST: usize = 12;

/// The first page of a machine, from the machine alone.
pub(crate) fn first_page(text: &str, loaded: &Loaded, language: Language, cancel: &Cancel) -> Report {
    let context = Context { name: "summary", cancel, progress: &Silent, work_limit: u64::MAX, keep: None };
    let speeds: Vec<_> = loaded.studies.iter().flat_map(|s| s.study.speeds(&loaded.system)).collect();
    let mut report = run::begun("", (text, text.as_bytes()), loaded, Vec::new(), language);
    let page = study::overview(&loaded.system, &speeds, &[], &context);
    let studies: Vec<_> = loaded.studies.iter().map(|s| (s.name.as_str(), s.study.kind())).collect();
    report.overview = Some(study::with_studies_not_run(page, &studies));
    report
}

/// The report of the design of the text; of several designs their checks side by side before it.
pub(crate) fn share(machines: &Machines, request: &Request, language: Language, cancel: &Cancel) -> Result<String, Diagnostics> {
    if request.pins.len() >= MOST {
        let d = Diagnostic::error("studio.share", text!("at most {most} designs fit into one file", most = MOST));
        return Err(Diagnostics(vec![d]));
    }
    let load = |text: &str| -> Result<Arc<Loaded>, Diagnostics> { machines.load(text).map_err(|found| (*found).clone()) };
    let own = load(&request.text)?;
    let mut designs = vec![(String::new(), first_page(&request.text, &own, language, cancel))];
    for pin in &request.pins {
        designs.push((pin.name.clone(), first_page(&pin.text, &*load(&pin.text)?, language, cancel)));
    }
    Ok(report::fragment::designs(&designs))
}

/// A report of the program as an answer: it brings the policy of its own scripts along.
pub(crate) fn page(html: String) -> Response {
    let mut response = Response::new(Body::from(html));
    let headers = response.headers_mut();
    headers.insert(CONTENT_TYPE, HeaderValue::from_static("text/html; charset=utf-8"));
    // its own style and script are named by their hashes in the page itself, which allows nothing else
    let policy = "sandbox allow-scripts; base-uri 'none'; form-action 'none'; frame-ancestors 'none'";
    headers.insert(CONTENT_SECURITY_POLICY, HeaderValue::from_static(policy));
    response
}
