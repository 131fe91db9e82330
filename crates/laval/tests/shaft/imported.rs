//! Models that ROSS has saved, as machine files.

use super::rotors::{held, modes};
use crate::common::files::load;
use laval::diagnostic::Diagnostics;
use laval::import::Imported;
use laval::import::ross::import;
use laval_num::complex::c;

fn bytes(file: &str) -> Vec<u8> {
    let path = format!("{}/tests/reference/ross/{file}", env!("CARGO_MANIFEST_DIR"));
    std::fs::read(&path).unwrap_or_else(|e| panic!("{path}: {e}"))
}

fn imported(file: &str) -> Imported {
    import(&bytes(file), "rotor").unwrap_or_else(|d| panic!("{file}: {d}"))
}

/// File, speed in rad/s, and the lateral eigenvalues of `rotor.run_modal(speed)` of ROSS 3.1.0 with the eight lowest frequencies.
type Known = (&'static str, f64, &'static [(f64, f64)]);
const EIGENVALUES: [Known; 6] = [
    (
        "cones",
        100.0,
        &[
            (-12.59280783234367, 1048.2310175828325),
            (-5.443085865664825, 1082.7117204013036),
            (-57.64402753533075, 1405.864256002782),
            (-58.81030834671961, 1422.707611806003),
            (-274.1236924824683, 2859.2630211809687),
            (-212.24478019940756, 3088.962531810222),
            (-295.72624918455335, 4335.431673300009),
            (-266.947500850259, 4496.370248619805),
        ],
    ),
    (
        "cones",
        314.0,
        &[
            (-11.153605061563455, 1037.8486844965757),
            (-6.7048131757065565, 1091.1302416058631),
            (-55.63524304019184, 1391.0724020798336),
            (-60.953009218438964, 1437.851742521893),
            (-271.2451824631328, 2837.232170915294),
            (-214.80190805195517, 3112.7789140711593),
            (-277.52675038152574, 4227.352254168604),
            (-286.18317145689605, 4610.9647911478905),
        ],
    ),
    (
        "pedestals",
        100.0,
        &[
            (-0.08015660016848303, 120.20554545186657),
            (-0.04432017976214886, 121.49571449015166),
            (-2.378525624596016, 452.1309537559364),
            (-1.2832487760697786, 458.82829009845653),
            (-37.89889575218424, 1385.1137506549467),
            (-40.48204469005046, 1481.0153617611113),
            (-79.3204209976742, 1968.3803240925724),
            (-112.29274010868002, 1979.5407242861388),
        ],
    ),
    (
        "pedestals",
        314.0,
        &[
            (-0.04641104677996921, 119.30770817010901),
            (-0.03256485519982433, 122.78618156452298),
            (-1.3387077593916312, 450.01744133236883),
            (-1.0420265508532718, 463.7652218248198),
            (-19.197887350103723, 1288.4457461812067),
            (-37.39719193575, 1592.4721328666787),
            (-49.6920515855635, 1881.435736909314),
            (-83.33886411658005, 2056.5348793713047),
        ],
    ),
    (
        "damped",
        100.0,
        &[
            (-1.3959446211848805, 99.91052377984434),
            (-0.1669407655028896, 100.3113782612375),
            (-13.681725417246085, 316.201113756259),
            (-5.953433042348705, 320.95050350889557),
            (-66.88561956078155, 807.1226781096117),
            (-51.66189232281175, 833.0794895150875),
            (-128.65919024617054, 1137.6855391521956),
            (-103.01027366030102, 1147.9772104592523),
        ],
    ),
    (
        "damped",
        314.0,
        &[
            (-1.0754080031247946, 101.3188577674042),
            (-0.059048468842193724, 103.07637953547327),
            (-9.855098402840204, 323.057632626304),
            (-2.5098699040344785, 342.24415136183865),
            (-44.50562280686434, 799.0328920761257),
            (-30.975034615183183, 897.4746839010618),
            (-113.15081365266927, 1202.9972058861426),
            (-85.24644081900233, 1240.6789303182898),
        ],
    ),
];

