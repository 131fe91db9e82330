//! What the study of the nonlinear response says: its largest displacement against closed forms, wide ranges of speed, refusals.

use crate::common;

use common::base::Base;
use laval::diagnostic::Diagnostic;
use laval::model::builder::Builder;
use laval::model::field::Attach;
use laval::model::part::Link;
use laval::outcome::{Data, Finding, Mark, Outcome};
use laval::parts::{bearing_cubic::*, bearing_linear::*, damper::*, disc::*, stop::*};
use laval::solve::harmonic::branches::response::Request;
use laval::study::nonlinear_response::NonlinearResponse;
use laval::study::{Cancel, Context, ErasedStudy};
use laval::text::Text;
use std::sync::Mutex;
use std::sync::atomic::Ordering;

const M: f64 = 2.0;
const E: f64 = 1e-4;
const K: f64 = 1e6;

fn machine(cubic: f64, c: f64) -> Builder {
    let link = || Link::Between(Attach::on("disc"), Attach::ground());
    Builder::new("one disc")
        .part("disc", Disc::planar(), DiscParams { eccentricity: E, ..DiscParams::new(M) })
        .part(
            "spring",
            BearingCubic::isotropic(link()),
            BearingCubicParams { stiffness: [K; 2], cubic_stiffness: [cubic; 2], valid_to: 0.0 },
        )
        .part("air", Damper::fixed(link()), DamperParams { damping: [c; 2], tilt_damping: 0.0 })
}

/// States from which a machine jumps are reported as long as they are stable: an instability of another body, which knows nothing of the disc, takes the jump away.
#[test]
fn no_sweep_jumps_from_unstable_states() {
    let link = || Link::Between(Attach::on("other"), Attach::ground());
    let beside = |cross: f64| {
        machine(1e12, 170.0).part("other", Disc::planar(), DiscParams::new(1.0)).part(
            "seal",
            BearingLinear::constant(link()),
            BearingLinearParams { kxx: 1e6, kyy: 1e6, kxy: cross, kyx: -cross, cxx: 50.0, cyy: 50.0, ..BearingLinearParams::new() },
        )
    };
    let of = |cross: f64| study(beside(cross), Request::over(300.0, 1500.0)).unwrap();
    let has = |o: &Outcome, id: &str| o.findings.iter().any(|f| f.id == id);
    // growth where the cross coupling exceeds damping times the natural frequency, 50 * 1000
    let (calm, wild) = (of(4e4), of(1e5));
    assert!(has(&calm, "jump_up") && has(&calm, "jump_down") && !has(&calm, "sweep_up_unstable"), "{:?}", calm.findings);
    assert!(!has(&wild, "jump_up") && !has(&wild, "jump_down") && !has(&wild, "no_jump_up"), "{:?}", wild.findings);
    let reported = said(&wild, "sweep_up_unstable");
    near(reported.value.unwrap(), said(&calm, "jump_up").value.unwrap(), 1e-6);
    let growth = laval_num::complex::c(-1e6, 1e5).sqrt().re.abs();
    assert!(evidence(reported, "growth rate before it") > 0.5 * (growth - 25.0), "{reported:?}");
    // no masses move here
    assert!(!has(&wild, "masses_elsewhere"));
    // and the figure calls a jump what the findings do
    let labels = |o: &Outcome| -> Vec<String> {
        let marks = o.figures[0].panels[0].marks.iter();
        let rule = |m: &Mark| if let Mark::Rule(r) = m { r.vertical.then(|| r.label.to_string()) } else { None };
        marks.filter_map(rule).collect()
    };
    let (mut calm, wild) = (labels(&calm), labels(&wild));
    calm.sort();
    calm.dedup();
    assert_eq!(calm, ["jump (run-down)", "jump (run-up)"]);
    assert!(wild.len() >= 2 && wild.iter().all(|l| l == "fold"), "{wild:?}");
}

