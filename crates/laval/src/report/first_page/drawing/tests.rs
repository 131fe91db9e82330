use super::*;

fn body(name: &str, rotor: bool, place: f64) -> Block {
    Block::Body {
        name: name.into(),
        rotor,
        flexible: false,
        labels: vec![Arg::quantity(2.0, "kg")],
        grounded: Joint { elastic: !rotor, damped: false, gap: false },
        cavity: None,
        profile: Vec::new(),
        place,
        axis: [0.0; 2],
    }
}

fn link(name: &str, ends: [Option<(&str, f64)>; 2], joint: Joint) -> Block {
    let ends = ends.map(|e| e.map(|(b, z)| (b.to_string(), z)));
    Block::Link { name: name.into(), kind: "part", ends, labels: vec![Arg::quantity(1e6, "N/m"), Arg::quantity(30.0, "N s/m")], joint }
}

const SPRING: Joint = Joint { elastic: true, damped: false, gap: false };
const DAMPER: Joint = Joint { elastic: false, damped: true, gap: false };

fn page(machine: Vec<Block>, horizontal: bool) -> String {
    drawing(&Overview { machine, horizontal, ..Overview::default() }, &Style::default())
}

/// Places and texts of all labels.
fn texts(svg: &str) -> Vec<(f64, f64, String)> {
    let number =
        |tag: &str, name: &str| -> f64 { tag.split(&format!(" {name}=\"")).nth(1).unwrap().split('"').next().unwrap().parse().unwrap() };
    let one = |t: &str| {
        let (tag, rest) = t.split_once('>').unwrap();
        (number(tag, "x"), number(tag, "y"), rest.split('<').next().unwrap().to_string())
    };
    svg.split("<text").skip(1).map(one).collect()
}

/// Twelve bodies on long names: every word is there, none upon another, all within the drawing.
#[test]
fn every_label_is_whole_and_none_lies_upon_another() {
    let long = "сепаратор с самоочищающимся барабаном и гидравлическим приводом";
    let mut machine: Vec<Block> = (0..12).map(|k| body(&format!("body {k} {long}"), k < 9, -0.1 * f64::from(k))).collect();
    for k in 0..11 {
        let ends = [Some((k, 0.0)), Some((k + 1, 0.0))].map(|e| e.map(|(k, z)| (format!("body {k} {long}"), z)));
        machine.push(Block::Link { name: format!("link {k} {long}"), kind: "part", ends, labels: Vec::new(), joint: SPRING });
    }
    for horizontal in [false, true] {
        let svg = page(machine.clone(), horizontal);
        let all = texts(&svg);
        let said: String = all.iter().map(|t| t.2.replace(' ', "")).collect();
        for k in 0..12 {
            assert!(said.contains(&format!("body{k}{}", long.replace(' ', ""))), "{horizontal} {k}");
        }
        let height: f64 = svg.split("viewBox=\"0 0 372 ").nth(1).unwrap().split('"').next().unwrap().parse().unwrap();
        for (i, a) in all.iter().enumerate() {
            let wide = super::super::super::text::width(&a.2, 11.5);
            assert!(a.0 >= 0.0 && a.1 <= height, "{a:?} of {height}");
            assert!(a.2.len() <= 2 || a.0 + wide <= WIDTH + 1.0, "{a:?} {wide}");
            for b in all[..i].iter().filter(|b| b.2.len() > 2 && a.2.len() > 2) {
                assert!((a.1 - b.1).abs() > 10.0, "{a:?} {b:?}");
            }
        }
    }
}

/// A damper is a piston in a cylinder, a spring a zigzag, both stand side by side; a gap has two plates.
#[test]
fn parts_have_their_signs() {
    let draw = |joint: Joint| page(vec![body("disc", true, 0.0), link("l", [Some(("disc", 0.0)), None], joint)], false);
    let signs = |svg: &str| -> Vec<String> {
        svg.split("<path class=\"spr\" d=\"").skip(1).map(|p| p.split('"').next().unwrap().to_string()).collect()
    };
    let zigzag = |d: &str| d.matches('L').count() > 5;
    let piston = |d: &str| d.matches('H').count() == 2 && !d.contains('L');
    let found = signs(&draw(SPRING));
    assert!(found.len() == 1 && zigzag(&found[0]));
    let found = signs(&draw(DAMPER));
    assert!(found.len() == 1 && piston(&found[0]), "{found:?}");
    let found = signs(&draw(Joint { damped: true, ..SPRING }));
    assert!(found.len() == 2 && zigzag(&found[0]) && piston(&found[1]));
    let found = signs(&draw(Joint { gap: true, ..SPRING }));
    assert!(found.len() == 1 && zigzag(&found[0]) && found[0].matches('H').count() == 2);
}

