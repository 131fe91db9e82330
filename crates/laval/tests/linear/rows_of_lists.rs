//! Numbers in the rows of lists are parameters: coefficients of a bearing table, unbalances, layers of a shaft, exponentials of a material, the torque of a motor.

use crate::common::files::{load, run_all};
use laval::model::system::System;
use laval::solve::mode_slopes::mode_slopes;
use laval::solve::pencil::Linearised;
use laval::solve::rest::rest;
use laval::study::forced_response::at_speed;
use laval_num::complex::C64;

/// A rotor on a bearing with a table at 200, 400, 700 and 900 rad/s.
fn tabulated(studies: &str) -> String {
    format!(
        "[machine]\nspeed = 480\n[[part]]\nkind = \"disc\"\nname = \"rotor\"\nmass = 12\neccentricity = 2e-5\n\
         [[part]]\nkind = \"bearing_linear\"\nname = \"bearing\"\nbetween = [\"rotor\", \"ground\"]\n\
         table = {{ speed = [200, 400, 700, 900], kxx = [2e6, 3e6, 5e6, 5.5e6], kxy = [1e5, 3e5, 4e5, 7e5], kyx = [-2e5, -3e5, -5e5, -6e5], \
         kyy = [3e6, 3.3e6, 4e6, 6e6], cxx = [900, 800, 600, 550], cyy = [700, 650, 630, 600] }}\n{studies}"
    )
}

/// The oscillating root of largest frequency.
fn fastest(system: &System, speed: f64) -> C64 {
    let modes = Linearised::new(system, &rest(system, speed).unwrap()).unwrap().spectrum().unwrap().modes;
    modes.iter().map(|m| m.value).max_by(|a, b| a.im.total_cmp(&b.im)).unwrap()
}

/// Exact slope of that root over a parameter, and its central difference.
fn slopes(system: &System, path: &str, speed: f64) -> [C64; 2] {
    let at = system.param(path).unwrap_or_else(|| panic!("{path}"));
    let value = system.params()[at[0]];
    let h = 1e-4 * value.abs().max(1e-3);
    let moved = |d: f64| fastest(&system.with(&[(path, value + d)]).unwrap(), speed);
    let difference = (moved(h) - moved(-h)).scale(0.5 / h);
    let exact = mode_slopes(system, &|s| rest(s, speed), fastest(system, speed), None, &[at]).unwrap().unwrap();
    [exact.slopes[0], difference]
}

/// Between the rows two rows beside act with their values and one more on either side by the slopes of the cubic; at the speed of a row it alone.
#[test]
fn roots_move_with_the_rows_of_a_bearing_table() {
    let system = load(&tabulated("")).system;
    let size = |s: C64, path: &str| s.abs() * system.params()[system.param(path).unwrap()[0]].abs();
    let mut acting = 0;
    for row in 1..=4 {
        for name in ["kxx", "kxy", "kyy", "cxx", "cyy"] {
            let path = format!("bearing.table[{row}].{name}");
            for speed in [250.0, 480.0, 840.0] {
                let [exact, difference] = slopes(&system, &path, speed);
                // rounding of the roots over a step of 1e-4
                assert!(size(exact - difference, &path) < 1e-7 * fastest(&system, speed).abs(), "{path} {speed}: {exact:?} {difference:?}");
                acting += usize::from(size(exact, &path) > 1e-3);
            }
            let at_row = slopes(&system, &path, 400.0)[0];
            assert_eq!(size(at_row, &path) > 1e-9, row == 2, "{path}: {at_row:?}");
        }
    }
    assert!(acting > 30, "{acting}");
    // a column that the file leaves out is 0 and can be varied all the same
    assert!(slopes(&system, "bearing.table[2].cxy", 400.0)[0].abs() > 1e-9);
}