/// A study that was cancelled tells no jump from states it did not assess.
#[test]
fn a_cancelled_study_tells_no_jump() {
    struct Stops(Cancel);
    impl laval::study::Progress for Stops {
        fn report(&self, _: u64, _: u64) {}
        fn doing(&self, text: &Text) {
            if text.to_string().starts_with("stability") {
                self.0.store(true, Ordering::Relaxed);
            }
        }
    }
    let system = machine(1e12, 170.0).build().unwrap_or_else(|d| panic!("{:?}", d.0));
    let stops = Stops(Cancel::default());
    let context = Context { cancel: &stops.0, progress: &stops, ..Context::quiet("response") };
    let o = NonlinearResponse::new(Request::over(300.0, 1500.0)).run(&system, &context).unwrap();
    assert_eq!(o.end, laval::outcome::End::Cancelled);
    assert!(o.findings.iter().all(|f| !f.id.starts_with("jump") && !f.id.starts_with("no_jump")), "{:?}", o.findings);
    assert!(said(&o, "sweep_up_unfinished").sentence().contains("stopped on request"));
    assert!(said(&o, "sweep_down_unfinished").sentence().contains("were not followed"));
}

/// While a response is computed, its progress text names each branch with the speed that is reached, then its stability.
#[test]
fn a_response_says_what_it_is_doing() {
    #[derive(Default)]
    struct Heard(Mutex<Vec<String>>);
    impl laval::study::Progress for Heard {
        fn report(&self, _: u64, _: u64) {}
        fn doing(&self, text: &Text) {
            self.0.lock().unwrap().push(text.to_string());
        }
    }
    let system = machine(1e12, 170.0).build().unwrap_or_else(|d| panic!("{:?}", d.0));
    let heard = Heard::default();
    let context = Context { progress: &heard, ..Context::quiet("response") };
    NonlinearResponse::new(Request::over(300.0, 1500.0)).run(&system, &context).unwrap();
    let all = heard.0.into_inner().unwrap();
    let speeds = |of: &str| -> Vec<f64> {
        let own = all.iter().filter_map(|t| t.strip_prefix(of));
        own.map(|t| t.trim_start_matches(", at ").split(' ').next().unwrap().parse().unwrap()).collect()
    };
    let followed = speeds("branch from the lowest speed");
    assert!(followed.len() > 20 && followed[0] < 310.0 && followed.iter().copied().fold(0.0, f64::max) > 900.0, "{followed:?}");
    assert!(followed.iter().all(|w| (300.0..=1500.0).contains(w)) && followed.windows(2).all(|w| w[0] != w[1]), "{followed:?}");
    assert!(speeds("stability of the branch from the lowest speed").len() > 5, "{all:?}");
}

fn study(builder: Builder, request: Request) -> Result<Outcome, Diagnostic> {
    let system = builder.build().unwrap_or_else(|d| panic!("{:?}", d.0));
    NonlinearResponse::new(request).run(&system, &Context::quiet("response"))
}

fn said<'a>(o: &'a Outcome, id: &str) -> &'a Finding {
    o.findings.iter().find(|f| f.id == id).unwrap_or_else(|| panic!("no {id} in {:?}", o.findings))
}

fn evidence(f: &Finding, what: &str) -> f64 {
    f.evidence.iter().find(|e| e.what == what).unwrap_or_else(|| panic!("no {what} in {f:?}")).value
}

fn column(o: &Outcome, name: &str) -> Vec<f64> {
    match &o.find_table("response").unwrap().column(name).unwrap().data {
        Data::Float(v) => v.clone(),
        other => panic!("{other:?}"),
    }
}

#[track_caller]
fn near(a: f64, b: f64, relative: f64) {
    assert!((a - b).abs() <= relative * b.abs(), "{a:.15e} {b:.15e}");
}

