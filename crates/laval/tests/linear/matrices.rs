//! Matrices as plain arrays: those at one speed, with the speed changed in the sum, are those at another.

use crate::common::files::load;
use laval::solve::matrices::matrices;
use laval::solve::pencil::Linearised;
use laval::solve::rest::rest;

const TILTING: &str = r#"
    machine = { name = "m", speed = "300 rad/s" }
    part = [
        { kind = "disc", name = "disc", mass = "2 kg", polar_inertia = "0.02 kg m^2", diametral_inertia = "0.013 kg m^2" },
        { kind = "bearing_cubic", name = "low", between = [{ body = "disc", at = "-40 mm" }, "ground"], law = "isotropic", stiffness = "1e6 N/m", cubic_stiffness = "1e9 N/m^3" },
        { kind = "shaft_lumped", name = "high", between = [{ body = "disc", at = "70 mm" }, "ground"], stiffness = { x = "1e6 N/m", y = "2e6 N/m" } },
        { kind = "damper", name = "material", axes = "rotating", between = ["disc", "ground"], damping = "40 N s/m" },
    ]
    "#;

#[test]
fn the_speed_enters_as_written() {
    let machine = load(TILTING).system;
    let about = |w: f64| rest(&machine, w).unwrap();
    let m = matrices(&machine, &about(300.0)).unwrap();
    assert_eq!(m.coordinates, ["disc.x", "disc.y", "disc.tilt_x", "disc.tilt_y"]);
    // angular momentum: d/dt (Ip W) of the tilts
    assert!((m.gyroscopic[2][3] - 0.02).abs() < 1e-15 && (m.gyroscopic[3][2] + 0.02).abs() < 1e-15, "{:?}", m.gyroscopic);
    // a damper that turns pushes across: N = c [0 1; -1 0]
    assert!((m.circulatory[0][1] - 40.0).abs() < 1e-12 && (m.circulatory[1][0] + 40.0).abs() < 1e-12, "{:?}", m.circulatory);
    // (a force in y at 70 mm against one at -40 mm)
    let coupling = 1e6 * 0.070 - 1e6 * 0.040;
    assert!((m.stiffness[0][3] - coupling).abs() < 1e-9 * coupling, "{:?}", m.stiffness);
    let n = m.coordinates.len();
    for w in [-500.0, 0.0, 120.0] {
        let own = Linearised::new(&machine, &about(w)).unwrap();
        for i in 0..n {
            for j in 0..n {
                let near = |sum: f64, whole: f64| assert!((sum - whole).abs() <= 1e-12 * (1.0 + whole.abs()), "{w} {i} {j}: {sum} {whole}");
                near(m.mass[i][j], own.mass[(i, j)]);
                near(m.damping[i][j] + w * m.gyroscopic[i][j], own.damping[(i, j)]);
                near(m.stiffness[i][j] + w * m.circulatory[i][j], own.stiffness[(i, j)]);
                // of this machine C and K are symmetric, G and N skew
                near(m.damping[i][j], m.damping[j][i]);
                near(m.stiffness[i][j], m.stiffness[j][i]);
                near(m.gyroscopic[i][j], -m.gyroscopic[j][i]);
                near(m.circulatory[i][j], -m.circulatory[j][i]);
            }
        }
    }
}
