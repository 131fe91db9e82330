//! Remarks on a machine that can be computed but probably is not meant: motions that nothing holds, values without effect.

use crate::diagnostic::{Diagnostic, Diagnostics};
use crate::model::blocks::Blocks;
use crate::model::erased::Evaluate;
use crate::model::field::Attach;
use crate::model::linear::{Form, LinearModel, LinearScratch};
use crate::model::part::{At, DofKind, Link, Physics, Rows};
use crate::model::system::{Slot, System};
use crate::model::tangent::{SparseTangent, TangentScratch};
use crate::text;
use laval_num::dense::Mat;
use laval_num::factor::{Factors, Pattern, Plan};

/// Warns of parts that cannot do what they are there for, of displacements without any stiffness and of tilt stiffness on bodies that do not tilt.
pub(super) fn check(system: &System, out: &mut Diagnostics) {
    for slot in system.slots() {
        let before = out.0.len();
        turns_nothing(system, slot, out);
        tilt_without_effect(system, slot, out);
        axis_without_effect(system, slot, out);
        if out.0.len() == before {
            clamped(system, slot, out);
        }
    }
    for (k, text) in system.warnings() {
        let slot = &system.slots()[k];
        out.push(Diagnostic::warning("part.purpose", text!("\"{name}\": {text}", name = slot.name, text)).at(slot.span.clone()));
    }
    let free = free(system);
    for (k, slot) in system.slots().iter().enumerate() {
        let kind = |i: usize| system.coordinates()[i].dof.kind;
        let own = |i: &&usize| system.coordinates()[**i].slot == k && !matches!(kind(**i), DofKind::Axial | DofKind::Twist);
        along(system, k, &free, out);
        let names: Vec<&str> = free.iter().filter(own).map(|&i| system.coordinates()[i].name.rsplit('.').next().unwrap_or("")).collect();
        if names.is_empty() {
            continue;
        }
        // springs that act on displacement alone hold a body and not its tilt
        let tilts = free.iter().filter(own).all(|&i| matches!(kind(i), DofKind::TiltX | DofKind::TiltY));
        let (message, help) = match tilts {
            true => (
                text!(
                    "nothing holds the tilt of \"{name}\" ({names}), alone or with that of the bodies it is joined to",
                    name = slot.name,
                    names = names.join(", ")
                ),
                match bends(slot) {
                    true => text!("hold it at a second place: attach another bearing"),
                    false => text!(
                        "let a shaft act on the tilt (tilt_stiffness, or a round shaft), hold the body at two heights, or leave out its diametral_inertia: then it does not tilt"
                    ),
                },
            ),
            false => (
                text!(
                    "nothing holds \"{name}\" in {names}: it can move away, alone or with the bodies it is joined to",
                    name = slot.name,
                    names = names.join(", ")
                ),
                text!("join it to \"ground\" or to a foundation with a bearing or a shaft; a damper holds nothing in place"),
            ),
        };
        out.push(Diagnostic::warning("body.free", message).at(slot.span.clone()).help(help));
    }
}

/// Motions of a part along and about the axis that nothing holds.
fn along(system: &System, slot: usize, free: &[usize], out: &mut Diagnostics) {
    let slot = &system.slots()[slot];
    for kind in [DofKind::Axial, DofKind::Twist] {
        if !free.iter().any(|&i| slot.own.contains(&i) && system.coordinates()[i].dof.kind == kind) {
            continue;
        }
        let (message, help) = match kind {
            DofKind::Axial => (
                text!("nothing holds \"{name}\" along the axis", name = slot.name),
                text!("give a bearing its kzz, or a coupling its axial_stiffness"),
            ),
            _ => (
                text!(
                    "nothing holds the rotation of \"{name}\" about the axis, alone or with what it is joined to or in mesh with: it may turn faster or slower than the spin",
                    name = slot.name
                ),
                text!(
                    "modes show this rotation at 0 Hz, which is no instability; a coupling with torsional_stiffness to \"ground\" joins it to a drive at the spin speed"
                ),
            ),
        };
        out.push(Diagnostic::warning("body.free", message).at(slot.span.clone()).help(help));
    }
}

