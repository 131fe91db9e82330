//! Opens the one-file report in a headless browser: no error, every figure drawn, zoom and readout work, nothing fetched.

use laval::outcome::{
    Animation, Arg, Axis, Band, Circle, End, Figure, Finding, Heat, Line, Outcome, Panel, Points, Rule, SpecialPoint, Status, Table, Text,
};
use laval::report::{Format, Provenance, Report, html, write};
use std::f64::consts::PI;
use std::path::{Path, PathBuf};
use std::process::Command;

const RPM: f64 = 30.0 / PI;

/// Steady response of a hardening oscillator: the frequency is explicit in the amplitude, so the curve folds back.
fn response() -> Outcome {
    let (w0, zeta, cubic, drive) = (300.0_f64, 0.11, 2.5e11, 0.12e-3);
    let (mut speed, mut amplitude, mut phase, mut stable, mut branch) = (vec![], vec![], vec![], vec![], vec![]);
    let mut folds = Vec::new();
    // s = w^2: (w0^2 + 3/4 k a^2 - s)^2 a^2 + (2 zeta w0)^2 s a^2 = (drive s)^2
    let sides = |a: f64| {
        let k = w0 * w0 + 0.75 * cubic * a * a;
        let (qa, qb, qc) = (1.0 - (drive / a).powi(2), (2.0 * zeta * w0).powi(2) - 2.0 * k, k * k);
        let d = (qb * qb - 4.0 * qa * qc).sqrt();
        [(-qb - d) / (2.0 * qa), (-qb + d) / (2.0 * qa)]
    };
    let top = (1..40000).map(|i| i as f64 * 1e-7).filter(|a| sides(*a)[0] > 0.0).fold(0.0, f64::max);
    let mut path: Vec<(f64, f64)> = (0..400).map(|i| 2e-6 * (top / 2e-6).powf(i as f64 / 399.0)).map(|a| (sides(a)[0], a)).collect();
    path.extend((0..400).map(|i| top * (drive * 1.02 / top).powf(i as f64 / 399.0)).map(|a| (sides(a)[1], a)));
    path.retain(|(s, a)| s.is_finite() && *s > 0.0 && *a > drive * 1e-3 && s.sqrt() < 1500.0);
    for (i, (s, a)) in path.iter().enumerate() {
        let w = s.sqrt();
        let rising = i == 0 || path[i - 1].0 <= *s;
        if let (Some(&last), true) = (stable.last(), i > 1)
            && last != rising
        {
            folds.push((w, *a));
        }
        speed.push(w);
        amplitude.push(*a);
        phase.push((2.0 * zeta * w0 * w).atan2(w0 * w0 + 0.75 * cubic * a * a - s));
        stable.push(rising);
        branch.push("drum".to_string());
    }
    let table = Table::new("response", "Steady unbalance response of the drum")
        .float("speed", "rad/s", "spin speed", speed)
        .float("amplitude", "m", "largest displacement of the drum", amplitude)
        .float("phase", "rad", "lag of the displacement behind the unbalance", phase)
        .flag("stable", "all Floquet multipliers inside the unit circle", stable)
        .text("branch", "which branch", branch)
        .build()
        .unwrap();
    let points = Table::new("special", "Folds of the response")
        .float("speed", "rad/s", "", folds.iter().map(|f| f.0).collect())
        .float("amplitude", "m", "", folds.iter().map(|f| f.1).collect())
        .text("kind", "", folds.iter().map(|_| "fold".to_string()).collect())
        .build()
        .unwrap();
    let x = Axis::new("speed", "rpm").factor(RPM);
    let curves = |y: &str| Line::new("response", "speed", y).solid_where("stable").name("drum");
    let figure = Figure::new(
        "amplitude",
        "Unbalance response",
        "The amplitude rises to a peak that leans to higher speeds; between the two folds the middle branch is unstable.",
    )
    .x(x.clone())
    .panel(
        Panel::new(Axis::log("amplitude", "µm").factor(1e6))
            .mark(Band::x(380.0, 450.0).name("operating range"))
            .mark(curves("amplitude"))
            .mark(Points::new("special", "speed", "amplitude").group("kind"))
            .mark(Rule::x(300.0, "linear critical speed"))
            .mark(Rule::x(314.159, "nominal speed"))
            .mark(Rule::x(330.0, "alarm"))
            .mark(Rule::y(0.5e-3, "clearance")),
    )
    .panel(
        Panel::new(Axis::new("phase lag", "°").factor(180.0 / PI).range(0.0, 180.0))
            .mark(curves("phase"))
            .mark(Rule::x(314.159, "nominal speed")),
    );
    let mut outcome = Outcome::new("nonlinear_response", "response")
        .over("speed", "rad/s")
        .end(End::StepTooSmall { at: 1432.1 })
        .finding(
            Finding::info("peak_amplitude", "The drum moves most, {}, at 4790 rpm.")
                .value(top, "m")
                .evidence("residual", 3e-13, "N")
                .evidence("change with 2 more harmonics", 4.1e-9, "m"),
        )
        .finding(
            Finding::warning(
                "jump",
                "Between 4010 and 4790 rpm the response may jump between two stable states; the operating range lies inside.",
            )
            .evidence("bracket width", 2e-9, "rad/s"),
        )
        .finding(
            Finding::invalid("liquid_depth", "Above 4300 rpm the liquid surface moves further than the layer is thick, {}.")
                .value(2.3e-3, "m"),
        )
        .table(table)
        .table(points)
        .figure(figure)
        .work("newton_steps", 4123)
        .work("factorisations", 4123);
    for (w, a) in folds {
        outcome = outcome.special_point(SpecialPoint::new("fold", w, (w - 1e-9, w + 1e-9)).evidence("amplitude", a, "m"));
    }
    outcome
        .special_point(
            SpecialPoint::new("neimark_sacker", 512.3, (512.0, 512.7))
                .status(Status::Doubtful("the multiplier passes 1 in angle 0.01".into())),
        )
        .checked()
        .unwrap()
}

