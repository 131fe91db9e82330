//! The machine as a scheme: bodies, what joins them as springs, dampers and gaps, the ground; cavities to the scale of their proportions.

mod glyphs;
mod lying;
mod places;
mod rows;
mod upright;

use super::super::text::escape;
use super::super::words::Style;
use crate::outcome::{Arg, Block, Joint, Message, Overview};

const WIDTH: f64 = 372.0;

/// The drawing of a machine that stands or lies.
pub(in crate::report) fn drawing(page: &Overview, style: &Style) -> String {
    let parts = Parts::of(page, style);
    // along a shaft there is more to show than above each other
    let along = page.horizontal || !parts.wheels.is_empty() || parts.bodies.iter().any(|b| b.flexible);
    let (content, height) = if along { lying::lying(&parts) } else { upright::upright(&parts) };
    let names: Vec<&str> = parts.bodies.iter().map(|b| b.name).collect();
    format!("<svg viewBox=\"0 0 {WIDTH} {height}\" role=\"img\" aria-label=\"{}\">{content}</svg>\n", escape(&names.join(", ")))
}

/// What is drawn, in words of the reader.
struct Parts<'a> {
    /// What turns comes before what carries it.
    bodies: Vec<Body<'a>>,
    links: Vec<Joined<'a>>,
    balls: Vec<Balls<'a>>,
    wheels: Vec<Wheels<'a>>,
    liquids: Vec<Liquid<'a>>,
}

struct Body<'a> {
    name: &'a str,
    text: String,
    rotor: bool,
    flexible: bool,
    grounded: Joint,
    /// Radius of a cavity, radius of the free surface, height, m.
    cavity: Option<(f64, f64, f64)>,
    /// First and last position of each piece of a shaft and the outer diameters there, m.
    profile: &'a [[f64; 4]],
    place: f64,
    /// From the axis of the first body to its own, m.
    axis: [f64; 2],
}

/// A part between two bodies, by their numbers; `None` is the ground.
struct Joined<'a> {
    name: &'a str,
    text: String,
    ends: [Option<(usize, f64)>; 2],
    joint: Joint,
}

/// Two wheels in mesh on parallel axes: the body and the height of each, pitch radii, m.
struct Wheels<'a> {
    name: &'a str,
    text: String,
    ends: [(usize, f64); 2],
    radii: [f64; 2],
}

struct Liquid<'a> {
    name: &'a str,
    text: String,
    body: usize,
}

struct Balls<'a> {
    name: &'a str,
    text: String,
    body: usize,
    tracks: usize,
}

impl<'a> Parts<'a> {
    fn of(page: &'a Overview, style: &Style) -> Parts<'a> {
        let words = |labels: &[Arg]| labels.iter().map(|l| style.arg(l)).collect::<Vec<_>>().join(", ");
        let body = |b: &'a Block| match b {
            Block::Body { name, rotor, flexible, labels, grounded, cavity, profile, place, axis } => {
                let text = words(labels);
                let (rotor, flexible, grounded) = (*rotor, *flexible, *grounded);
                Some(Body { name, text, rotor, flexible, grounded, cavity: *cavity, profile, place: *place, axis: *axis })
            }
            _ => None,
        };
        let mut bodies: Vec<Body> = page.machine.iter().filter_map(body).collect();
        bodies.sort_by_key(|b| !b.rotor);
        let number = |name: &str| bodies.iter().position(|b| b.name == name);
        let (mut links, mut balls, mut liquids, mut wheels) = (Vec::new(), Vec::new(), Vec::new(), Vec::new());
        for block in &page.machine {
            match block {
                Block::Link { name, ends, labels, joint, .. } => {
                    let end = |e: &Option<(String, f64)>| match e {
                        Some((body, height)) => number(body).map(|k| Some((k, *height))),
                        None => Some(None),
                    };
                    let (Some(a), Some(b)) = (end(&ends[0]), end(&ends[1])) else { continue };
                    // what acts on a body alone joins nothing
                    if a.map(|a| a.0) != b.map(|b| b.0) {
                        links.push(Joined { name, text: words(labels), ends: [a, b], joint: *joint });
                    }
                }
                Block::Balls { name, body, count, tracks, labels } => {
                    let Some(body) = number(body) else { continue };
                    let all = style.message(&Message::new("page-balls").arg("count", Arg::count(*count)));
                    let values = words(labels);
                    let text = if values.is_empty() { all } else { format!("{all}, {values}") };
                    balls.push(Balls { name, text, body, tracks: *tracks });
                }
                Block::Liquid { name, body, fill, density } => {
                    let Some(body) = number(body) else { continue };
                    let fill = Message::new("page-fill").arg("fill", Arg::percent(*fill).digits(3));
                    liquids.push(Liquid { name, text: words(&[fill.into(), Arg::quantity(*density, "kg/m^3")]), body });
                }
                Block::Wheels { name, ends, radii, labels } => {
                    let end = |e: &(String, f64)| Some((number(&e.0)?, e.1));
                    let (Some(a), Some(b)) = (end(&ends[0]), end(&ends[1])) else { continue };
                    wheels.push(Wheels { name, text: words(labels), ends: [a, b], radii: *radii });
                }
                Block::Body { .. } => {}
            }
        }
        Parts { bodies, links, balls, wheels, liquids }
    }
}

#[cfg(test)]
mod tests;