#[test]
fn eigenvalues_are_those_of_ross() {
    for (name, speed, known) in EIGENVALUES {
        let file = format!("{name}.{}", if name == "pedestals" { "json" } else { "toml" });
        let system = load(&imported(&file).text).system;
        let expected: Vec<_> = known.iter().map(|(re, im)| c(*re, *im)).collect();
        let found = modes(&system, speed, 1.001 * known[7].1);
        held(&expected, &found, 1e-8, &format!("{name} at {speed} rad/s"));
        assert_eq!(found.len(), expected.len(), "{name} at {speed} rad/s: {found:?}");
    }
}

/// `compressor_example()` of ROSS 2.3.0 at 300 rad/s: its 36 sleeves have a modulus of 1 psi and stand for masses, which become discs.
#[test]
fn sleeves_of_no_stiffness_are_discs() {
    let known = [
        (-225.49002558008144, 1025.3624137989755),
        (-187.2224804386502, 1045.1372770041721),
        (-239.38219006947577, 2219.191209694087),
        (-234.56672805179448, 2261.745566316885),
        (-596.2689159539118, 3445.3091395585366),
        (-597.7009677818136, 3541.819793575118),
    ];
    let file = imported("compressor.toml");
    let found = modes(&load(&file.text).system, 300.0, 3600.0);
    let expected: Vec<_> = known.iter().map(|(re, im)| c(*re, *im)).collect();
    // a mass in the middle of an element in place of one spread along it: measured 1e-3 of the four lowest and 3.4e-3
    held(&expected[..4], &found, 2e-3, "compressor");
    held(&expected, &found, 5e-3, "compressor");
    assert!(!file.text.contains("layer = [") && file.text.matches("kind = \"disc\"").count() >= 36);
}

/// A shaft with sleeves of bronze and of steel whose stiffness counts, ROSS 2.3.0 at 314 rad/s. Its sleeves have shear angles of their own, so that the models differ; without the stiffness of the
/// sleeves they differ by much more.
#[test]
fn stiffness_of_sleeves_counts() {
    let known = [
        (-2.011196654037989, 652.4352492551269),
        (-1.5186944018177604, 674.0130036485355),
        (-59.43812799770881, 2440.039942450968),
        (-52.77830798882458, 2642.681436754202),
        (-325.39344453636227, 5022.458167566164),
        (-347.62385259813266, 5572.775328218598),
    ];
    let file = imported("sleeves.toml");
    let expected: Vec<_> = known.iter().map(|(re, im)| c(*re, *im)).collect();
    let farthest = |text: &str| {
        let found = modes(&load(text).system, 314.0, 7000.0);
        let away = |e: &laval_num::complex::C64| found.iter().map(|f| (*f - *e).abs() / e.abs()).fold(f64::INFINITY, f64::min);
        expected.iter().map(away).fold(0.0, f64::max)
    };
    let (own, light) = (farthest(&file.text), farthest(&file.text.replace("inner_diameter = ", "stiffness = 0, inner_diameter = ")));
    assert!(own < 3e-3 && light > 10.0 * own, "{own:e} {light:e}");
}

