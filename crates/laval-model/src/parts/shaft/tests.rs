use super::element::{Cone, Element, Layers, Material, Plane, Shear};
use super::*;
use crate::model::params::Listed;
use laval_num::dense::Mat;

fn element(outer: [f64; 2], inner: [f64; 2], cone: Cone) -> Element<f64> {
    let material = Material { modulus: 2.11e11, shear_modulus: 8.12e10, density: 7810.0 };
    Element { length: 0.25, outer, inner, material, shear: Shear::Cowper, cone, layers: Layers::none() }
}

fn far(a: &M4<f64>, b: &M4<f64>) -> f64 {
    let size = a.iter().flatten().fold(0.0f64, |m, x| m.max(x.abs()));
    a.iter().flatten().zip(b.iter().flatten()).fold(0.0, |m, (x, y)| f64::max(m, (x - y).abs() / size))
}

fn furthest(a: &Plane<f64>, b: &Plane<f64>) -> f64 {
    [(&a.mass, &b.mass), (&a.gyroscopic, &b.gyroscopic), (&a.stiffness, &b.stiffness), (&a.axial, &b.axial)]
        .into_iter()
        .map(|(a, b)| far(a, b))
        .fold(0.0, f64::max)
}

/// The closed forms of a uniform element are the integrals over its shape functions, and a cone without taper is that element.
#[test]
fn forms_of_a_uniform_element_agree() {
    for inner in [0.0, 0.03] {
        let closed = element([0.05; 2], [inner; 2], Cone::Flexibility).plane();
        // a taper too small to count that is integrated all the same
        for cone in [Cone::MidSection, Cone::Flexibility] {
            let integrated = element([0.05, 0.05 * (1.0 + 1e-13)], [inner; 2], cone).plane();
            let gap = furthest(&closed, &integrated);
            assert!(gap < 1e-11, "{cone:?}: {gap:e}");
        }
    }
}

/// Displacement and turning as a rigid body need no force; the mass of a translation is that of the metal.
#[test]
fn rigid_motions() {
    for cone in [Cone::MidSection, Cone::Flexibility] {
        for outer in [[0.05; 2], [0.05, 0.08]] {
            let e = element(outer, [0.02; 2], cone);
            let plane = e.plane();
            let (up, turned) = ([1.0, 0.0, 1.0, 0.0], [0.0, 1.0, e.length, 1.0]);
            let size = plane.stiffness[0][0];
            for motion in [up, turned] {
                for row in plane.stiffness {
                    let force: f64 = row.iter().zip(motion).map(|(k, x)| k * x).sum();
                    assert!(force.abs() < 1e-13 * size, "{cone:?} {force:e}");
                }
            }
            let (mass, polar) = e.inertia();
            assert!((form(&up, &plane.mass, &up) / mass - 1.0).abs() < 1e-12);
            // a thin slice leans with half the moment of inertia about the axis
            assert!((form(&turned, &plane.gyroscopic, &turned) / polar - 1.0).abs() < 1e-12);
        }
    }
}

/// Along and about the axis: inertia of a rigid motion, no force against it, and the stiffness of a cone in closed form.
#[test]
fn along_and_about_the_axis() {
    let (l, d): (f64, [f64; 2]) = (0.25, [0.05, 0.08]);
    for (outer, inner, cone) in [([0.05; 2], 0.02, Cone::MidSection), (d, 0.0, Cone::Flexibility), ([0.05; 2], 0.0, Cone::Flexibility)] {
        let e = element(outer, [inner; 2], cone);
        let (mass, polar) = e.inertia();
        for (line, whole) in [(e.axial(), mass), (e.torsional(), polar)] {
            assert!((line.mass.iter().flatten().sum::<f64>() / whole - 1.0).abs() < 1e-12, "{cone:?}");
            assert!(line.stiffness.iter().all(|row| (row[0] + row[1]).abs() < 1e-12 * row[0].abs()));
        }
        // a constant section gives a sixth to the other end
        if outer[0] == outer[1] {
            assert!(
                (e.axial().mass[0][1] / mass - 1.0 / 6.0).abs() < 1e-13 && (e.torsional().mass[0][1] / polar - 1.0 / 6.0).abs() < 1e-13
            );
        }
    }
    let e = element(d, [0.0; 2], Cone::Flexibility);
    let axial = 2.11e11 * PI * d[0] * d[1] / (4.0 * l);
    let torsional = 3.0 * PI * 8.12e10 / (32.0 * l) * (d[1] - d[0]) / (d[0].powi(-3) - d[1].powi(-3));
    let far = |a: f64, b: f64| (a / b - 1.0).abs();
    assert!(far(e.axial().stiffness[0][0], axial) < 1e-5 && far(e.torsional().stiffness[0][0], torsional) < 1e-4);
}