/// At its own speed a row is a bearing of constant coefficients.
#[test]
fn a_row_is_the_bearing_at_its_speed() {
    let changed = load(&tabulated("")).system.with(&[("bearing.table[2].kxx", 4.5e6), ("bearing.table[2].cyy", 300.0)]).unwrap();
    let constant = "[machine]\n[[part]]\nkind = \"disc\"\nname = \"rotor\"\nmass = 12\n[[part]]\nkind = \"bearing_linear\"\nname = \"bearing\"\nbetween = [\"rotor\", \"ground\"]\n\
                    kxx = 4.5e6\nkxy = 3e5\nkyx = -3e5\nkyy = 3.3e6\ncxx = 800\ncyy = 300\n";
    let (a, b) = (fastest(&changed, 400.0), fastest(&load(constant).system, 400.0));
    assert!((a - b).abs() < 1e-9 * b.abs(), "{a:?} {b:?}");
}

/// Every study that varies parameters takes rows.
#[test]
fn studies_vary_rows() {
    let studies = "[[study]]\nkind = \"stability_map\"\nspeed = { from = 200, to = 900, points = 20 }\n\
                   parameter = { parameter = \"bearing.table[3].kxy\", from = \"0 N/m\", to = \"2 MN/m\", points = 4 }\n\
                   [[study]]\nkind = \"uncertainty\"\nstudy = { kind = \"modes\", speed = 400 }\nsamples = 16\n\
                   parameters = [{ parameter = \"bearing.table[2].kxx\", distribution = \"normal\", deviation = \"5 %\" }]\n\
                   [[study]]\nkind = \"sensitivity\"\nspeed = { from = 210, to = 890 }\nbars = 30\n";
    let outcomes = run_all(&tabulated(studies));
    assert!(outcomes.iter().all(|o| !o.findings.is_empty()));
    let named = format!("{:?}", outcomes[2].tables);
    assert!(named.contains("bearing.table[2].kxx") && named.contains("bearing.table[3].cxx"), "{named}");
}

/// A row or a coefficient that is not there: at its place, with how many there are or what there is.
#[test]
fn paths_that_name_no_row_are_explained() {
    let map = |path: &str| {
        format!(
            "[[study]]\nkind = \"stability_map\"\nspeed = {{ from = 200, to = 900 }}\nparameter = {{ parameter = \"{path}\", from = 1, to = 2, points = 3 }}\n"
        )
    };
    let refused = |text: String| {
        let all = laval::file::load(&text).map(|_| ()).unwrap_err().0;
        assert_eq!(all.len(), 1, "{all:?}");
        let span = all[0].span.clone().unwrap();
        assert!(text[span.start..span.end].contains("bearing"), "{}", &text[span.start..span.end]);
        format!("{} / {}", all[0].message, all[0].help.as_ref().map_or(String::new(), |h| h.to_string()))
    };
    let beyond = refused(tabulated(&map("bearing.table[9].kxx")));
    assert!(beyond.contains("table of \"bearing\" has 4 rows") && beyond.contains("bearing.table[4].cyy"), "{beyond}");
    let other = refused(tabulated(&map("bearing.table[2].kxz")));
    assert!(other.contains("has no parameter \"table[2].kxz\"") && other.contains("kxx"), "{other}");
    for path in ["bearing.table.2.kxx", "bearing.table", "bearing.table[0].kxx"] {
        let unnumbered = refused(tabulated(&map(path)));
        assert!(unnumbered.contains("\"table\" is a list") && unnumbered.contains("table[1].kxx"), "{unnumbered}");
    }
    let constant = tabulated(&map("bearing.table[1].kxx"));
    let (start, end) = (constant.find("table = {").unwrap(), constant.find(" }\n").unwrap() + 3);
    let without = refused(format!("{}kxx = 1e6\nkyy = 1e6\n{}", &constant[..start], &constant[end..]));
    assert!(without.contains("\"bearing\" is given without table"), "{without}");
    // bounds are those of the column
    let bounds = load(&tabulated("")).system.with(&[("bearing.table[2].kxx", f64::NAN)]);
    assert!(bounds.is_err());
}