/// `|k + k3 r^2 - m W^2 + i c W| r = m e W^2` with dr/dW = 0: `W^2 = (2 m K - c^2) r^2 / (2 m^2 (r^2 - e^2))`, K = k + k3 r^2; one equation for r. Without k3,
/// `r = e / (2 D sqrt(1 - D^2))`, `W = w0 / sqrt(1 - 2 D^2)`.
#[test]
fn largest_displacement_is_that_of_the_closed_form() {
    for (cubic, c, range) in
        [(0.0, 100.0, (100.0, 3000.0)), (0.0, 700.0, (100.0, 3000.0)), (3e10, 100.0, (100.0, 3000.0)), (-3e10, 400.0, (100.0, 3000.0))]
    {
        let square = |r: f64| (2.0 * M * (K + cubic * r * r) - c * c) * r * r / (2.0 * M * M * (r * r - E * E));
        let rest = |r: f64| {
            let (w2, k) = (square(r), K + cubic * r * r);
            ((k - M * w2).powi(2) + c * c * w2) * r * r - (M * E * w2).powi(2)
        };
        // from the quasi-static estimate outwards to the first change of sign, then halved
        let (mut lo, mut hi) = (1.001 * E, 1.001 * E);
        while (rest(hi) < 0.0) == (rest(lo) < 0.0) {
            (lo, hi) = (hi, hi * 1.01);
        }
        for _ in 0..80 {
            let middle = 0.5 * (lo + hi);
            if (rest(middle) < 0.0) == (rest(lo) < 0.0) { lo = middle } else { hi = middle }
        }
        let (r, w) = (lo, square(lo).sqrt());
        if cubic == 0.0 {
            let d = c / (2.0 * (K * M).sqrt());
            near(r, E / (2.0 * d * (1.0 - d * d).sqrt()), 1e-12);
            near(w, (K / M).sqrt() / (1.0 - 2.0 * d * d).sqrt(), 1e-12);
        }
        let o = study(machine(cubic, c), Request::over(range.0, range.1)).unwrap();
        let f = said(&o, "largest_displacement");
        near(f.value.unwrap(), r, 1e-9);
        near(evidence(f, "speed"), w, 1e-7);
        assert!(evidence(f, "scaled residual") < 1e-11 && evidence(f, "width of the bracket") < 1e-6 * w, "{f:?}");
        assert!(evidence(f, "relative slope along the branch") < 1e-9, "{f:?}");
    }
}

/// Over eight decades the points are bounded, the resonance is met, and that of the foundation, 1 rad/s wide, is not stepped over.
#[test]
fn wide_ranges_meet_their_resonances() {
    let wide = Request::over(0.01, 1e6);
    let c = 100.0;
    let o = study(machine(0.0, c), wide).unwrap();
    let d = c / (2.0 * (K * M).sqrt());
    near(said(&o, "largest_displacement").value.unwrap(), E / (2.0 * d * (1.0 - d * d).sqrt()), 1e-9);
    let points = |o: &Outcome| o.find_table("response").unwrap().rows();
    assert!(points(&o) < 1500, "{}", points(&o));
    let base = Base { e: 5e-5, ..Base::default() };
    let o = study(base.builder(), wide).unwrap();
    assert!(points(&o) < 1500, "{}", points(&o));
    let narrow = study(base.builder(), Request::over(50.0, 200.0)).unwrap();
    let highest = |o: &Outcome| {
        let (w, a) = (column(o, "speed"), column(o, "base first order"));
        w.iter().zip(a).filter(|(w, _)| (90.0..130.0).contains(*w)).fold((0.0, 0.0), |m, (&w, a)| if a > m.1 { (w, a) } else { m })
    };
    let (wide, narrow) = (highest(&o), highest(&narrow));
    near(wide.1, narrow.1, 0.05);
    near(wide.0, narrow.0, 0.005);
}