/// A cantilever under a force at its end: bending and shear in closed form, of a cylinder and of a cone.
#[test]
fn deflection_of_a_cantilever() {
    for (outer, bending) in [
        ([0.05; 2], 1.0 / 3.0),
        // int_0^1 (1-t)^2 / (1+t)^4 dt of a cone twice as thick at the free end
        ([0.05, 0.1], 1.0 / 24.0 * 7.0 - 0.25),
    ] {
        let e = element(outer, [0.0; 2], Cone::Flexibility);
        let plane = e.plane();
        let k = Mat::from_fn(2, 2, |i, j| plane.stiffness[i + 2][j + 2]);
        let det = k[(0, 0)] * k[(1, 1)] - k[(0, 1)] * k[(1, 0)];
        let w = k[(1, 1)] / det;
        let (area, second) = e.section(0.0);
        let l = e.length;
        let nu: f64 = 2.11e11 / (2.0 * 8.12e10) - 1.0;
        let kappa = 6.0 * (1.0 + nu) / (7.0 + 6.0 * nu);
        let slide = l / (kappa * 8.12e10 * area) * if outer[0] == outer[1] { 1.0 } else { 0.5 };
        let expected = l.powi(3) * cone_integral(outer, bending) / (2.11e11 * second) + slide;
        assert!((w / expected - 1.0).abs() < 1e-9, "{w} {expected}");
    }
}

/// `int_0^1 (1-t)^2/d(t)^4 dt` with d from 1 to the ratio of the diameters, by a fine sum.
fn cone_integral(outer: [f64; 2], uniform: f64) -> f64 {
    if outer[0] == outer[1] {
        return uniform;
    }
    let n = 20_000;
    let f = |t: f64| (1.0 - t).powi(2) / (1.0 + t * (outer[1] / outer[0] - 1.0)).powi(4);
    let h = 1.0 / n as f64;
    (0..n).map(|k| k as f64 * h).map(|t| h / 6.0 * (f(t) + 4.0 * f(t + 0.5 * h) + f(t + h))).sum()
}

pub(super) fn shaft() -> Shaft {
    Shaft::new(&[0.1, 0.2, 0.05], &[0.04, 0.05, 0.06]).elements(1)
}

pub(super) type Given = Listed<Listed<ShaftParams, SectionParams>, LayerParams>;
/// With the parameters of [`layers`].
pub(super) fn layered(own: ShaftParams) -> Given {
    let steel = LayerParams::new(0.055, 0.04);
    let bronze = LayerParams { modulus: 1.1e11, shear_modulus: 4e10, density: 8800.0, stiffness: 0.4, ..LayerParams::new(0.1, 0.08) };
    Listed { rows: vec![steel, bronze], ..params(own) }
}
pub(super) fn params(own: ShaftParams) -> Given {
    let section = SectionParams::new;
    let rows = vec![
        section(0.04),
        SectionParams { inner_diameter: 0.02, end_outer_diameter: 0.07, ..section(0.05) },
        SectionParams { end_outer_diameter: 0.05, inner_diameter: 0.01, end_inner_diameter: 0.02, ..section(0.06) },
    ];
    Listed { own, rows }.into()
}