/// A stiffness against tilt between points of which none can tilt.
fn tilt_without_effect(system: &System, slot: &Slot, out: &mut Diagnostics) {
    let mut first = 0;
    let mut tilts = Vec::new();
    for port in &slot.layout.ports {
        if port.kind.tilt {
            tilts.extend([first + 2, first + 3]);
        }
        first += port.kind.size();
    }
    // a stiffness of coordinates of its own is no stiffness against the tilt of bodies
    if tilts.is_empty() || !slot.layout.own.is_empty() || tilts.iter().any(|&i| !slot.map[i].is_empty()) {
        return;
    }
    let params = system.param_slots()[slot.params.clone()].iter().zip(&system.params()[slot.params.clone()]);
    for (p, _) in params
        .filter(|(p, x)| p.unit == "N m/rad" && !p.name.rsplit('.').next().is_some_and(|own| own.starts_with("torsional")) && **x != 0.0)
    {
        let message = text!("{name} of \"{slot}\" has no effect: what it is joined to does not tilt", name = p.name, slot = slot.name);
        out.push(
            Diagnostic::warning("part.no_tilt", message)
                .at(slot.span.clone())
                .help(text!("give a disc its diametral_inertia to let it tilt")),
        );
    }
    let blocks = system.blocks(slot, system.machine.speed.unwrap_or(100.0));
    if blocks.is_some_and(|b| tilts.iter().any(|&i| b.force[i] != 0.0)) {
        let message = text!("the moment of \"{name}\" has no effect: what it acts on does not tilt", name = slot.name);
        let help = text!("give a disc its diametral_inertia to let it tilt");
        out.push(Diagnostic::warning("part.no_tilt", message).at(slot.span.clone()).help(help));
    }
}

/// A spin of its own ratio that no part turns with.
fn turns_nothing(system: &System, slot: &Slot, out: &mut Diagnostics) {
    let Some(ratio) = slot.part.scope().and_then(|s| s.spin_ratio()).map(|k| slot.params.start + k) else { return };
    if !system.slots().iter().any(|s| s.spin == Some(ratio)) {
        let message = text!("no part turns with \"{name}\"", name = slot.name);
        let help = text!("name it in a shaft or disc: spin = \"{name}\"", name = slot.name);
        out.push(Diagnostic::warning("part.no_spin", message).at(slot.span.clone()).help(help));
    }
}

/// A part that acts along or about the axis, on bodies that have no such coordinate.
fn axis_without_effect(system: &System, slot: &Slot, out: &mut Diagnostics) {
    // what a body carries moves as that body does
    if slot.layout.body {
        return;
    }
    let kinds = slot.layout.kinds();
    for kind in [DofKind::Axial, DofKind::Twist] {
        let of: Vec<usize> = (0..kinds.len()).filter(|&i| kinds[i] == kind).collect();
        if !of.iter().all(|&i| slot.map[i].is_empty()) || !of.iter().any(|&i| acts(system, slot, i)) {
            continue;
        }
        let name = &slot.name;
        let (message, help) = match kind {
            DofKind::Axial => (
                text!("\"{name}\" acts along the axis without effect: what it is joined to does not move along it", name),
                text!("say axial = true of the shaft or disc"),
            ),
            _ => (
                text!("\"{name}\" acts about the axis without effect: what it is joined to does not twist", name),
                text!("say torsional = true of the shaft or disc"),
            ),
        };
        out.push(Diagnostic::warning("part.no_axis", message).at(slot.span.clone()).help(help));
    }
}

