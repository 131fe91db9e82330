//! The tables: states, folds, other changes of stability, branches.

use super::shown::{Shown, branch, words};
use crate::outcome::{self, Arg, OutcomeError, Table, TableBuilder};
use crate::solve::harmonic::branches::bifurcation::Change;
use crate::solve::harmonic::branches::branch::Origin;
use crate::solve::harmonic::branches::response::{Fold, Response, State, Traced};
use crate::study::shared::probes;
use crate::study::shared::support::largest;
use laval_num::continuation::End;

/// The kind of states a branch holds, in the legend.
pub(super) fn label(branch: &Traced) -> &'static str {
    match branch.origin {
        Origin::Low => "from low speed",
        Origin::High => "from high speed",
        Origin::Mixed => "x and y on different states",
        Origin::Broken(..) => "of less symmetry",
        Origin::Doubled(..) => "of doubled period",
        Origin::Subharmonic(2) => "repeating every 2 turns",
        Origin::Subharmonic(3) => "repeating every 3 turns",
        Origin::Subharmonic(_) => "of longer period",
        Origin::Crossing(..) | Origin::Start => "apart from the others",
    }
}

impl Shown<'_> {
    /// The states with the use of the parts' validity; with `all`, which family each belongs to.
    pub(super) fn table(&self, response: &Response, all_states: bool) -> Result<Table, OutcomeError> {
        let uses = self.measured.validity.iter().flatten().map(|u| u.worst(self.system).0).collect();
        self.states(response, all_states).float("validity", "", "largest use of a part's validity; above 1 is outside", uses).build()
    }

    /// The states; with `all`, which family each belongs to.
    pub(super) fn states(&self, response: &Response, all_states: bool) -> TableBuilder {
        let all: Vec<(usize, usize, &State)> =
            response.branches.iter().enumerate().flat_map(|(b, t)| t.points.iter().enumerate().map(move |(i, s)| (b, i, s))).collect();
        let mut t = Table::new("response", "Steady states, branch by branch in order along each; a branch may turn back in speed")
            .int("branch", "", "number of the branch", all.iter().map(|a| a.0 as i64 + 1).collect())
            .float("speed", "rad/s", "spin speed", all.iter().map(|a| a.2.speed).collect());
        if all_states {
            t = t.text("states", "family of states", all.iter().map(|a| label(&response.branches[a.0]).to_string()).collect()).flag(
                "begins",
                "first point of its branch",
                all.iter().map(|a| a.1 == 0).collect(),
            );
        }
        for (k, name) in self.bodies.iter().enumerate() {
            let column = |c: usize| all.iter().map(|a| self.measured.amplitudes[a.0][a.1][k][c]).collect::<Vec<f64>>();
            t = t
                .float(format!("{name} first order"), "m", "modulus of the forward first-order amplitude |Z_1|", column(0))
                .float(
                    format!("{name} largest displacement"),
                    "m",
                    "largest distance of the centre from its rest position over a period",
                    column(1),
                )
                .float(format!("{name} largest x"), "m", "largest |x| over a period", column(2))
                .float(format!("{name} largest y"), "m", "largest |y| over a period", column(5))
                .float(format!("{name} first order x"), "m", "amplitude of x at the spin frequency", column(6))
                .float(format!("{name} first order y"), "m", "amplitude of y at the spin frequency", column(7));
            if all_states {
                t = t.float(format!("{name} rms displacement"), "m", "root of the mean square distance from the rest position", column(4));
            }
            if response.branches.iter().any(|b| b.turns() > 1) {
                t = t.float(format!("{name} subharmonic"), "m", "largest modulus of a component slower than the spin", column(3));
            }
        }
        // the tilts of bodies are among what parts show
        for (k, p) in self.probes.iter().enumerate().filter(|(_, p)| !p.is_reference() && !p.is_tilt()) {
            let column = all.iter().map(|a| self.measured.sizes[a.0][a.1][k]).collect();
            t = t.float(probes::largest_column(p), p.unit(), probes::largest_doc(p), column);
        }
        for (k, (name, unit)) in self.measured.observed.iter().enumerate() {
            let column = all.iter().map(|a| self.measured.observations[a.0][a.1].get(k).copied().unwrap_or(f64::NAN)).collect();
            t = t.float(name, unit, "largest value over a period", column);
        }
        let measured = self.measured.first_forces.iter().flatten().any(|f| !f.is_empty());
        for (k, &slot) in self.force_slots.iter().enumerate().filter(|_| measured) {
            let name = &self.system.slots()[slot].name;
            let column = |c: usize| all.iter().map(|a| self.measured.first_forces[a.0][a.1][k][c]).collect::<Vec<f64>>();
            t = t
                .float(format!("{name} first-order force"), "N", "force at the spin frequency: semi-major axis of its ellipse", column(0))
                .float(format!("{name} first-order force x"), "N", "amplitude of its x component at the spin frequency", column(1))
                .float(format!("{name} first-order force y"), "N", "amplitude of its y component at the spin frequency", column(2));
        }
        t.float(
            "growth rate",
            "1/s",
            "largest real part of the Floquet exponents; positive grows, NaN when not assessed",
            all.iter().map(|a| a.2.growth()).collect(),
        )
        .float(
            "growth rate error",
            "1/s",
            "its estimated error; NaN when not assessed",
            all.iter().map(|a| a.2.exponents.as_ref().map_or(f64::NAN, |e| e.error)).collect(),
        )
        .flag("stable", "no growth beyond the error", all.iter().map(|a| a.2.stable()).collect())
        .flag("not unstable", "stable, or not assessed", all.iter().map(|a| !a.2.unstable()).collect())
        .float("truncation", "", "dropped over kept force harmonics", all.iter().map(|a| a.2.truncation).collect())
        .float("residual", "", "scaled residual of the balance", all.iter().map(|a| a.2.residual).collect())
    }

    /// The folds, with the size of the motion there.
    pub(super) fn fold_table(&self, response: &Response) -> Result<Table, OutcomeError> {
        let all: Vec<(usize, &Fold)> =
            response.branches.iter().enumerate().flat_map(|(b, t)| t.folds.iter().map(move |f| (b + 1, f))).collect();
        let column = |f: &dyn Fn(&Fold) -> f64| all.iter().map(|(_, x)| f(x)).collect::<Vec<f64>>();
        let mut t = Table::new("folds", "Folds of the response: speeds at which a state ceases to exist")
            .int("branch", "", "number of the branch", all.iter().map(|a| a.0 as i64).collect())
            .float("speed", "rad/s", "spin speed", column(&|f| f.speed))
            .text("direction", "sweep that jumps here", all.iter().map(|(_, f)| if f.upper { "up" } else { "down" }.to_string()).collect())
            .float("residual", "", "scaled residual of the extended system", column(&|f| f.residual))
            .float(
                "methods differ",
                "rad/s",
                "speed by the extended system minus speed located along the branch; NaN when the second found none",
                column(&|f| f.methods_differ),
            )
            .float(
                "harmonics change",
                "rad/s",
                "change when four more orders are kept; NaN when no fold was found with them",
                column(&|f| f.harmonics_change),
            );
        for (k, p) in self.probes.iter().enumerate() {
            let sizes = self.measured.at_folds.iter().flatten().map(|f: &Vec<f64>| f[k]).collect();
            t = t.float(probes::largest_column(p), p.unit(), Arg::noted(probes::largest_doc(p), "at the fold"), sizes);
        }
        t.build()
    }
}