/// Of a machine that lies the supports stand along the axis in the order and in proportion to their places.
#[test]
fn a_lying_rotor_has_its_supports_in_their_places() {
    let machine = vec![
        body("wheel", true, 0.0),
        link("front", [Some(("wheel", -0.1)), None], SPRING),
        link("rear", [Some(("wheel", -0.5)), None], SPRING),
    ];
    let svg = page(machine, true);
    let start = |d: &str| -> f64 { d[1..].split(' ').next().unwrap().parse().unwrap() };
    let xs: Vec<f64> = svg.split("<path class=\"spr\" d=\"").skip(1).map(start).collect();
    let wheel = svg.split("<rect class=\"steel\"").nth(2).unwrap();
    let x: f64 = wheel.split("x=\"").nth(1).unwrap().split('"').next().unwrap().parse().unwrap();
    let wheel = x + 11.0;
    assert!(xs.len() == 2 && xs[1] < xs[0] && xs[0] < wheel, "{xs:?} {wheel}");
    assert!(((wheel - xs[0]) / (wheel - xs[1]) - 0.2).abs() < 0.02, "{xs:?} {wheel}");
}

#[test]
fn balls_are_drawn_in_their_body() {
    let balls = Block::Balls { name: "ring".into(), body: "disc".into(), count: 3, tracks: 2, labels: Vec::new() };
    for horizontal in [false, true] {
        let svg = page(vec![body("disc", true, 0.0), balls.clone()], horizontal);
        // two tracks, each cut twice
        assert_eq!(svg.matches("class=\"ballk\"").count(), 4);
        assert!(svg.contains("3 balls") && svg.contains(">ring<"));
    }
}

/// Horizontal and vertical extent of a path of absolute and relative strokes, as the signs use them.
fn extent(d: &str) -> [f64; 4] {
    let mut spaced = String::new();
    for c in d.chars() {
        if c.is_ascii_alphabetic() {
            spaced += &format!(" {c} ");
        } else {
            spaced.push(c);
        }
    }
    let mut words = spaced.split_whitespace();
    let (mut x, mut y, mut out) = (0.0, 0.0, [f64::INFINITY, f64::NEG_INFINITY, f64::INFINITY, f64::NEG_INFINITY]);
    while let Some(command) = words.next() {
        let mut next = || -> f64 { words.next().unwrap().parse().unwrap() };
        match command {
            "M" | "L" => (x, y) = (next(), next()),
            "H" => x = next(),
            "V" => y = next(),
            other => panic!("{other} in {d}"),
        }
        out = [out[0].min(x), out[1].max(x), out[2].min(y), out[3].max(y)];
    }
    out
}

/// Boxes of the bodies: left, right, top, bottom.
fn boxes(svg: &str) -> Vec<[f64; 4]> {
    let one = |t: &str| {
        let number = |name: &str| -> f64 { t.split(&format!(" {name}=\"")).nth(1).unwrap().split('"').next().unwrap().parse().unwrap() };
        [number("x"), number("x") + number("width"), number("y"), number("y") + number("height")]
    };
    ["<rect class=\"steel\"", "<rect class=\"hous\""].iter().flat_map(|c| svg.split(c).skip(1).map(one).collect::<Vec<_>>()).collect()
}