/// A part between two points that acts on tilt, at a body that does not tilt and could: it holds against a clamp. What is carried by one body may be planar.
fn clamped(system: &System, slot: &Slot, out: &mut Diagnostics) {
    let mut first = 0;
    for port in &slot.layout.ports {
        let tilts = first + 2..first + 4;
        first += port.kind.size();
        let Link::Between(a, b) = &port.link else { continue };
        if !port.kind.tilt || !tilts.clone().any(|i| acts(system, slot, i)) {
            continue;
        }
        let stiff = |a: &&Attach| {
            let body = system.slot(a.body.as_deref()?)?;
            Some((body.name.as_str(), body.part.body()?.without_tilt()?))
        };
        for (body, lets) in [a, b].iter().filter_map(stiff) {
            let message = text!("\"{name}\" is clamped at \"{body}\", which does not tilt", name = slot.name, body);
            let help = text!("give \"{body}\" its {lets} to let it tilt", body, lets);
            out.push(Diagnostic::warning("part.clamped", message).at(slot.span.clone()).help(help));
        }
    }
}

/// A part has a force on a local coordinate, or its forces change with that, its rate or acceleration.
fn acts(system: &System, slot: &Slot, coordinate: usize) -> bool {
    // a reaction in the frequency domain has no forces at an instant
    if matches!(slot.physics, Physics::Frequency(_)) {
        return true;
    }
    let speed = system.machine.speed.unwrap_or(100.0);
    let (n, z) = (slot.map.len(), vec![0.0; slot.states.len()]);
    let forces = |tilt: f64| {
        let mut x = vec![0.0; n];
        x[coordinate] = tilt;
        let (mut force, mut rate, mut spin) = (vec![0.0; n], vec![0.0; z.len()], 0.0);
        let at = At { q: &x, v: &x, a: &x, z: &z, phase: 0.3, speed, spin_accel: 0.0, t: 0.0 };
        let mut rows = Rows { force: &mut force, rate: &mut rate, spin: &mut spin };
        f64::residual(&*slot.part, &system.params()[slot.params.clone()], &at, &mut rows, &mut Blocks::default());
        force.extend(rate);
        force
    };
    let still = forces(0.0);
    still[coordinate] != 0.0 || still != forces(1e-3)
}

/// Stiffness relative to the largest that counts as none.
const NONE: f64 = 1e-11;

/// Coordinates of bodies left over when all stiffness is used up: one for each motion that costs no force.
fn free(system: &System) -> Vec<usize> {
    let n = system.n();
    // a part given in the frequency domain says nothing about forces at rest
    if n == 0 || system.slots().iter().any(|s| matches!(s.physics, Physics::Frequency(_))) {
        return Vec::new();
    }
    let speed = system.machine.speed.unwrap_or(100.0);
    let (mut model, mut scratch) = (LinearModel::default(), LinearScratch::default());
    system.linear(system.params(), speed, Form::Time, &mut model, &mut scratch);
    let typical: Vec<f64> = system.coordinates().iter().map(|c| c.dof.typical).collect();
    // what moves inside the rotor, such as a ball in its track, may be free
    let bodies: Vec<usize> = (0..n).filter(|&i| system.coordinates()[i].dof.kind != DofKind::Scalar).collect();
    let pattern = model.pattern();
    let mut k = vec![0.0; pattern.entries()];
    for i in 0..n {
        pattern.row(i).take_while(|x| x.1 < n).for_each(|(e, j)| k[e] = model.stiffness_alone(i, j));
    }
    let mut nonlinear = vec![0.0; pattern.entries()];
    let (zero, z) = (vec![0.0; n], vec![0.0; system.m()]);
    // a law may have no stiffness at rest, or on one side only
    for side in [-1.0, 0.0, 1.0] {
        let q: Vec<f64> = typical.iter().enumerate().map(|(i, t)| side * t / (1.0 + 0.1 * i as f64)).collect();
        let at = At { q: &q, v: &zero, a: &zero, z: &z, phase: 0.3, speed, spin_accel: 0.0, t: 0.0 };
        let (mut t, mut ts) = (SparseTangent::default(), TangentScratch::default());
        system.tangent(&at, false, &mut t, &mut ts, |s| !s.is_linear());
        for &(i, j, x) in &t.q.0 {
            // coordinates of one part are in the pattern
            if let Some(e) = pattern.index(i, j) {
                nonlinear[e] += x;
            }
        }
    }
    if system.slots().iter().any(bends) {
        return free_rigidly(system, &typical, &bodies, (pattern, &nonlinear));
    }
    k.iter_mut().zip(&nonlinear).for_each(|(k, x)| *k += x);
    for i in 0..n {
        pattern.row(i).take_while(|x| x.1 < n).for_each(|(e, j)| k[e] *= typical[i] * typical[j]);
    }
    let of = model.selection(&bodies);
    let k = of.taken(&k);
    if bodies.len() > FEW && regular(&of.inner, &k) {
        return Vec::new();
    }
    let pattern = of.inner.pattern();
    let k = Mat::from_fn(bodies.len(), bodies.len(), |i, j| pattern.index(i, j).map_or(0.0, |e| k[e]));
    unpivoted(k).into_iter().map(|i| bodies[i]).collect()
}