/// Sections are varied by their number and name, lists by their length.
#[test]
fn parameters_of_sections_are_named() {
    let p = params(ShaftParams::new());
    let system = crate::model::builder::Builder::new("s").part("shaft", shaft(), p).build().unwrap_or_else(|d| panic!("{d:?}"));
    let at = system.param("shaft.section[2].end_outer_diameter").unwrap();
    assert_eq!(at.iter().map(|&i| system.params()[i]).collect::<Vec<_>>(), [0.07]);
    let thicker = system.with(&[("shaft.section[1].outer_diameter", 0.045)]).unwrap_or_else(|d| panic!("{d:?}"));
    assert_eq!(thicker.params()[thicker.param("shaft.section[1].outer_diameter").unwrap()[0]], 0.045);
    assert!(system.with(&[("shaft.section[1].outer_diameter", -0.045)]).is_err());
    assert!(system.with(&[("shaft.section[4].outer_diameter", 0.045)]).is_err());
    assert_eq!(system.coordinates()[5].name, "shaft.node_2.y");
}

/// What is attached between nodes moves with the shape functions, and gets a node where it is.
#[test]
fn attached_parts_get_nodes() {
    use crate::model::field::Attach;
    use crate::model::part::Link;
    use crate::parts::{bearing_cubic::*, disc::*};
    let law = BearingCubicParams { stiffness: [1e7; 2], cubic_stiffness: [0.0; 2], valid_to: 0.0 };
    let bearing = |z: f64| BearingCubic::isotropic(Link::Between(Attach::at("shaft", z), Attach::ground()));
    let built = |z: f64| {
        let disc = Disc::tilting().on(Attach::at("shaft", 0.2));
        let inertia = DiscParams { diametral_inertia: 0.01, polar_inertia: 0.02, ..DiscParams::new(2.0) };
        let b = crate::model::builder::Builder::new("s").part("disc", disc, inertia).part("lower", bearing(0.0), law);
        b.part("upper", bearing(z), law).part("shaft", shaft(), params(ShaftParams::new())).build()
    };
    let system = built(0.33).unwrap_or_else(|d| panic!("{d:?}"));
    let names: Vec<&str> = system.stations().iter().map(|s| s.name.as_str()).collect();
    assert_eq!(names, ["disc", "shaft at 0 m", "shaft at 330 mm"]);
    // ends, two borders, the disc and the upper bearing
    assert_eq!(system.n(), 4 * 6);
    let disc = &system.stations()[0];
    assert_eq!(disc.lateral.first(), system.coordinate("shaft.node_3.x"));
    assert_eq!(disc.tilt.as_ref().unwrap().first(), system.coordinate("shaft.node_3.tilt_x"));
    // heights of the disc are those of a rigid body on the shaft
    let above = system.point(disc.slot, 0.1).unwrap();
    let mut q = vec![0.0; system.n()];
    let x = system.coordinate("shaft.node_3.x").unwrap();
    (q[x], q[x + 3]) = (1e-3, 2e-3);
    assert!((above.of(&q)[0] - 1.2e-3).abs() < 1e-15);
    assert!(built(0.36).is_err_and(|d| d.0.iter().any(|d| d.to_string().contains("reaches from 0 m to 350 mm"))));
}