/// Zigzags and pistons stand beside bodies or end at them; none crosses one.
#[test]
fn no_spring_crosses_a_body() {
    let both = Joint { elastic: true, damped: true, gap: false };
    let chain = || {
        let mut m: Vec<Block> = (0..3).map(|k| body(&format!("d{k}"), true, -0.1 * f64::from(k))).collect();
        m.push(link("a", [Some(("d0", 0.0)), Some(("d1", 0.0))], SPRING));
        m.push(link("b", [Some(("d1", 0.0)), Some(("d2", 0.0))], SPRING));
        m.push(link("skipping", [Some(("d0", 0.0)), Some(("d2", 0.0))], both));
        m.push(link("top", [Some(("d0", 0.0)), None], both));
        m.push(link("middle", [Some(("d1", 0.0)), None], SPRING));
        m.push(link("bottom", [Some(("d2", 0.0)), None], both));
        m
    };
    let two_housings = || {
        let mut m = vec![body("wheel", true, 0.0), body("inner", false, 0.0), body("outer", false, 0.0)];
        m.push(link("bearing", [Some(("wheel", 0.0)), Some(("inner", 0.0))], both));
        m.push(link("mount", [Some(("inner", 0.0)), Some(("outer", 0.0))], SPRING));
        m
    };
    for (machine, lying) in [(chain(), false), (chain(), true), (two_housings(), false)] {
        let svg = page(machine, lying);
        let bodies: Vec<[f64; 4]> = boxes(&svg).into_iter().filter(|b| b[3] - b[2] > 15.0).collect();
        assert!(bodies.len() >= 3);
        for d in svg.split("<path class=\"spr\" d=\"").skip(1).map(|p| p.split('"').next().unwrap()) {
            // the strokes that lead to what stands beside the bodies begin at their sides
            if d.matches(['H', 'V', 'L']).count() == 1 {
                continue;
            }
            let s = extent(d);
            for b in &bodies {
                let wide = s[1].min(b[1]) - s[0].max(b[0]);
                let tall = s[3].min(b[3]) - s[2].max(b[2]);
                assert!(wide <= 0.2 || tall <= 0.2, "lying {lying}: {d} crosses {b:?}");
            }
        }
    }
}

#[test]
fn a_liquid_has_its_label() {
    let drum = Block::Body {
        name: "drum".into(),
        rotor: true,
        flexible: false,
        labels: Vec::new(),
        grounded: Joint::default(),
        cavity: Some((0.07, 0.0467, 0.06)),
        profile: Vec::new(),
        place: 0.0,
        axis: [0.0; 2],
    };
    let oil = Block::Liquid { name: "oil <1>".into(), body: "drum".into(), fill: 0.555, density: 880.0 };
    for horizontal in [false, true] {
        let svg = page(vec![drum.clone(), oil.clone()], horizontal);
        let said: Vec<String> = texts(&svg).into_iter().map(|t| t.2).collect();
        assert!(said.iter().any(|t| t == "oil &lt;1&gt;"), "{said:?}");
        assert!(said.iter().any(|t| t == "fill 55.5 %, 880 kg/m³"), "{said:?}");
    }
}

fn shaft(profile: Vec<[f64; 4]>) -> Block {
    match body("shaft", true, 0.0) {
        Block::Body { name, rotor, labels, cavity, place, axis, .. } => {
            Block::Body { name, rotor, flexible: true, labels, grounded: Joint::default(), cavity, profile, place, axis }
        }
        other => other,
    }
}

/// A shaft of given diameters is drawn with its steps: their heights are to each other as the diameters, and lengths are to them as in the machine.
#[test]
fn a_shaft_is_drawn_with_its_diameters() {
    let steps = vec![[0.0, 0.1, 0.04, 0.04], [0.1, 0.5, 0.08, 0.08], [0.5, 0.6, 0.04, 0.02]];
    let blocks =
        vec![shaft(steps), link("left", [Some(("shaft", 0.0)), None], SPRING), link("right", [Some(("shaft", 0.6)), None], SPRING)];
    let svg = page(blocks, true);
    let outline = svg.split("<path class=\"steel\" d=\"").nth(1).expect("an outline").split('"').next().unwrap();
    let points: Vec<(f64, f64)> = outline
        .trim_end_matches('Z')
        .split(['M', 'L'])
        .filter(|p| !p.is_empty())
        .map(|p| p.split_once(' ').unwrap())
        .map(|(x, y)| (x.parse().unwrap(), y.parse().unwrap()))
        .collect();
    // up the upper side and back along the lower one
    assert_eq!(points.len(), 12, "{outline}");
    let height = |k: usize| points[11 - k].1 - points[k].1;
    let long = |a: usize, b: usize| points[b].0 - points[a].0;
    for (k, d) in [0.04, 0.04, 0.08, 0.08, 0.04, 0.02].into_iter().enumerate() {
        assert!((height(k) / height(2) - d / 0.08).abs() < 0.03, "{k}: {outline}");
    }
    assert!((long(0, 1) / long(2, 3) - 0.25).abs() < 0.03 && (height(2) / long(2, 3) - 0.2).abs() < 0.03, "{outline}");
    // bearings begin at the surface of the shaft
    let starts: Vec<f64> = svg
        .split("<path class=\"spr\" d=\"M")
        .skip(1)
        .map(|p| p.split(' ').nth(1).unwrap().split('V').next().unwrap().parse().unwrap())
        .collect();
    assert!((starts[0] - points[11].1).abs() < 0.2 && (starts[1] - points[6].1).abs() < 0.2, "{starts:?} {outline}");
    assert_eq!(svg.matches("class=\"steel\"").count(), 1);
}