fn campbell() -> Outcome {
    let (mut speed, mut frequency, mut mode, mut whirl) = (vec![], vec![], vec![], vec![]);
    for k in 0..6 {
        for i in 0..=60 {
            let w = i as f64 * 20.0;
            let base = 150.0 + 160.0 * (k / 2) as f64;
            let g = 0.06 * (1 + k / 2) as f64 * w;
            speed.push(w);
            frequency.push(if k % 2 == 0 { (base * base + g * g).sqrt() - g } else { (base * base + g * g).sqrt() + g });
            mode.push(k as i64 + 1);
            whirl.push(if k % 2 == 0 { "backward" } else { "forward" }.to_string());
        }
    }
    let orders = Table::new("orders", "Excitation orders")
        .float("speed", "rad/s", "", vec![0.0, 1200.0])
        .float("one", "rad/s", "", vec![0.0, 1200.0])
        .float("two", "rad/s", "", vec![0.0, 2400.0])
        .build()
        .unwrap();
    let crossings = Table::new("crossings", "Critical speeds")
        .float("speed", "rad/s", "", vec![153.0, 300.0, 348.0])
        .float("frequency", "rad/s", "", vec![153.0, 300.0, 348.0])
        .flag("forward", "", vec![true, false, true])
        .build()
        .unwrap();
    let table = Table::new("modes", "Whirl frequencies over speed")
        .float("speed", "rad/s", "spin speed", speed)
        .float("frequency", "rad/s", "whirl frequency", frequency)
        .int("mode", "", "number", mode)
        .text("whirl", "direction", whirl)
        .build()
        .unwrap();
    let order = |y: &str, name: &'static str| Line::new("orders", "speed", y).reference().name(name);
    let figure = Figure::new(
        "campbell",
        "Campbell diagram",
        "Six whirl frequencies over speed; the 1× line crosses two forward modes in the range.",
    )
    .x(Axis::new("speed", "rpm").factor(RPM))
    .panel(
        Panel::new(Axis::new("whirl frequency", "Hz").factor(0.5 / PI))
            .mark(Line::new("modes", "speed", "frequency").group("mode"))
            .mark(order("one", "1×"))
            .mark(order("two", "2×"))
            .mark(Points::new("crossings", "speed", "frequency").filled_where("forward").name("critical speed"))
            .mark(Rule::x(153.0, "1st forward"))
            .mark(Rule::x(190.0, "standstill of the balancer"))
            .mark(Rule::x(200.0, "x"))
            .mark(Rule::x(1180.0, "overspeed limit"))
            .mark(Rule::y(314.0, "50 Hz mains"))
            .mark(Rule::y(316.0, "gear mesh")),
    );
    Outcome::new("campbell", "campbell")
        .finding(Finding::info("first_critical_speed", "The first forward critical speed is {}.").value(153.0, "rad/s").evidence(
            "difference from 8 more elements",
            2.1e-6,
            "rad/s",
        ))
        .table(table)
        .table(orders)
        .table(crossings)
        .figure(figure)
        .checked()
        .unwrap()
}

