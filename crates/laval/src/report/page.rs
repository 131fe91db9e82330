//! Pages other than the report, in its style: they open offline, run no script, and adapt to phones, dark screens and paper.

use super::embed::hash;
use super::payload::drawn_on_page;
use super::scene::Scene;
use super::svg::{NARROW, WIDE, render};
use super::text::prose;
use super::words::Style;
use crate::outcome::{Figure, OutcomeError, Table};

const CSS: &str = include_str!("assets/report.css");

/// A complete page around `body`; `style` is added to the report's style sheet.
pub fn page(title: &str, style: &str, body: &str) -> String {
    let css = format!("{CSS}{style}");
    format!(
        "<!doctype html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n\
         <meta http-equiv=\"Content-Security-Policy\" content=\"default-src 'none'; style-src 'sha256-{}'; base-uri 'none'; form-action 'none'\">\n\
         <title>{}</title>\n<style>{css}</style>\n</head>\n<body>\n{body}</body>\n</html>\n",
        hash(&css),
        prose(title)
    )
}

/// A figure with its caption, drawn for wide and for narrow screens; `id` is unique in the page.
///
/// # Errors
/// When the figure names a table or column that does not exist.
pub fn figure(figure: &Figure, tables: &[Table], id: &str) -> Result<String, OutcomeError> {
    let scene = Scene::new(figure, tables, &Style::default())?;
    Ok(format!(
        "<figure class=\"fig\" id=\"{id}\" aria-labelledby=\"{id}-c\">\n<figcaption id=\"{id}-c\"><b>{}</b> {}</figcaption>\n<div class=\"plot\">{}{}</div>\n</figure>\n",
        prose(&scene.title),
        prose(&scene.alt),
        render(&scene, WIDE, drawn_on_page(&scene), Some(&format!("{id}w"))),
        render(&scene, NARROW, drawn_on_page(&scene), Some(&format!("{id}n"))),
    ))
}