/// Changes of stability away from folds.
pub(super) fn change_table(response: &Response) -> Result<Table, OutcomeError> {
    let all: Vec<(usize, &Change)> =
        response.branches.iter().enumerate().flat_map(|(b, t)| t.changes.iter().map(move |c| (b + 1, c))).collect();
    let column = |f: &dyn Fn(&Change) -> f64| all.iter().map(|(_, x)| f(x)).collect::<Vec<f64>>();
    let count = |f: &dyn Fn(&Change) -> usize| all.iter().map(|(_, x)| f(x) as i64).collect::<Vec<i64>>();
    Table::new("bifurcations", "Places away from folds where the stability of states changes")
        .int("branch", "", "number of the branch", all.iter().map(|a| a.0 as i64).collect())
        .text("kind", "what happens there", all.iter().map(|(_, c)| c.event.name().to_string()).collect())
        .float("speed", "rad/s", "spin speed", column(&|c| c.speed))
        .float(
            "bracket",
            "rad/s",
            "distance of the speeds on both sides between which it certainly lies",
            column(&|c| c.bracket.1 - c.bracket.0),
        )
        .float(
            "frequency",
            "rad/s",
            "frequency of the disturbance that starts or ceases to grow; 0 where the motion is left without oscillation, NaN where its order beside the spin is open",
            column(&|c| c.frequency),
        )
        .float("growth rate", "1/s", "growth rate left there: how well it is located", column(&|c| c.growth))
        .int("growing before", "", "exponents that grow before it along the branch", count(&|c| c.unstable.0))
        .int("growing after", "", "exponents that grow after it", count(&|c| c.unstable.1))
        .build()
}