#[test]
fn files_are_as_a_person_writes_them() {
    let text = imported("cones.toml").text;
    assert!(text.starts_with("# From a model of ROSS 3.1.0.\n#\n# - \"BearingElement_drive end\": kzz, czz left out\n"), "{text}");
    let rest = &text[text.find("[machine]").unwrap()..];
    let wanted = r#"[machine]
name = "rotor"
speed = "314 rad/s"
axis = "horizontal"

[[part]]
kind = "shaft"
name = "shaft"
# steel_7810
modulus = "211 GPa"
shear_modulus = "81.2 GPa"
density = "7810 kg/m^3"
mass_damping = "1 1/s"
stiffness_damping = "1 µs"
elements = 1
cone = "mid_section"
section = [
  { length = "100 mm", outer_diameter = "40 mm" },
  { length = "150 mm", outer_diameter = "60 mm", inner_diameter = "20 mm" },
  { length = "150 mm", outer_diameter = "60 mm", inner_diameter = "20 mm" },
  { length = "200 mm", outer_diameter = "60 mm", end_outer_diameter = "50 mm" },
  { length = "100 mm", outer_diameter = "50 mm" },
  { length = "100 mm", outer_diameter = "40 mm" },
]

[[part]]
kind = "disc"
name = "impeller"
on = { body = "shaft", at = "250 mm" }
mass = "15 kg"
polar_inertia = "0.12 kg m^2"
diametral_inertia = "0.08 kg m^2"
"#;
    assert!(rest.starts_with(wanted), "{rest}");
    // equal elements are one section
    let equal = imported("pedestals.json").text;
    for part in [
        "elements = 6\nsection = [\n  { length = \"1.5 m\", outer_diameter = \"50 mm\" },\n]\n",
        "kind = \"foundation\"\nname = \"left pedestal\"\nmass = \"12 kg\"\nstiffness = { x = \"100 MN/m\", y = \"80 MN/m\" }\ndamping = \"1 kN s/m\"\n",
        "name = \"left\"\nbetween = [\"shaft\", \"left pedestal\"]\nbeyond = \"linear\"\ntable = [\n  { speed = \"0 rad/s\", kxx = \"10 MN/m\",",
    ] {
        assert!(equal.contains(part), "{part}: {equal}");
    }
}

/// What is left out is reported, once for each element.
#[test]
fn what_is_left_out_is_reported() {
    let layers = imported("layers.toml");
    let said: Vec<String> = layers.notes.iter().map(ToString::to_string).collect();
    for wanted in [
        "\"BallBearingElement_ball\", \"CylindricalBearing_film\": the coefficients are those in the file, the geometry is left out",
        "\"SealElement_seal\": in effect in all studies; ROSS leaves seals out of run_static",
        "\"SealElement_seal\": seal_leakage left out",
        "\"SealElement_seal\": mxx, myy left out",
        "\"ShaftElement_Shaft Element 4\", \"ShaftElement_Shaft Element 5\": a layer of the shaft, with one shear angle; ROSS gives every layer its own",
        "between the rows of a table ROSS 2 draws a spline, laval a monotone cubic as ROSS 3",
    ] {
        assert!(said.iter().any(|s| s == wanted), "{wanted}: {said:#?}");
    }
    assert!(imported("pedestals.json").notes.iter().any(|n| n.contains("coefficients over frequency are taken over speed")));
    load(&layers.text);
}

fn wrong(text: &str) -> Diagnostics {
    import(text.as_bytes(), "rotor").expect_err(text)
}

/// What the marked place holds, and the message.
#[track_caller]
fn refused(text: &str, place: &str, message: &str) {
    let found = wrong(text);
    let d = &found.0[0];
    let marked = d.span.clone().map(|s| &text[s]).unwrap_or_default();
    assert_eq!(d.message.to_string(), message);
    assert!(marked.contains(place), "{marked}: {found:?}");
}