/// Between nodes a shaft moves as its nodes do: rigidly where they do, and by the cubic of a cantilever where they hold its ends.
#[test]
fn points_between_nodes() {
    let (shaft, p) = (shaft(), params(ShaftParams::new()));
    let nodes = shaft.nodes().unwrap();
    let moved = |z: f64, motion: &dyn Fn(f64) -> [f64; 4]| -> [f64; 4] {
        let q: Vec<f64> = nodes.iter().flat_map(|z| motion(*z)).collect();
        let mut out = [0.0; 4];
        for (q, row) in q.iter().zip(shaft.shape(&p, z)) {
            out.iter_mut().zip(row).for_each(|(o, x)| *o += q * x);
        }
        out
    };
    // x + z beta, y - z alpha
    let rigid = |z: f64| [1.0 + 3.0 * z, 2.0 - 4.0 * z, 4.0, 3.0];
    for z in [0.03, 0.17, 0.34] {
        let (found, expected) = (moved(z, &rigid), rigid(z));
        assert!(found.iter().zip(expected).all(|(a, b)| (a - b).abs() < 1e-12), "{z}: {found:?} {expected:?}");
    }
    // slender and uniform: w = z^2 (3 l - z), in the plane of y with alpha = -dw/dz
    let (l, slender) = (0.35, Shaft::new(&[0.35], &[0.01]).elements(1).shear(Shear::None));
    let one = Listed { own: ShaftParams::new(), rows: vec![SectionParams::new(0.01)] };
    let cubic =
        |z: f64| [z * z * (3.0 * l - z), 2.0 * z * z * (3.0 * l - z), -2.0 * (6.0 * l * z - 3.0 * z * z), 6.0 * l * z - 3.0 * z * z];
    let rows = slender.shape(&one.into(), 0.2);
    let ends: Vec<f64> = [0.0, l].into_iter().flat_map(cubic).collect();
    for k in 0..4 {
        let found: f64 = ends.iter().zip(&rows).map(|(q, row)| q * row[k]).sum();
        assert!((found - cubic(0.2)[k]).abs() < 1e-12, "{k}: {found} {:?}", cubic(0.2));
    }
}

pub(super) fn layers() -> Vec<Layer> {
    vec![Layer { from: 0.02, to: 0.08 }, Layer { from: 0.05, to: 0.3 }]
}

/// A core and a tube of one material are the solid section: E I, mass, rotary inertia, E A and G I to rounding; without shear all matrices.
#[test]
fn two_layers_of_one_material_are_the_solid_section() {
    let whole = element([0.08; 2], [0.02; 2], Cone::Flexibility);
    let tube = |share| Layers::none().with([0.05, 0.08], whole.material, Shear::None, share);
    let slender = |outer: f64, layers| Element { shear: Shear::None, layers, ..element([outer; 2], [0.02; 2], Cone::Flexibility) };
    let (solid, layered) = (slender(0.08, Layers::none()), slender(0.05, tube(1.0)));
    assert!((layered.bending(0.3) / solid.bending(0.3) - 1.0).abs() < 1e-12);
    let ((a, b), (c, d)) = (layered.inertia(), solid.inertia());
    assert!((a / c - 1.0).abs() < 1e-12 && (b / d - 1.0).abs() < 1e-12);
    assert!(furthest(&layered.plane(), &solid.plane()) < 1e-12);
    for cone in [Cone::Flexibility, Cone::MidSection] {
        for (a, b) in [(layered.axial(), solid.axial()), (layered.torsional(), solid.torsional())] {
            assert!(
                (a.stiffness[0][0] / b.stiffness[0][0] - 1.0).abs() < 1e-12 && (a.mass[0][0] / b.mass[0][0] - 1.0).abs() < 1e-12,
                "{cone:?}"
            );
        }
    }
    // conical core under a cylinder, by integration
    let under = |outer: [f64; 2], layers| Element { layers, ..element(outer, [0.0; 2], Cone::Flexibility) };
    let layer = Layers::none().with([0.06, 0.08], whole.material, Shear::Cowper, 1.0);
    let gap = furthest(&under([0.05; 2], layer).plane(), &under([0.05, 0.05 * (1.0 + 1e-13)], layer).plane());
    assert!(gap < 1e-11, "{gap:e}");
    // mass alone
    let heavy = slender(0.05, tube(0.0));
    assert!((heavy.inertia().0 / solid.inertia().0 - 1.0).abs() < 1e-12);
    assert_eq!(heavy.plane().stiffness, slender(0.05, Layers::none()).plane().stiffness);
}