fn stability_map() -> Outcome {
    let (mut speed, mut fill, mut growth) = (vec![], vec![], vec![]);
    for i in 0..80 {
        for j in 0..50 {
            let (w, f) = (100.0 + i as f64 * 10.0, 0.02 + j as f64 * 0.0196);
            speed.push(w);
            fill.push(f);
            let island = (-((w - 520.0 - 160.0 * f) / (60.0 + 160.0 * f)).powi(2)).exp() * (PI * f).sin();
            growth.push(if i > 70 && j > 44 { f64::NAN } else { 42.0 * island - 11.0 - 0.12 * (w - 300.0).max(0.0) * (1.0 - island) });
        }
    }
    let table = Table::new("map", "Growth rate of the least stable motion")
        .float("speed", "rad/s", "", speed)
        .float("fill", "", "", fill)
        .float("growth_rate", "1/s", "", growth)
        .build()
        .unwrap();
    let heat = Heat::new("map", "speed", "fill", "growth_rate", Axis::new("growth rate", "1/s")).diverging().contour(0.0);
    let figure =
        Figure::new("map", "Stability of the partly filled drum", "An unstable island lies between 500 and 700 rad/s at medium filling.")
            .x(Axis::new("speed", "rad/s"))
            .panel(
                Panel::new(Axis::new("filled part of the cavity", ""))
                    .mark(heat)
                    .mark(Text::new(600.0, 0.5, "unstable"))
                    .mark(Rule::x(628.3, "6000 rpm")),
            );
    Outcome::new("stability_map", "stability")
        .finding(Finding::warning("unstable", "The filled drum is unstable in a window of speeds."))
        .table(table)
        .figure(figure)
        .checked()
        .unwrap()
}