/// It is a body that bends: its own stiffness holds its shape and nothing else.
fn bends(slot: &Slot) -> bool {
    slot.part.body().is_some_and(|b| b.nodes().is_some())
}

/// The same of a machine with bodies that bend: each moves as a rigid body, by the coordinates of its first node.
fn free_rigidly(system: &System, typical: &[f64], bodies: &[usize], (pattern, nonlinear): (&Pattern, &[f64])) -> Vec<usize> {
    let n = system.n();
    // each coordinate over those that are kept
    let mut over: Vec<Vec<(usize, f64)>> = vec![Vec::new(); n];
    let mut kept: Vec<usize> = Vec::new();
    for slot in system.slots() {
        let nodes = slot.part.body().and_then(|b| b.nodes());
        let own = slot.own.clone().filter(|i| bodies.contains(i));
        let Some(nodes) = nodes else {
            for i in own {
                over[i] = vec![(kept.len(), 1.0)];
                kept.push(i);
            }
            continue;
        };
        let (first, base) = (kept.len(), slot.own.start);
        let size = slot.own.len() / nodes.len().max(1);
        kept.extend(slot.own.clone().take(size));
        let place = |kind: DofKind| first + (base..base + size).position(|i| system.coordinates()[i].dof.kind == kind).unwrap_or_default();
        let mut node = None;
        for i in own {
            let kind = system.coordinates()[i].dof.kind;
            if kind == DofKind::VectorX {
                node = Some(node.map_or(0, |k: usize| k + 1));
            }
            let z = node.and_then(|k| Some(nodes.get(k)? - nodes.first()?)).unwrap_or_default();
            // x + z beta, y - z alpha
            over[i] = match kind {
                DofKind::VectorX => vec![(first, 1.0), (first + 3, z)],
                DofKind::VectorY => vec![(first + 1, 1.0), (first + 2, -z)],
                DofKind::TiltX => vec![(first + 2, 1.0)],
                DofKind::TiltY => vec![(first + 3, 1.0)],
                DofKind::Axial | DofKind::Twist => vec![(place(kind), 1.0)],
                DofKind::Scalar => Vec::new(),
            };
            over[i].iter_mut().for_each(|(k, x)| *x *= typical[base + *k - first]);
        }
    }
    for &i in &kept {
        if over[i].len() == 1 && over[i][0].1 == 1.0 {
            over[i][0].1 = typical[i];
        }
    }
    let mut k = Mat::zeros(kept.len(), kept.len());
    let mut add = |i: usize, j: usize, x: f64| {
        for &(a, f) in &over[i] {
            for &(b, g) in &over[j] {
                k[(a, b)] += f * g * x;
            }
        }
    };
    let (zero, z) = (vec![0.0; n], vec![0.0; system.m()]);
    let at = At { q: &zero, v: &zero, a: &zero, z: &z, phase: 0.0, speed: 0.0, spin_accel: 0.0, t: 0.0 };
    let (mut t, mut ts) = (SparseTangent::default(), TangentScratch::default());
    system.tangent(&at, false, &mut t, &mut ts, |s| s.is_linear() && !bends(s));
    t.q.0.iter().for_each(|&(i, j, x)| add(i, j, x));
    for i in 0..n {
        pattern.row(i).take_while(|x| x.1 < n).for_each(|(e, j)| add(i, j, nonlinear[e]));
    }
    unpivoted(k).into_iter().map(|i| kept[i]).collect()
}