/// With shear the stiffness of a layered element is that of one shear angle: bending and shear in series, `f = L^3/(3 sum E I) + L/(sum kappa G A)` of a cantilever.
#[test]
fn layers_share_one_shear_angle() {
    let bronze = Material { modulus: 1.1e11, shear_modulus: 4e10, density: 8800.0 };
    let own = element([0.05; 2], [0.0; 2], Cone::Flexibility);
    let e = Element { layers: Layers::none().with([0.05, 0.07], bronze, Shear::Cowper, 1.0), ..own };
    let factor = |nu: f64, m: f64| {
        let q = (1.0 + m * m) * (1.0 + m * m);
        6.0 * q * (1.0 + nu) / (q * (7.0 + 6.0 * nu) + m * m * (20.0 + 12.0 * nu))
    };
    let (core, tube) = (own.material, bronze);
    let (area, ring) = (PI / 4.0 * 0.05f64.powi(2), PI / 4.0 * (0.07f64.powi(2) - 0.05f64.powi(2)));
    let (second, outer) = (PI / 64.0 * 0.05f64.powi(4), PI / 64.0 * (0.07f64.powi(4) - 0.05f64.powi(4)));
    let bending = core.modulus * second + tube.modulus * outer;
    let nu = |m: Material<f64>| m.modulus / (2.0 * m.shear_modulus) - 1.0;
    let shear = factor(nu(core), 0.0) * core.shear_modulus * area + factor(nu(tube), 0.05 / 0.07) * tube.shear_modulus * ring;
    let k = e.plane().stiffness;
    let det = k[2][2] * k[3][3] - k[2][3] * k[3][2];
    let flexibility = k[3][3] / det;
    let expected = e.length.powi(3) / (3.0 * bending) + e.length / shear;
    assert!((flexibility / expected - 1.0).abs() < 1e-12, "{flexibility:e} {expected:e}");
}

/// A layer gives the shaft nodes at its ends, and counts between them alone.
#[test]
fn layers_count_between_their_ends() {
    let s = shaft().layers(layers());
    for z in [0.02, 0.08, 0.05, 0.3] {
        assert!(s.mesh.node(z).is_some(), "{z}");
    }
    let p = layered(ShaftParams::new());
    let mass = |s: &Shaft| (0..s.mesh.pieces.len()).map(|k| s.element(&p, k).inertia().0).sum::<f64>();
    let ring = |k: usize, rho: f64| {
        let (at, of) = (layers()[k], p.rows[k]);
        PI / 4.0 * (of.outer_diameter.powi(2) - of.inner_diameter.powi(2)) * (at.to - at.from) * rho
    };
    let more = ring(0, 7850.0) + ring(1, 8800.0);
    assert!(((mass(&s) - mass(&shaft())) / more - 1.0).abs() < 1e-12);
    // and through divisions for attached parts
    let divided = s.divide(&[0.06, 0.2]);
    assert!([0.02, 0.08, 0.05, 0.3, 0.06, 0.2].iter().all(|z| divided.node(*z).is_some()));
}