fn history() -> Outcome {
    let n = 20_000;
    let t: Vec<f64> = (0..n).map(|i| i as f64 * 1e-3).collect();
    let wave = |t: f64| {
        let w = 25.0 * t;
        let detune = (w - 250.0) / 22.0;
        4e-4 / (1.0 + detune * detune).sqrt() * (0.5 * 25.0 * t * t).sin() + 6e-6 * (0.02 * 777.0 * t).cos()
    };
    let x: Vec<f64> = t.iter().map(|t| wave(*t)).collect();
    let force: Vec<f64> = x.iter().map(|x| 1e6 * x.abs() + 1e-3).collect();
    let orbit: Vec<f64> = t.iter().map(|t| wave(t + 0.004)).collect();
    let table = Table::new("history", "Motion during run up")
        .float("t", "s", "time", t)
        .float("x", "m", "displacement of the drum", x)
        .float("force", "N", "bearing force", force)
        .float("y", "m", "", orbit)
        .build()
        .unwrap();
    let run = Figure::new("run-up", "Run up through resonance", "The displacement swells near 10 s and decays after it.")
        .x(Axis::new("time", "s"))
        .panel(Panel::new(Axis::new("displacement x", "m")).mark(Line::new("history", "t", "x")))
        .panel(Panel::new(Axis::log("bearing force", "N")).mark(Line::new("history", "t", "force")));
    let orbit = Figure::new("orbit", "Orbit", "The orbit is close to an ellipse.")
        .x(Axis::new("x", "mm").factor(1e3))
        .panel(Panel::new(Axis::new("y", "mm").factor(1e3)).mark(Points::new("history", "x", "y").name("samples")));
    let turning = Table::new("animation", "Frames")
        .float("t", "s", "", (0..50).map(|i| 0.02 * f64::from(i)).collect())
        .float("phase", "rad", "", (0..50).map(|i| 3.0 * f64::from(i)).collect())
        .float("disc.x", "m", "", (0..50).map(|i| 1e-5 * f64::from(i)).collect())
        .float("disc.y", "m", "", vec![2e-5; 50])
        .float("ball.x", "m", "", (0..50).map(|i| 0.1 * (0.05 * f64::from(i)).cos()).collect())
        .float("ball.y", "m", "", (0..50).map(|i| 0.1 * (0.05 * f64::from(i)).sin()).collect())
        .build()
        .unwrap();
    let pair = |name: &str| [format!("{name}.x"), format!("{name}.y")];
    let circle = |name: &'static str, place: Option<[String; 2]>, radius: f64| Circle {
        name: name.into(),
        displacement: pair("disc"),
        movable: place.is_some(),
        place,
        radius,
    };
    let played = Animation {
        name: "motion".into(),
        title: "Rotor <b>".into(),
        alt: "A ball creeps along its track.".into(),
        table: "animation".into(),
        time: "t".into(),
        phase: "phase".into(),
        enlarged: 50.0,
        circles: vec![circle("disc", None, 0.0), circle("track", None, 0.1), circle("ball", Some(pair("ball")), 0.006)],
    };
    let empty = Table::new("empty", "Nothing").float("x", "", "", vec![f64::NAN]).float("y", "", "", vec![f64::NAN]).build().unwrap();
    Outcome::new("transient", "run up")
        .finding(Finding::info("largest", "The largest displacement is {}.").value(4.06e-4, "m"))
        .table(table)
        .table(empty)
        .table(turning)
        .figure(run)
        .figure(orbit)
        .animation(played)
        .checked()
        .unwrap()
}

const NAME: &str = "<script>alert(1)</script> & \"x\"";

fn report() -> Report {
    Report {
        machine: NAME.into(),
        provenance: Provenance {
            version: "0.1.0".into(),
            input_name: "separator <b>.toml".into(),
            input_hash: "9f86d081884c7d659a2feaa0c55ad015a3bf4f1b2b0b822cd15d6c15b0f00a08".into(),
            settings: vec![("threads".into(), "2".into())],
            seed: Some(1),
            ..Provenance::default()
        },
        input: Some(format!("[machine]\nname = '{NAME}'\nspeed = \"3000 rpm\"\n")),
        outcomes: vec![response(), campbell(), stability_map(), history()],
        ..Report::default()
    }
}

fn browser() -> Option<PathBuf> {
    let paths = std::env::var_os("PATH")?;
    let names = ["chromium", "chromium-browser", "google-chrome"];
    std::env::split_paths(&paths).flat_map(|p| names.map(|n| p.join(n))).find(|p| p.is_file())
}

fn dump(browser: &Path, dir: &Path, page: &Path, width: u32) -> String {
    let out = Command::new(browser)
        .args([
            "--headless",
            "--no-sandbox",
            "--disable-gpu",
            "--disable-quic",
            "--no-first-run",
            "--disable-background-networking",
            "--disable-component-update",
            "--disable-sync",
        ])
        .arg(format!("--user-data-dir={}", dir.join(format!("profile-{width}")).display()))
        .arg(format!("--window-size={width},900"))
        .args(["--virtual-time-budget=20000", "--dump-dom"])
        .arg(format!("file://{}#selfcheck", page.display()))
        .output()
        .expect("the browser starts");
    String::from_utf8_lossy(&out.stdout).into_owned()
}