/// Least singular value of a stiffness, each row and column by its own size, that is not rounding: of a chain of a thousand stations, whose ends alone are held,
/// it is 1e-11.
const ROUNDING: f64 = 1e-13;
/// Coordinates up to which complete pivoting costs nothing.
const FEW: usize = 60;

/// One factorisation shows that every motion costs force: the smallest singular value, by inverse iteration, is above rounding.
fn regular(plan: &Plan, k: &[f64]) -> bool {
    let pattern = plan.pattern();
    let n = pattern.n();
    let size: Vec<f64> = (0..n).map(|i| pattern.row(i).map(|(e, _)| k[e].abs()).fold(0.0, f64::max)).collect();
    let mut scaled = k.to_vec();
    for i in 0..n {
        pattern.row(i).for_each(|(e, j)| scaled[e] /= (size[i] * size[j]).sqrt());
    }
    let Ok(factors) = Factors::new(plan, &scaled) else { return false };
    let norm = |x: &[f64]| x.iter().map(|x| x * x).sum::<f64>().sqrt();
    let mut x: Vec<f64> = (0..n).map(|i| 1.0 + 0.3 * (2.4 * i as f64).sin()).collect();
    let mut least = f64::INFINITY;
    for _ in 0..3 {
        let before = norm(&x);
        x.iter_mut().for_each(|x| *x /= before);
        factors.solve(&mut x);
        factors.solve_transposed(&mut x);
        least = norm(&x).sqrt().recip();
    }
    least > ROUNDING
}

/// Columns that elimination with complete pivoting leaves; the later of equals, so that a body far from the ground is named last.
fn unpivoted(mut k: Mat) -> Vec<usize> {
    let n = k.rows();
    // a soft mount beside a stiff bearing is no free motion: rows and columns by their own size
    let size: Vec<f64> = (0..n).map(|i| (0..n).map(|j| k[(i, j)].abs().max(k[(j, i)].abs())).fold(0.0, f64::max)).collect();
    for i in 0..n {
        for j in 0..n {
            if size[i] > 0.0 && size[j] > 0.0 {
                k[(i, j)] /= (size[i] * size[j]).sqrt();
            }
        }
    }
    let (mut rows, mut columns): (Vec<usize>, Vec<usize>) = ((0..n).collect(), (0..n).collect());
    loop {
        let best = rows.iter().flat_map(|&i| columns.iter().map(move |&j| (i, j))).max_by(|a, b| k[*a].abs().total_cmp(&k[*b].abs()));
        let Some((i, j)) = best.filter(|&p| k[p].abs() > NONE) else { break };
        rows.retain(|&r| r != i);
        columns.retain(|&c| c != j);
        for &r in &rows {
            let f = k[(r, j)] / k[(i, j)];
            for &c in &columns {
                k[(r, c)] -= f * k[(i, c)];
            }
        }
    }
    columns
}

#[cfg(test)]
mod tests {
    use super::super::load;

    const DISC: &str = "[machine]\nspeed = \"100 rad/s\"\n[[part]]\nkind = \"disc\"\nname = \"d\"\nmass = 1\n";
    fn warnings(rest: &str) -> Vec<String> {
        load(&format!("{DISC}{rest}")).unwrap_or_else(|d| panic!("{d:?}")).warnings.0.into_iter().map(|d| d.message.to_string()).collect()
    }
    fn shaft(between: &str, more: &str) -> String {
        format!("[[part]]\nkind = \"shaft_lumped\"\nbetween = {between}\nstiffness = \"1e5 N/m\"\n{more}")
    }

    #[test]
    fn balls_take_nothing_from_what_holds_the_body() {
        let ring = "[[part]]\nkind = \"balancer_ball\"\non = \"d\"\nbody_tilt = false\ngravity = 0\nball_mass = 0.05\ntrack_radius = 1\n";
        let text = format!("{DISC}{}{ring}", shaft("[\"d\", \"ground\"]", "")).replace("1e5", "1").replace("100 rad", "2.5 rad");
        let loaded = load(&text).unwrap_or_else(|d| panic!("{d:?}"));
        assert!(loaded.warnings.0.is_empty(), "{:?}", loaded.warnings);
    }