#[test]
fn mistakes_of_layers_are_reported() {
    let of = |from: f64, to: f64, row: LayerParams| {
        shaft().layers(vec![Layer { from, to }]).check(&Listed { rows: vec![row], ..params(ShaftParams::new()) })
    };
    let through = |inner: f64| of(0.02, 0.08, LayerParams::new(0.055, inner));
    assert!(through(0.04).is_empty() && through(0.05).is_empty());
    let wrong = through(0.03);
    assert!(wrong.len() == 1 && wrong[0].0 == "layer" && wrong[0].1.to_string().contains("overlaps the shaft at"), "{wrong:?}");
    // a lining of the bore
    assert!(of(0.1, 0.3, LayerParams::new(0.02, 0.01)).is_empty());
    use crate::model::field::Value;
    use std::collections::BTreeMap;
    let read = |from: f64, to: f64, inner: f64, stiffness: f64| {
        let (mut values, mut d) = (Values::default(), Diagnostics::default());
        let columns = [("from", from), ("to", to), ("inner_diameter", inner), ("outer_diameter", 0.06), ("stiffness", stiffness)];
        values.set("layer", Value::Columns(BTreeMap::from(columns.map(|(n, x)| (n, vec![x])))), Some(4..9));
        let read = Layer::read(&values, 0.35, &mut d);
        assert!(d.0.iter().all(|d| d.span == Some(4..9)));
        (read.is_some(), d.0.len())
    };
    assert_eq!(read(0.0, 0.35, 0.05, 0.0), (true, 0));
    for wrong in [
        read(0.2, 0.1, 0.05, 1.0),
        read(0.2, 0.4, 0.05, 1.0),
        read(f64::NAN, 0.1, 0.05, 1.0),
        read(0.0, 0.1, 0.07, 1.0),
        read(0.0, 0.1, 0.05, 1.5),
    ] {
        assert_eq!(wrong, (false, 1));
    }
}

/// Millimetres written without their unit are metres.
#[test]
fn a_shaft_of_metres_is_a_remark() {
    let of = |length: f64, diameter: f64| {
        let rows = vec![SectionParams::new(diameter)];
        Shaft::new(&[length], &[diameter]).warnings(&Listed { own: ShaftParams::new(), rows }.into())
    };
    assert!(of(12.0, 0.6).is_empty());
    for wrong in [of(500.0, 0.05), of(0.5, 50.0), of(f64::INFINITY, 0.05)] {
        assert!(wrong.len() == 1 && wrong[0].to_string().contains("in metres"), "{wrong:?}");
    }
}

/// Matrices that were kept are those computed from the parameters, to the last digit; other values, and derivatives, are computed.
#[test]
fn kept_matrices_are_the_computed_ones() {
    use crate::model::erased::D1;
    use crate::model::params::{Family, Parametric};
    fn of<S: Scalar>(shaft: &Shaft, p: &Params<Shaft, S>) -> Vec<Matrices<S>> {
        let mut out = Vec::new();
        shaft.each(p, |k, m| {
            assert_eq!(k, out.len());
            out.push(*m);
        });
        out
    }
    let own = ShaftParams { torque: 2e3, ..ShaftParams::new() };
    let sleeved = shaft().elements(3).coordinates(true, true).layers(layers());
    for (shaft, p) in [(shaft(), params(own)), (shaft().elements(4).cone(Cone::MidSection), params(own)), (sleeved, layered(own))] {
        let prepared = shaft.prepared_for(&p);
        let known = of(&prepared, &p);
        assert_eq!(known, of(&shaft, &p));
        assert!(known.len() == shaft.mesh.pieces.len() && known[0] != known[known.len() - 1]);
        let numbers = <Shaft as Parametric>::Family::to_vec(&p);
        for changed in 0..numbers.len() {
            let mut other = numbers.clone();
            other[changed] += if other[changed] == 0.0 { 0.01 } else { 0.01 * other[changed] };
            let q = shaft.given(&other);
            assert_eq!(of(&prepared, &q), of(&shaft, &q), "{changed}");
            let mut seeded: Vec<D1> = numbers.iter().map(|&x| D1::lift(x)).collect();
            seeded[changed].eps[0] = 1.0;
            let q = shaft.given(&seeded);
            assert_eq!(of(&prepared, &q), of(&shaft, &q), "{changed}");
        }
        // without derivatives the values are those kept
        let plain = shaft.given(&numbers.iter().map(|&x| D1::lift(x)).collect::<Vec<_>>());
        assert!(of(&prepared, &plain).iter().zip(&known).all(|(a, b)| a.plane.mass[0][0] == D1::lift(b.plane.mass[0][0])));
    }
}
