//! Motions to be played: the last frame as a drawing, and the frames for the script that plays them.

use super::text::prose;
use super::words::Style;
use crate::outcome::{Animation, Circle, Message, OutcomeError, Table};
use serde_json::{Value, json};
use std::fmt::Write;

/// Width of the drawing; the largest circle has radius 100.
const HALF: f64 = 132.0;
/// Radius of the point that stands for a body.
const POINT: f64 = 3.0;

/// Frames of one circle, in units of the drawing, y upwards.
struct Track {
    x: Vec<f64>,
    y: Vec<f64>,
    radius: f64,
}

fn column(table: &Table, name: &str) -> Vec<f64> {
    let found = table.column(name);
    (0..table.rows()).map(|r| found.and_then(|c| c.number(r)).unwrap_or(f64::NAN)).collect()
}

/// Radius that is drawn as 100.
fn size(a: &Animation) -> f64 {
    let largest = a.circles.iter().map(|c| c.radius).fold(0.0, f64::max);
    if largest > 0.0 { 0.01 * largest } else { 1.0 }
}

fn track(a: &Animation, c: &Circle, table: &Table) -> Track {
    let unit = size(a);
    let along = |k: usize| {
        let place = c.place.as_ref().map(|p| column(table, &p[k]));
        let shift = column(table, &c.displacement[k]);
        let at = |(i, d): (usize, &f64)| (a.enlarged * d + place.as_ref().map_or(0.0, |p| p[i])) / unit;
        shift.iter().enumerate().map(at).collect::<Vec<f64>>()
    };
    Track { x: along(0), y: along(1), radius: if c.radius > 0.0 { c.radius / unit } else { POINT } }
}

/// A tenth of a unit is less than a pixel.
fn short(x: f64) -> Value {
    if x.is_finite() { json!((x * 100.0).round() / 100.0) } else { Value::Null }
}

/// The figure with its controls and frames.
///
/// # Errors
/// When the animation names a table that does not exist.
pub(super) fn animation(a: &Animation, tables: &[Table], id: &str, style: &Style) -> Result<String, OutcomeError> {
    a.check(tables)?;
    let Some(table) = tables.iter().find(|t| t.name() == a.table) else { return Ok(String::new()) };
    let tracks: Vec<Track> = a.circles.iter().map(|c| track(a, c, table)).collect();
    let (times, phases) = (column(table, &a.time), column(table, &a.phase));
    let mut s = format!(
        "<figure class=\"play\" id=\"{id}\" tabindex=\"0\" aria-labelledby=\"{id}-c\">\n<figcaption id=\"{id}-c\"><b>{}</b> {}</figcaption>\n\
         <svg viewBox=\"{} {} {} {}\" role=\"img\"><g class=\"axes\"><path d=\"M-128 0H128M0 -128V128\"/></g>",
        prose(&style.arg(&a.title)),
        prose(&style.message(&a.alt)),
        -HALF,
        -HALF,
        2.0 * HALF,
        2.0 * HALF
    );
    for (c, t) in a.circles.iter().zip(&tracks) {
        let (Some(x), Some(y)) = (t.x.last(), t.y.last()) else { continue };
        let class = match (c.movable, c.radius > 0.0) {
            (true, _) => "ball",
            (false, true) => "track",
            (false, false) => "centre",
        };
        if class == "centre" {
            let _ = write!(s, "<path class=\"key\" d=\"M{x:.2} {:.2}h30\"/>", -y);
        }
        let _ = write!(
            s,
            "<circle class=\"{class}\" cx=\"{x:.2}\" cy=\"{:.2}\" r=\"{:.2}\"><title>{}</title></circle>",
            -y,
            t.radius,
            prose(&style.arg(&c.name))
        );
    }
    let frames = tracks
        .iter()
        .map(|t| json!({ "x": t.x.iter().map(|x| short(*x)).collect::<Vec<_>>(), "y": t.y.iter().map(|y| short(*y)).collect::<Vec<_>>() }));
    let data = json!({
        "t": times,
        "p": phases.iter().map(|p| short(*p)).collect::<Vec<_>>(),
        "c": frames.collect::<Vec<_>>(),
    });
    let say = |key: &'static str| prose(&style.message(&Message::new(key)));
    let speed = style.units.speed();
    let _ = writeln!(
        s,
        "</svg>\n<div class=\"controls\" hidden data-time=\"{}\" data-speed=\"{}\" data-size=\"{}\">\
         <button type=\"button\" data-pause=\"{}\">{}</button><input type=\"range\" min=\"0\" max=\"1000\" value=\"1000\" aria-label=\"{}\">\
         <select aria-label=\"{}\"><option value=\"1\">{}</option><option value=\"0\">{}</option></select>\
         <select aria-label=\"{}\"><option value=\"0\">{}</option><option value=\"1\">{}</option></select><output></output></div>\n\
         <script type=\"application/json\">{}</script>\n</figure>",
        prose(&style.language.unit("s")),
        prose(&style.language.unit(&speed.name)),
        speed.size,
        say("play-pause"),
        say("play-play"),
        say("play-time"),
        say("play-axes"),
        say("play-turning"),
        say("play-fixed"),
        say("play-pace"),
        say("play-whole"),
        say("play-turn"),
        data.to_string().replace("</", "<\\/")
    );
    Ok(s)
}