/// The response is linear in an unbalance, and turns with its direction.
#[test]
fn unbalances_are_varied_by_their_number() {
    let system = load(
        "[machine]\nspeed = 300\n[[part]]\nkind = \"disc\"\nname = \"rotor\"\nmass = 40\nunbalances = { unbalance = [3e-5, 2e-5], phase = [0.2, 1.4] }\n\
         [[part]]\nkind = \"bearing_linear\"\nname = \"bearing\"\nbetween = [\"rotor\", \"ground\"]\nstiffness = 1.2e7\ndamping = 900\n",
    )
    .system;
    let circle = |changes: &[(&str, f64)]| at_speed(&system.with(changes).unwrap(), 300.0).unwrap().unwrap().circles(0).0;
    let (size, phase) = ("rotor.unbalances[2].unbalance", "rotor.unbalances[2].phase");
    let without = circle(&[(size, 0.0)]);
    let one = circle(&[]) - without;
    assert!(one.abs() > 1e-9);
    assert!((circle(&[(size, 6e-5)]) - without - one.scale(3.0)).abs() < 1e-10 * one.abs());
    assert!((circle(&[(phase, 1.9)]) - without - one * C64::cis(0.5)).abs() < 1e-10 * one.abs());
    assert!(system.with(&[(size, -1e-5)]).is_err());
}

/// Roots of a shaft over its layers, and of a material over its exponentials.
#[test]
fn layers_and_exponentials_have_exact_slopes() {
    let shaft = load(
        "[machine]\n[[part]]\nkind = \"shaft\"\nname = \"shaft\"\nelements = 3\nsection = { length = [0.2, 0.2], outer_diameter = [0.04, 0.05] }\n\
         layer = { from = [0.05, 0.2], to = [0.15, 0.35], outer_diameter = [0.07, 0.08], inner_diameter = [0.04, 0.052], density = [7000, 0], stiffness = [0.5, 1] }\n\
         [[part]]\nkind = \"bearing_linear\"\nname = \"a\"\nbetween = [\"shaft\", \"ground\"]\nstiffness = 1e7\ndamping = 500\n\
         [[part]]\nkind = \"bearing_linear\"\nname = \"b\"\nbetween = [{ body = \"shaft\", at = 0.4 }, \"ground\"]\nkxx = 1e7\nkyy = 1.3e7\ncxx = 500\n",
    )
    .system;
    // of the first bending mode, which no other root is near
    let first = |s: &System| {
        let modes = Linearised::new(s, &rest(s, 200.0).unwrap()).unwrap().spectrum().unwrap().modes;
        modes.iter().map(|m| m.value).filter(|s| s.im > 1.0).min_by(|a, b| a.im.total_cmp(&b.im)).unwrap()
    };
    for path in
        ["layer[1].outer_diameter", "layer[1].density", "layer[1].stiffness", "layer[2].outer_diameter", "section[2].outer_diameter"]
    {
        let path = format!("shaft.{path}");
        let at = shaft.param(&path).unwrap();
        let value = shaft.params()[at[0]];
        let h = 1e-4 * value;
        let moved = |d: f64| first(&shaft.with(&[(&path, value + d)]).unwrap());
        let difference = (moved(h) - moved(-h)).scale(0.5 / h);
        let exact = mode_slopes(&shaft, &|s| rest(s, 200.0), first(&shaft), None, &[at]).unwrap().unwrap().slopes[0];
        assert!((exact - difference).abs() < 1e-5 * exact.abs() && exact.abs() * value > 0.1, "{path}: {exact:?} {difference:?}");
    }
    let material = load(
        "[machine]\n[[part]]\nkind = \"disc\"\nname = \"rotor\"\nmass = 12\n[[part]]\nkind = \"shaft_viscoelastic\"\nname = \"shaft\"\nbetween = [\"rotor\", \"ground\"]\n\
         stiffness = 2e6\nexponentials = { share = [0.1, 0.2], rate = [30, 500] }\n",
    )
    .system;
    for path in ["shaft.exponentials[1].share", "shaft.exponentials[2].share", "shaft.exponentials[2].rate"] {
        let [exact, difference] = slopes(&material, path, 700.0);
        assert!((exact - difference).abs() < 1e-6 * exact.abs() && exact.abs() > 1e-6, "{path}: {exact:?} {difference:?}");
    }
}