    #[test]
    fn what_nothing_holds_is_reported() {
        let damper = "[[part]]\nkind = \"damper\"\nbetween = [\"d\", \"ground\"]\ndamping = 1\n";
        let w = warnings(damper);
        assert!(w.len() == 1 && w[0].contains("nothing holds \"d\" in x, y"), "{w:?}");
        // two bodies joined to each other only: one motion each way
        let second = "[[part]]\nkind = \"disc\"\nname = \"e\"\nmass = 1\n";
        let w = warnings(&format!("{second}{}", shaft("[\"d\", \"e\"]", "")));
        assert!(w.len() == 1 && w[0].contains("in x, y"), "{w:?}");
        let held = format!("{second}{}{}", shaft("[\"d\", \"e\"]", ""), shaft("[\"e\", \"ground\"]", ""));
        assert_eq!(warnings(&held), Vec::<String>::new());
    }

    #[test]
    fn soft_mounts_and_laws_without_stiffness_alone_hold() {
        let soft = "[[part]]\nkind = \"foundation\"\nname = \"f\"\nmass = 100\nstiffness = \"1 N/m\"\n";
        let stiff = "[[part]]\nkind = \"shaft_lumped\"\nbetween = [\"d\", \"f\"]\nstiffness = \"1e9 N/m\"\n";
        assert_eq!(warnings(&format!("{soft}{stiff}")), Vec::<String>::new());
        let stop = "[[part]]\nkind = \"stop\"\nbetween = [\"d\", \"ground\"]\nstiffness = \"1e6 N/m\"\ngap = \"0.2 mm\"\n";
        assert_eq!(warnings(stop), Vec::<String>::new());
    }

    /// A shaft that is stiff against tilt is clamped at a disc without tilt; against the ground it is meant to be.
    #[test]
    fn a_shaft_is_clamped_at_a_disc_that_does_not_tilt() {
        let stiff = "tilt_stiffness = \"1e4 N m/rad\"\n";
        let second = "[[part]]\nkind = \"disc\"\nname = \"e\"\nmass = 1\ndiametral_inertia = 0.01\npolar_inertia = 0.015\n";
        let held = format!("{second}{}", shaft("[\"e\", \"ground\"]", stiff));
        let joined = |more: &str| warnings(&format!("{held}{}", shaft("[\"e\", \"d\"]", &format!("name = \"s\"\n{more}"))));
        assert_eq!(joined(stiff), ["\"s\" is clamped at \"d\", which does not tilt"]);
        assert_eq!(joined(""), Vec::<String>::new());
        let place = load(&format!("{DISC}{held}{}", shaft("[\"e\", \"d\"]", stiff))).unwrap_or_else(|d| panic!("{d:?}")).warnings.0;
        assert!(place[0].span.is_some() && place[0].help.as_deref().is_some_and(|h| h.contains("diametral_inertia")), "{place:?}");
    }

    #[test]
    fn tilt_stiffness_on_a_disc_that_does_not_tilt() {
        let w = warnings(&shaft("[\"d\", \"ground\"]", "tilt_stiffness = \"1e4 N m/rad\"\n"));
        assert!(w.len() == 1 && w[0].contains("tilt_stiffness") && w[0].contains("no effect"), "{w:?}");
        let tilting = format!(
            "[machine]\nspeed = \"100 rad/s\"\n[[part]]\nkind = \"disc\"\nname = \"d\"\nmass = 1\ndiametral_inertia = 0.01\n\
             polar_inertia = 0.015\n{}",
            shaft("[\"d\", \"ground\"]", "tilt_stiffness = \"1e4 N m/rad\"\n")
        );
        assert_eq!(load(&tilting).unwrap_or_else(|d| panic!("{d:?}")).warnings.0, []);
    }
}
