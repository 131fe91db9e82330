//! What tilted and unequally loaded cups change in the machine: parameter overrides of the body that carries them, at every speed.
//!
//! Equations, for a body of mass M, unbalance u exp(i phi) at the height h, inertias A, C, skew t, and cups with mass m, centre of mass at z0 + V, inertias
//! about the height z0 of the hinges, unbalance U with the moment Z about it:
//!
//! ```text
//! M' = M + m                  h' = (M h + m (z0 + V))/M'            C' = C + C_cups
//! A' = A + M (h - h')^2 + A_cups + m [2 V (z0 - h') + (z0 - h')^2]
//! e' = |u + U|/M'             (A' - C') t' = (A - C) t + i [(h - h') u + (z0 - h') U + Z]
//! ```
//!
//! Validity: the body takes the parameters of a disc; without tilt only mass and unbalance count.

use crate::diagnostic::Diagnostic;
use crate::model::field::Attach;
use crate::model::system::System;
use crate::separation::load::{Load, Ring};
use laval_num::complex::{C64, c};

/// The machine with its cups at a speed, and their load.
pub(super) fn loaded(system: &System, cups: &[(Attach, Ring)], speed: f64) -> Result<(Option<System>, Vec<Load>), Diagnostic> {
    let loads: Vec<Load> = cups.iter().map(|c| c.1.at(speed)).collect();
    let mut overrides: Vec<(String, f64)> = Vec::new();
    for name in cups.iter().filter_map(|c| c.0.body.clone()).collect::<std::collections::BTreeSet<_>>() {
        let own = cups.iter().zip(&loads).filter(|(c, _)| c.0.body.as_deref() == Some(name.as_str()));
        overrides.extend(body(system, &name, own.map(|(c, l)| (c.0.position, *l)))?);
    }
    if overrides.is_empty() {
        return Ok((None, loads));
    }
    let by_path: Vec<(&str, f64)> = overrides.iter().map(|(p, x)| (p.as_str(), *x)).collect();
    let system = system.with(&by_path).map_err(|d| {
        let why = d.0.into_iter().next().map(|d| d.message).unwrap_or_default();
        Diagnostic::error("cup.load", format!("the rotor with its cups at {speed} rad/s does not exist: {why}"))
    })?;
    Ok((Some(system), loads))
}