/// What branches there are.
pub(super) fn branch_table(response: &Response, end: outcome::End) -> Result<Table, OutcomeError> {
    let all = &response.branches;
    let speeds = |b: &Traced| b.points.iter().fold((f64::INFINITY, f64::NEG_INFINITY), |(l, h), p| (l.min(p.speed), h.max(p.speed)));
    let held = |b: &Traced| {
        let stable = b.points.iter().filter(|p| p.stable());
        stable.fold((f64::NAN, f64::NAN), |(l, h), p| (l.min(p.speed), h.max(p.speed)))
    };
    let float = |f: &dyn Fn(&Traced) -> f64| all.iter().map(f).collect::<Vec<f64>>();
    let int = |f: &dyn Fn(&Traced) -> usize| all.iter().map(|b| f(b) as i64).collect::<Vec<i64>>();
    Table::new("branches", "Families of states, and how each was followed")
        .int("branch", "", "number of the branch", (1..=all.len() as i64).collect())
        .phrases("states", "where they come from", all.iter().map(|b| (words(b.origin), branch(b.origin).into())).collect())
        .int("turns", "", "turns of the rotor after which the motion repeats", int(&Traced::turns))
        .text(
            "symmetry",
            "turning by which the motion repeats itself",
            all.iter().map(|b| b.discretisation.whole().symmetry.name().to_string()).collect(),
        )
        .int(
            "images",
            "",
            "branches that it stands for: turned by the symmetry of the machine, or a turn of the rotor later",
            int(&|b| b.images),
        )
        .float("from", "rad/s", "lowest speed", float(&|b| speeds(b).0))
        .float("to", "rad/s", "highest speed", float(&|b| speeds(b).1))
        .float("stable from", "rad/s", "lowest speed of a stable state; NaN when none is stable", float(&|b| held(b).0))
        .float("stable to", "rad/s", "highest speed of a stable state; NaN when none is stable", float(&|b| held(b).1))
        .int("orders", "", "orders kept, in multiples of the spin frequency over turns", int(&|b| b.discretisation.harmonics))
        .float(
            "truncation",
            "",
            "dropped over kept force harmonics, worst point",
            float(&|b| largest(b.points.iter().map(|p| p.truncation))),
        )
        .text("end", "how it ends", all.iter().map(|b| ending(b.end, end).to_string()).collect())
        .build()
}

fn ending(end: End, study: outcome::End) -> &'static str {
    match end {
        End::MaxPoints if study == outcome::End::WorkLimit => "at the work limit",
        End::Reached => "at the ends of the range",
        End::Closed => "closed on itself",
        End::StepTooSmall { .. } | End::NewtonFailed { .. } => "left within the range",
        End::MaxPoints => "at the largest number of points",
        End::Cancelled => "stopped on request",
    }
}