/// A stop with damping: its force jumps at the touch. States that touch during part of a turn are not assessed, and it is said why; the others are.
#[test]
fn stability_is_not_assessed_where_a_force_jumps() {
    let link = || Link::Between(Attach::on("disc"), Attach::ground());
    let with = |damping: f64| {
        machine(0.0, 100.0)
            .part(
                "side",
                BearingCubic::per_axis(link()),
                BearingCubicParams { stiffness: [1e3, 2e5], cubic_stiffness: [0.0; 2], valid_to: 0.0 },
            )
            .part("stop", Stop::new(link()), StopParams { stiffness: 1e7, gap: 3e-4, damping })
    };
    let request = Request { harmonics: Some(9), ..Request::over(200.0, 3000.0) };
    let o = study(with(1000.0), request).unwrap();
    let f = said(&o, "stability_unknown");
    assert!(f.sentence().contains("\"stop\" jumps when it touches"), "{}", f.sentence());
    let (growth, largest) = (column(&o, "growth rate"), column(&o, "disc largest displacement"));
    assert!(growth.iter().zip(&largest).all(|(g, r)| !g.is_nan() || *r > 2.9e-4));
    assert!(growth.iter().any(|g| g.is_nan()) && growth.iter().any(|g| g.is_finite()));
    // of part of the states
    let unknown = growth.iter().filter(|g| g.is_nan()).count();
    assert_eq!([f.number("unknown"), f.number("all")], [Some(unknown as f64), Some(growth.len() as f64)], "{f:?}");
    // without damping the force has a kink only: every state is assessed
    let o = study(with(0.0), request).unwrap();
    assert!(o.findings.iter().all(|f| f.id != "stability_unknown"), "{:?}", o.findings);
    // used up points are said, whether a sweep jumps before or not
    for max_points in [40, 150] {
        let o = study(with(1000.0), Request { max_points, ..request }).unwrap();
        assert_eq!(o.end, laval::outcome::End::MaxPoints);
        assert!(o.findings.iter().any(|f| f.sentence().contains("The largest number of points was reached")), "{:?}", o.findings);
    }
}

#[test]
fn refusals_say_what_to_do() {
    let text = |d: &Diagnostic| format!("{}: {}\n    {}\n", d.code, d.message, d.help.as_ref().map_or("-".to_string(), |h| h.to_string()));
    let refused = |b: Builder, r: Request| text(&study(b, r).map(|_| ()).unwrap_err());
    let mut all = refused(machine(0.0, 100.0).free_spin(), Request::over(100.0, 1000.0));
    let skew = machine(0.0, 100.0).part(
        "side",
        BearingCubic::per_axis(Link::Between(Attach::on("disc"), Attach::ground())),
        BearingCubicParams { stiffness: [1e3, 2e5], cubic_stiffness: [0.0; 2], valid_to: 0.0 },
    );
    all += &refused(skew, Request { symmetry: Some(laval::solve::symmetry::Symmetry::Quarter), ..Request::over(100.0, 1000.0) });
    insta::assert_snapshot!(all);
}

#[test]
fn the_other_sense_of_rotation_says_the_same() {
    let reported = |speeds: (f64, f64)| {
        let o = study(machine(0.0, 20.0), Request::over(speeds.0, speeds.1)).expect("a response");
        let ids: Vec<String> = o.findings.iter().map(|f| f.id.clone()).collect();
        let largest = said(&o, "largest_displacement");
        let range = |id: &str| ["from", "to"].map(|end| said(&o, id).number(end).expect("a speed"));
        (ids, largest.value, evidence(largest, "speed"), range("no_jump_up"), range("no_jump_down"))
    };
    let (ids, largest, at, up, down) = reported((200.0, 2000.0));
    let (mirrored, same, there, faster, slower) = reported((-2000.0, -200.0));
    assert_eq!(ids, mirrored);
    near(same.expect("an amplitude"), largest.expect("an amplitude"), 1e-9);
    near(there, -at, 1e-9);
    assert_eq!([up, down], [[200.0, 2000.0], [2000.0, 200.0]]);
    assert_eq!([faster, slower], [[-200.0, -2000.0], [-2000.0, -200.0]]);
}
