//! Pieces of a report for pages that put them together themselves: the same drawings, words and style sheet.

use super::first_page;
use super::html::{answer, over_speed};
use super::payload::Thinning;
use super::scene::Scene;
use super::text::{escape, prose};
use super::words::Style;
use super::{Report, html};
use crate::outcome::{Block, Figure, OutcomeError, Overview, Table};

/// A figure, drawn.
#[derive(Clone, Debug)]
pub struct Drawn {
    /// The figure element of a report, with the numbers for its script.
    pub html: String,
    /// Units of the axis along x in one SI unit.
    pub x: f64,
    /// The same of the vertical axis of each panel.
    pub y: Vec<f64>,
}

/// Draws a figure, with numbers to the pixel; `id` is unique in the page.
///
/// # Errors
/// When the figure names a table or column that does not exist.
pub fn figure(figure: &Figure, tables: &[Table], style: &Style, id: &str) -> Result<Drawn, OutcomeError> {
    let scene = Scene::new(figure, tables, style)?;
    let read = style.units.figure(figure);
    let mut html = String::new();
    html::drawn(&mut html, &scene, id, Thinning::to_pixels(&[&scene]), style);
    Ok(Drawn { html, x: read.x.factor, y: read.panels.iter().map(|p| p.y.factor).collect() })
}

/// Figures that change while a value is dragged need no zoom.
fn pixels(over: Option<&Scene>) -> Thinning {
    Thinning::to_pixels(&over.into_iter().collect::<Vec<_>>())
}

/// Modes as small pictures of the orbits of the bodies.
pub fn modes(page: &Overview, style: &Style) -> String {
    let mut s = String::new();
    first_page::modes(&mut s, page, style);
    s
}

/// The first page: verdict, checks, machine, behaviour over the speed, modes.
pub fn first_page(page: &Overview, style: &Style) -> String {
    let report = Report { overview: Some(page.clone()), style: style.clone(), ..Report::default() };
    let over = over_speed(&report);
    let mut s = String::new();
    answer(&mut s, page, over.as_ref(), pixels(over.as_ref()), style);
    s
}

/// The checks of the first page, in words: name, result, requirement, verdict.
pub fn checks(page: &Overview, style: &Style) -> Vec<[String; 4]> {
    let one = |c: &crate::outcome::Check| {
        let result = first_page::sentence(style, &c.result);
        [style.message(&c.what), result, first_page::required(style, c), c.verdict.word().to_string()]
    };
    page.checks.iter().map(one).collect()
}

/// Bodies and what joins them, drawn.
pub fn machine(blocks: &[Block], horizontal: bool, style: &Style) -> String {
    let page = Overview { machine: blocks.to_vec(), horizontal, ..Overview::default() };
    first_page::drawing(&page, style)
}

/// What the head of a report says of its language: the decimal point, and the units at ticks of logarithmic lengths.
pub fn head(style: &Style) -> (String, String) {
    (style.language.number("."), html::LENGTHS.map(|l| style.language.unit(l)).join(" "))
}

/// One page of several designs, each with its name and its first page: their checks side by side, then each by itself.
pub fn designs(all: &[(String, Report)]) -> String {
    let Some((_, first)) = all.first() else { return String::new() };
    if all.len() == 1 {
        return html::page_one(first);
    }
    let style = &first.style;
    let mut s = html::opening(first);
    let name = |k: usize, n: &str| if n.is_empty() { (k + 1).to_string() } else { n.to_string() };
    s.push_str("<section class=\"page\"><div class=\"scroll\" tabindex=\"0\"><table class=\"chk\"><thead><tr><th></th>");
    for (k, (n, r)) in all.iter().enumerate() {
        let shown = if n.is_empty() { r.machine.clone() } else { name(k, n) };
        s.push_str(&format!("<th><a href=\"#d{k}\">{}</a></th>", prose(&shown)));
    }
    s.push_str("</tr></thead><tbody>\n");
    let checks: Vec<Vec<[String; 4]>> =
        all.iter().map(|d| d.1.overview.as_ref().map(|p| self::checks(p, style)).unwrap_or_default()).collect();
    let mut rows: Vec<&String> = Vec::new();
    for check in checks.iter().flatten() {
        if !rows.contains(&&check[0]) {
            rows.push(&check[0]);
        }
    }
    for row in rows {
        s.push_str(&format!("<tr><td>{}</td>", prose(row)));
        for own in &checks {
            let found = own.iter().find(|c| c[0] == *row);
            s.push_str(&format!("<td>{}</td>", found.map_or_else(String::new, |c| prose(&c[1]))));
        }
        s.push_str("</tr>\n");
    }
    s.push_str("</tbody></table></div></section>\n");
    for (k, (n, r)) in all.iter().enumerate() {
        let Some(page) = &r.overview else { continue };
        let shown = if n.is_empty() { r.machine.clone() } else { name(k, n) };
        s.push_str(&format!("<section id=\"d{k}\"><h2>{}</h2>\n", prose(&shown)));
        let over = over_speed(r);
        html::answer_as(&mut s, page, over.as_ref(), pixels(over.as_ref()), &r.style, &format!("over{k}"));
        if let Some(input) = &r.input {
            s.push_str(&format!(
                "<details><summary>{}</summary>\n<pre tabindex=\"0\">{}</pre></details>\n",
                html::say(style, "page-input"),
                escape(input)
            ));
        }
        s.push_str("</section>\n");
    }
    s.push_str("</main>\n</body>\n</html>\n");
    s
}