/// A shaft is the line along the axis, also of a machine that stands: it has a number and no side of its own, and bearings stand at their places.
#[test]
fn a_shaft_is_a_line() {
    let shaft = shaft(Vec::new());
    let blocks = vec![
        shaft,
        body("wheel", true, 0.3),
        link("left", [Some(("shaft", 0.0)), None], SPRING),
        link("right", [Some(("shaft", 0.6)), None], SPRING),
    ];
    let (lying, standing) = (page(blocks.clone(), true), page(blocks, false));
    assert_eq!(lying, standing);
    // the line of the rotor and the wheel
    assert_eq!(lying.matches("class=\"steel\"").count(), 2, "{lying}");
}

/// Shafts side by side: as far apart as their wheels say, which touch; the upper one is held from above, one between two others beside itself.
#[test]
fn parallel_shafts_are_as_far_apart_as_their_wheels() {
    let shaft = |name: &str, axis: [f64; 2]| Block::Body {
        name: name.into(),
        rotor: true,
        flexible: true,
        labels: Vec::new(),
        grounded: Joint::default(),
        cavity: None,
        profile: vec![[0.0, 1.0, 0.05, 0.05]],
        place: 0.0,
        axis,
    };
    let wheels = |a: &str, b: &str, radii: [f64; 2]| Block::Wheels {
        name: format!("mesh {b}"),
        ends: [(a.into(), 0.5), (b.into(), 0.5)],
        radii,
        labels: vec![Arg::quantity(2e8, "N/m")],
    };
    let mut machine = vec![shaft("slow", [0.0; 2]), shaft("fast", [0.18, 0.24]), shaft("third", [0.0, -0.3])];
    for k in ["slow", "fast", "third"] {
        machine.push(link(&format!("{k} left"), [Some((k, 0.05)), None], SPRING));
        machine.push(link(&format!("{k} right"), [Some((k, 0.95)), None], SPRING));
    }
    machine.push(wheels("slow", "fast", [0.2, 0.1]));
    machine.push(wheels("slow", "third", [0.2, 0.1]));
    let svg = page(machine, true);
    let number =
        |tag: &str, name: &str| -> f64 { tag.split(&format!(" {name}=\"")).nth(1).unwrap().split('"').next().unwrap().parse().unwrap() };
    let rects: Vec<[f64; 2]> =
        svg.split("<rect class=\"steel\"").skip(1).map(|r| [number(r, "y"), number(r, "y") + number(r, "height")]).collect();
    // two wheels on the slow shaft, one on top of each other, and one on each of the others
    assert_eq!(rects.len(), 4, "{svg}");
    let middle = |r: &[f64; 2]| 0.5 * (r[0] + r[1]);
    let scale = (middle(&rects[0]) - middle(&rects[1])) / 0.3;
    assert!(scale > 200.0 && (middle(&rects[3]) - middle(&rects[2]) - 0.3 * scale).abs() < 0.2, "{rects:?}");
    // they touch, with the radii of the file
    assert!((rects[0][0] - rects[1][1]).abs() < 0.2 && (rects[2][1] - rects[3][0]).abs() < 0.2, "{rects:?}");
    assert!((rects[0][1] - rects[0][0] - 0.4 * scale).abs() < 0.2, "{rects:?}");
    // six supports, none of which begins or ends on an axis of another shaft
    let spans: Vec<(f64, f64)> = svg
        .split("<path class=\"spr\" d=\"")
        .skip(1)
        .map(|p| {
            let d = p.split('"').next().unwrap();
            let from = d[1..].split('V').next().unwrap().split(' ').nth(1).unwrap().parse().unwrap();
            (from, d.rsplit('V').next().unwrap().parse().unwrap())
        })
        .collect();
    assert_eq!(spans.len(), 6);
    for row in [middle(&rects[0]), middle(&rects[1]), middle(&rects[3])] {
        assert!(spans.iter().all(|(a, b)| !(a.min(*b)..a.max(*b)).contains(&row)), "{spans:?} {row}");
    }
}