fn body(system: &System, name: &str, cups: impl Iterator<Item = (f64, Load)>) -> Result<Vec<(String, f64)>, Diagnostic> {
    let path = |p: &str| format!("{name}.{p}");
    let get = |p: &str| system.param(&path(p)).and_then(|i| system.params().get(*i.first()?).copied());
    let n = |p: &str| get(p).unwrap_or(0.0);
    let (mass, h) = (n("mass"), n("centre_of_mass"));
    let own = C64::cis(n("eccentricity_phase")).scale(mass * n("eccentricity") + n("unbalance"));
    let tilts = n("diametral_inertia") > 0.0;
    let cups: Vec<(f64, Load)> = cups.collect();
    let total = mass + cups.iter().map(|c| c.1.mass).sum::<f64>();
    let height = (mass * h + cups.iter().map(|(z, l)| l.mass * (z + l.height)).sum::<f64>()) / total;
    let unbalance = cups.iter().fold(own, |u, c| u + c.1.unbalance);
    let polar = n("polar_inertia") + cups.iter().map(|c| c.1.polar).sum::<f64>();
    let mut out = vec![
        (path("mass"), total),
        (path("eccentricity"), unbalance.abs() / total),
        (path("eccentricity_phase"), if unbalance.abs() > 0.0 { unbalance.arg() } else { 0.0 }),
        (path("unbalance"), 0.0),
        (path("polar_inertia"), polar),
    ];
    if get("eccentricity").is_none() || get("unbalance").is_none() {
        return Err(Diagnostic::error("cup.body", format!("\"{name}\" has no unbalance of its own that cups could add to"))
            .help("attach the cups to a disc"));
    }
    if tilts {
        let shifted = |(z, l): &(f64, Load)| {
            let d = z - height;
            l.diametral + l.mass * (2.0 * l.height * d + d * d)
        };
        let diametral = n("diametral_inertia") + mass * (h - height).powi(2) + cups.iter().map(shifted).sum::<f64>();
        let skewed = C64::cis(n("skew_phase")).scale((n("diametral_inertia") - n("polar_inertia")) * n("skew"));
        let couple = cups.iter().fold(own.scale(h - height), |m, (z, l)| m + l.unbalance.scale(z - height) + l.couple);
        let moment = skewed + couple * c(0.0, 1.0);
        let difference = diametral - polar;
        let skew = if moment.abs() > 0.0 { moment.scale(1.0 / difference) } else { c(0.0, 0.0) };
        if !(skew.abs() <= 0.5) {
            return Err(Diagnostic::error(
                "cup.couple",
                format!("\"{name}\" with its cups is nearly a sphere in its inertia, and its couple of unbalance cannot be written as a skew"),
            )
            .help("move the hinges to the height of the centre of mass, or give the disc a diametral_inertia that differs more from polar_inertia"));
        }
        out.extend([
            (path("diametral_inertia"), diametral),
            (path("centre_of_mass"), height),
            (path("skew"), skew.abs()),
            (path("skew_phase"), if skew.abs() > 0.0 { skew.arg() } else { 0.0 }),
        ]);
    }
    Ok(out)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::model::builder::Builder;
    use crate::model::params::Family;
    use crate::model::part::Link;
    use crate::parts::{bearing_cubic::*, disc::*};
    use crate::separation::cup::{Hanging, SwingingCup};
    use crate::solve::linear_response::response;
    use crate::solve::rest::rest;

    /// Far above its critical speeds a rotor turns about its principal axis of inertia: that of a disc with one point mass m at the radius r leans by
    /// P/(A' - C') to the mass (A' as the mean over all directions), P = m r times the height of the mass over the common centre, and passes through that centre.
    #[test]
    fn a_free_rotor_turns_about_its_principal_axis() {
        let (disc, diametral, polar, hinge_height) = (10.0, 0.5, 0.2, 0.3);
        let spring = |z: f64| BearingCubic::isotropic(Link::Between(Attach::at("disc", z), Attach::ground()));
        let soft = BearingCubicParams { stiffness: [1e-3; 2], cubic_stiffness: [0.0; 2], valid_to: 0.0 };
        let inertia = DiscParams { mass: disc, diametral_inertia: diametral, polar_inertia: polar, ..DiscFamily::defaults() };
        let system = Builder::new("free")
            .part("disc", Disc::tilting(), inertia)
            .part("upper", spring(0.1), soft)
            .part("lower", spring(-0.1), soft)
            .build()
            .unwrap_or_else(|d| panic!("{d:?}"));
        let (tilt, m, hinge, l, speed) = (0.9f64, 0.04, 0.15, 0.1, 1e3);
        let cup = SwingingCup { hinge, body: Hanging::point(m, l), damping: 0.0, gravity: 9.80665 };
        let ring = Ring { cup, held: Some(tilt), count: 1, mass_differences: vec![], centre_differences: vec![] };
        let (turned, _) = loaded(&system, &[(Attach::at("disc", hinge_height), ring)], speed).unwrap_or_else(|d| panic!("{d:?}"));
        let turned = turned.expect("the cups change the machine");

        let (r, z) = (hinge + l * tilt.sin(), hinge_height - l * tilt.cos());
        let total = disc + m;
        let centre = m * z / total;
        let moment = diametral + disc * centre * centre + m * (z - centre).powi(2) + 0.5 * m * r * r - (polar + m * r * r);
        let lean = m * r * (z - centre) / moment;
        let found = response(&turned, &|w| rest(&turned, w), speed).unwrap_or_else(|d| panic!("{d:?}")).expect("no resonance");
        let (x, angle) = (found.circles(0).0, found.circles(2).0);
        for height in [0.0, 1.0] {
            let at = x - (angle * c(0.0, 1.0)).scale(height);
            let expected = -m * r / total - lean * (height - centre);
            assert!((at - c(expected, 0.0)).abs() < 1e-9 * expected.abs(), "{at:?} {expected}");
        }
    }
}