#[test]
fn mistakes_are_reported_at_their_place() {
    let toml = String::from_utf8(bytes("cones.toml")).unwrap();
    let json = String::from_utf8(bytes("pedestals.json")).unwrap();
    let (impeller, mass) = ("DiskElement_impeller", "m = 15.0\n");
    refused(&toml.replace(mass, ""), impeller, "\"DiskElement_impeller\" has no m");
    refused(&toml.replace(mass, "m = \"x\"\n"), "\"x\"", "m of \"DiskElement_impeller\" must be a finite number, not a text");
    refused(&toml.replace(mass, "m = nan\n"), "nan", "m of \"DiskElement_impeller\" must be a finite number, not a number");
    refused(&toml.replace("[DiskElement_hub]", "[Spring_hub]"), "Spring_hub", "elements of the kind \"Spring\" are not imported");
    let (left, coupling) = ("PointMass_left", "CouplingElement_left");
    refused(&json.replace(left, coupling), coupling, "elements of the kind \"CouplingElement\" are not imported");
    let short = json.replacen("\"L\": 0.25", "\"L\": -1", 1);
    refused(&short, "ShaftElement_Shaft Element 0", "the length of \"ShaftElement_Shaft Element 0\" must be positive");
    let last = toml.replace("n = 5\naxial", "n = 15\naxial");
    refused(&last, "ShaftElement_Shaft Element 5", "no element of the shaft lies between the nodes 5 and 6");
    let hub = toml.replace("n = 6\n", "n = 9\n");
    refused(&hub, "DiskElement_hub", "\"DiskElement_hub\" is at node 9, where neither the shaft nor a point mass is");
    let cut = json.replacen("10000000.0,", "", 1);
    refused(&cut, "BearingElement_left", "\"BearingElement_left\" has 4 values of kxx for 5 speeds");
    let code = |text: &str| wrong(text).0[0].code;
    assert_eq!(code(""), "ross.file");
    assert_eq!(code("[machine]\nname = \"pump\"\n"), "ross.element");
    assert_eq!(code("a = = 1"), "ross.syntax");
    assert_eq!(code("{\"a\": "), "ross.syntax");
    assert_eq!(code("[]"), "ross.syntax");
    assert_eq!(code(&format!("a = {}1{}", "[".repeat(200), "]".repeat(200))), "ross.file");
    assert_eq!(code(&toml.replace(mass, "m = 1e30\n")), "ross.machine");
    assert_eq!(import(&[0xff, 0xfe, 0], "rotor").unwrap_err().0[0].code, "ross.file");
}

/// A file cut off anywhere, or with a value changed, is read or refused.
#[test]
fn damaged_files_are_read_or_refused() {
    for file in ["cones.toml", "pedestals.json", "layers.toml"] {
        let whole = String::from_utf8(bytes(file)).unwrap();
        for end in (0..whole.len()).step_by(whole.len() / 40) {
            let _ = import(&whole.as_bytes()[..end], "rotor");
        }
        for value in ["0", "-1", "1e308", "[]", "[[]]", "{}", "\"\"", "99999999999"] {
            for (k, _) in whole.match_indices("0.0").step_by(7) {
                let _ = import(format!("{}{value}{}", &whole[..k], &whole[k + 3..]).as_bytes(), "rotor");
            }
        }
    }
}

/// A key that no element of its kind has is a mistake of whoever wrote the file by hand: it is listed. What ROSS writes has none.
#[test]
fn keys_that_are_not_read_are_listed() {
    let unread = |i: &Imported| i.notes.iter().map(ToString::to_string).filter(|n| n.contains("not read")).collect::<Vec<_>>();
    for file in ["compressor.toml", "cones.toml", "damped.toml", "layers.toml", "pedestals.json", "sleeves.toml"] {
        assert_eq!(unread(&imported(file)), Vec::<String>::new(), "{file}");
    }
    let material = "material = { name = \"steel\", rho = 7810.0, E = 2.11e11, G_s = 8.12e10 }";
    let text = format!(
        "[parameters]\nrated_w = -500.0\n[ShaftElement_0]\nL = 0.5\nn = 0\nidl = 0.0\nodl = 0.05\n{material}\n\
         [DiskElement_d]\nn = 1\nm = 8.0\nId = 0.1\nIp = 0.2\nmass = 9.0\n[BearingElement_a]\nn = 0\nkxx = 1e7\ncxx = 1e3\nkxxx = 2.0\n"
    );
    let found = import(text.as_bytes(), "rotor").unwrap_or_else(|d| panic!("{d}"));
    let said = unread(&found);
    assert!(said.len() == 2 && said[0].contains("\"mass\"") && said[1].contains("\"kxxx\""), "{said:?}");
    // coefficients in y default to those in x
    let system = load(&found.text).system;
    let value = |name: &str| system.params()[system.param_slots().iter().position(|s| s.name.ends_with(name)).unwrap()];
    assert_eq!([value("kyy"), value("cyy")], [1e7, 1e3]);
    assert!(found.notes.iter().any(|n| n.contains("rated_w left out")) && found.text.starts_with("# From a model of ROSS.\n"));
}
