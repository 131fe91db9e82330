//! Torques on the spin: what drives it is distinguished from what does not, and what it turns counts once it is in the file.

use laval::file::load;
use laval::outcome::{Data, Finding, Outcome};
use laval::study::Context;

const MOTORLESS: &str = "[machine]\nspeed = \"1000 rpm\"\n\
    [[part]]\nkind = \"disc\"\nname = \"wheel\"\nmass = \"18 kg\"\neccentricity = \"40 um\"\n\
    [[part]]\nkind = \"bearing_linear\"\nbetween = [\"wheel\",\"ground\"]\nkxx = 9e6\nkyy = 9e6\ncxx = 900\ncyy = 900\n\
    [[part]]\nkind = \"liquid\"\nin = \"wheel\"\ncavity_radius = \"150 mm\"\ncavity_height = \"80 mm\"\ndensity = \"1000 kg/m^3\"\n\
    fill = { volume_fraction = 0.1 }\nwave_damping = \"4 1/s\"\n\
    [[study]]\nkind = \"run_up\"\nfrom = \"100 rpm\"\nto = \"2000 rpm\"\nduration = \"0.2 s\"\npoints = 200\n";

pub fn run(text: &str) -> Outcome {
    let loaded = load(text).unwrap_or_else(|d| panic!("{d:?}"));
    loaded.studies[0].study.run(&loaded.system, &Context::quiet("t")).unwrap_or_else(|d| panic!("{d:?}"))
}

pub fn find<'a>(o: &'a Outcome, id: &str) -> Option<&'a Finding> {
    o.findings.iter().find(|f| f.id == id)
}

pub fn value(o: &Outcome, id: &str) -> f64 {
    find(o, id).and_then(|f| f.value).unwrap_or_else(|| panic!("no {id} in {:?}", o.findings))
}

pub fn column(o: &Outcome, table: &str, name: &str) -> Vec<f64> {
    match &o.find_table(table).unwrap().column(name).unwrap_or_else(|| panic!("no {name}")).data {
        Data::Float(v) => v.clone(),
        other => panic!("{other:?}"),
    }
}

/// A liquid supplies power when its waves are damped, and a damper that turns does; neither is a motor.
#[test]
fn a_part_that_supplies_power_is_no_motor() {
    let turning = "[[part]]\nkind = \"damper\"\nbetween = [\"wheel\", \"ground\"]\ndamping = 50\naxes = \"rotating\"\n[[study]]";
    for text in [MOTORLESS.to_string(), MOTORLESS.replacen("[[study]]", turning, 1)] {
        let o = run(&text);
        assert!(find(&o, "drive_short").is_none() && find(&o, "drive_suffices").is_none(), "{:?}", o.findings);
        assert_eq!(find(&o, "largest_torque").unwrap().message.key, "run-up-torque");
        assert!(o.findings.iter().all(|f| !f.sentence().to_lowercase().contains("motor")), "{:?}", o.findings);
        // the wheel has no inertia in the file: what the drive must bring is without it, and that is said
        assert!(find(&o, "spin_inertia").is_some_and(|f| f.sentence().contains("wheel.polar_inertia")), "{:?}", o.findings);
    }
    let o = run(&MOTORLESS.replace("eccentricity", "polar_inertia = \"0.2 kg m^2\"\neccentricity"));
    assert!(find(&o, "spin_inertia").is_none(), "{:?}", o.findings);
    // at constant speed inertia makes no difference
    let (machine, _) = MOTORLESS.split_once("[[study]]").unwrap();
    let still = format!("{machine}[[study]]\nkind = \"transient\"\nspeed = \"2000 rpm\"\nduration = \"0.2 s\"\npoints = 200\n");
    assert!(find(&run(&still), "spin_inertia").is_none());
}

/// Disc, spin load and motor without unbalance: `(J + J1) alpha + c W + k W^2 - T` is the torque beyond the motor.
#[test]
fn torque_of_a_run_up_in_closed_form() {
    let (j, j1, c, k, alpha, w): (f64, f64, f64, f64, f64, f64) = (0.2, 0.3, 0.02, 4e-5, 100.0, 300.0);
    let machine = |motor: &str| {
        format!(
            "[machine]\n[[part]]\nkind = \"disc\"\nname = \"d\"\nmass = 10\npolar_inertia = {j}\n\
             [[part]]\nkind = \"bearing_linear\"\nbetween = [\"d\", \"ground\"]\nkxx = 1e6\nkyy = 1e6\ncxx = 100\ncyy = 100\n\
             [[part]]\nkind = \"spin_load\"\ninertia = {j1}\ndrag = {c}\nwindage = {k}\n{motor}\
             [[study]]\nkind = \"run_up\"\nto = {w}\nduration = {}\npoints = 500\n",
            w / alpha
        )
    };
    // at the last of 500 outputs the speed is held
    let last = w * 498.0 / 499.0;
    let most = (j + j1) * alpha + c * last + k * last * last;
    let alone = run(&machine(""));
    assert!((value(&alone, "largest_torque") / most - 1.0).abs() < 1e-10, "{} {most}", value(&alone, "largest_torque"));
    assert!(find(&alone, "drive_suffices").is_none() && find(&alone, "drive_short").is_none());
    let motor = |torque: f64| run(&machine(&format!("[[part]]\nkind = \"motor\"\ntorque = {torque}\n")));
    // torques are averaged over a fiftieth of the record: at its end over the last hundredth
    let near = 0.01 * most;
    assert!((value(&motor(100.0), "drive_suffices") - (100.0 - most)).abs() < near);
    assert!((value(&motor(50.0), "drive_short") - (most - 50.0)).abs() < near);
    // a motor beside a wheel whose inertia is not known: nothing is said of what it can follow
    let unknown = run(&machine("[[part]]\nkind = \"motor\"\ntorque = 100\n").replace(&format!("polar_inertia = {j}"), ""));
    assert!(find(&unknown, "drive_suffices").is_none() && find(&unknown, "spin_inertia").is_some());
}

/// A run-down against drag and windage without any motor: `W(t) = c W0 E/(c + k W0 (1 - E))`, `E = exp(-c t/J)`.
#[test]
fn run_down_in_closed_form() {
    let (j, c, w0, t): (f64, f64, f64, f64) = (0.5, 0.02, 300.0, 20.0);
    for k in [0.0, 1e-4] {
        let text = format!(
            "[machine]\nspeed = {w0}\ndrive = \"free\"\n[[part]]\nkind = \"disc\"\nname = \"d\"\nmass = 10\npolar_inertia = 0.1\n\
             [[part]]\nkind = \"bearing_linear\"\nbetween = [\"d\", \"ground\"]\nkxx = 1e6\nkyy = 1e6\ncxx = 100\ncyy = 100\n\
             [[part]]\nkind = \"spin_load\"\ninertia = {}\ndrag = {c}\nwindage = {k}\n\
             [[study]]\nkind = \"transient\"\nduration = {t}\npoints = 200\n",
            j - 0.1
        );
        let e = (-c * t / j).exp();
        let expected = c * w0 * e / (c + k * w0 * (1.0 - e));
        let o = run(&text);
        assert!((value(&o, "end_speed") / expected - 1.0).abs() < 1e-7, "{} {expected}", value(&o, "end_speed"));
        assert!(value(&o, "energy_balance") < 1e-7);
        assert!(find(&o, "spin_inertia").is_none());
    }
}