fn attribute<'a>(dom: &'a str, name: &str) -> &'a str {
    let start = dom.find(&format!(" {name}=\"")).unwrap_or_else(|| panic!("the page's script did not run: no {name}")) + name.len() + 3;
    &dom[start..start + dom[start..].find('"').unwrap()]
}

#[test]
fn opens_without_error_and_draws_every_figure() {
    // a folder of choice keeps the files for looking at them
    let kept = std::env::var_os("LAVAL_REPORT_DIR").map(PathBuf::from);
    let dir = kept.clone().unwrap_or_else(|| std::env::temp_dir().join(format!("laval-browser-{}", std::process::id())));
    let files = write(&dir, &report(), Format::ALL).unwrap();
    let page = dir.join("report.html");
    assert!(files.contains(&page));
    assert!(std::fs::metadata(&page).unwrap().len() < 1_500_000);
    match browser() {
        None => println!("skipped: no Chromium"),
        Some(browser) => {
            for width in [1280, 500] {
                let dom = dump(&browser, &dir, &page, width);
                assert_eq!(attribute(&dom, "data-errors"), "[]", "at width {width}");
                assert_eq!(attribute(&dom, "data-figures"), "5");
                assert_eq!(attribute(&dom, "data-drawn"), "5");
                assert_eq!(attribute(&dom, "data-played"), "1");
                assert_eq!(attribute(&dom, "data-overflow"), "false", "the page scrolls sideways at width {width}");
            }
        }
    }
    if kept.is_none() {
        std::fs::remove_dir_all(&dir).unwrap();
    }
}

#[test]
fn names_from_the_file_are_text_everywhere() {
    let page = html(&report()).unwrap();
    assert!(!page.contains("<script>alert"));
    assert!(!page.contains("separator <b>"));
    assert!(page.contains("<h1>&lt;script&gt;alert(1)&lt;/script&gt; &amp; &quot;x&quot;</h1>"));
}

#[test]
fn nothing_is_fetched_and_the_bytes_repeat() {
    let page = html(&report()).unwrap();
    assert_eq!(page, html(&report()).unwrap());
    for word in ["src=", "url(http", "@import", "<link", "<img", "<iframe"] {
        assert!(!page.contains(word), "{word}");
    }
    let addresses: Vec<_> = page
        .match_indices("http")
        .map(|(i, _)| &page[i..(i + 30).min(page.len())])
        .filter(|a| !a.starts_with("http://www.w3.org/2000/svg") && !a.starts_with("http-equiv"))
        .collect();
    assert!(addresses.is_empty(), "{addresses:?}");
}

/// 5000 rows and 20 columns, all drawn, stay below the limit.
#[test]
fn large_tables_stay_small() {
    let n = 5000;
    let mut b = Table::new("big", "").float("t", "s", "", (0..n).map(|i| i as f64).collect());
    let mut panel = Panel::new(Axis::new("y", "m"));
    for k in 0..20 {
        b = b.float(
            format!("y{k}"),
            "m",
            "",
            (0..n).map(|i| ((i * (k + 3)) as f64 * 0.7).sin() * (i as f64 * 1e-3 + k as f64).cos()).collect(),
        );
        panel = panel.mark(Line::new("big", "t", format!("y{k}")).name(Arg::name(format!("y{k}"))));
    }
    let figure = Figure::new("f", "Big", "").x(Axis::new("t", "s")).panel(panel);
    let outcome = Outcome::new("k", "n").table(b.build().unwrap()).figure(figure).checked().unwrap();
    let page = html(&Report { outcomes: vec![outcome], ..Report::default() }).unwrap();
    assert!(page.len() < 1_500_000, "{}", page.len());
}
