//! `docs/parts.md` and `docs/studies.md` say what the registries say. `LAVAL_WRITE_DOCS=1 cargo test -p laval --test program docs` writes them anew.

use laval::file::{catalog, docs};
use std::path::Path;

fn page(name: &str, title: &str, intro: &str, kinds: &[laval::model::field::KindInfo], what: &str) {
    let mut text = format!("# {title}\n\n{intro}\n\n");
    for k in kinds {
        text.push_str(&format!("- [{}](#{})\n", k.kind, k.kind));
    }
    for k in kinds {
        text.push('\n');
        text.push_str(docs::markdown(what, k).trim_end());
        text.push('\n');
    }
    current(name, &text);
}

/// The page is this text; or becomes it.
pub fn current(name: &str, text: &str) {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../docs").join(name);
    if std::env::var_os("LAVAL_WRITE_DOCS").is_some() {
        std::fs::write(&path, text).unwrap();
    }
    let found = std::fs::read_to_string(&path).unwrap_or_default().replace('\r', "");
    assert!(found == text, "docs/{name} is not what the registry says: run LAVAL_WRITE_DOCS=1 cargo test -p laval --test program docs");
}

#[test]
fn pages_of_parts_and_studies_are_current() {
    let c = catalog();
    let intro = "Every key of every kind of part, as `laval parts KIND` prints it. Values with a unit are strings (`\"70 mm\"`); bare numbers are SI.";
    page("parts.md", "Parts", intro, &c.parts, "part");
    let intro = "Every key of every kind of study, as `laval studies KIND` prints it.\n\n\
         The same file gives the same bytes from the same build on the same processor, for any number of threads. Between processor levels (`processor` in `results.json`: base, avx2,\n\
         avx512) dense linear algebra sums in another order: values of the linear studies (`modes`, `campbell`, `critical_speeds`, `stability_map`, `forced_response`) were found to\n\
         differ by 1e-15 to 2e-11 of their size, and places of peaks by 2e-9, because there a curve is flat; residuals, and what is zero up to rounding, differ altogether. Modes and critical speeds that are equal within 1e-9 stand in the order forward, mixed, backward, not in that of their last digits.";
    page("studies.md", "Studies", intro, &c.studies, "study");
    let mut text = String::from(
        "# Separation, limits, operation and report\n\nBlocks of a machine file beside its parts. The studies [separation](studies.md#separation) and [operating_window](studies.md#operating_window) read `[[cup]]`,\n\
         `[suspension]` and `[limits]`; cups that a body carries are in the machine of every study. The first page of the [report](reading-a-report.md) reads `[limits]` and `[operation]`;\n\
         `[report]` chooses its language and units. `[[cup]]` may stand several times, each with a kind; the other blocks stand once.\n",
    );
    for block in &c.blocks {
        let brackets = if block.several { format!("[[{}]]", block.word) } else { format!("[{}]", block.word) };
        text.push_str(&format!("\n# `{brackets}`\n"));
        for kind in &block.kinds {
            text.push('\n');
            text.push_str(docs::markdown(block.word, kind).trim_end());
            text.push('\n');
        }
    }
    current("separation-blocks.md", &text);
}

#[test]
fn page_of_units_is_current() {
    let text = docs::units_page();
    current("units.md", &text);
    // every unit of the page is read, and is what the page says
    for line in text.split("## Quantities").next().unwrap().lines().filter(|l| l.starts_with("| `")) {
        let cells: Vec<&str> = line.split('|').map(str::trim).collect();
        let unit = laval::units::parse_unit(cells[1].trim_matches('`')).unwrap();
        let number: f64 = cells[2].split([' ', ',']).next().unwrap().parse().unwrap();
        assert!((unit.factor() / number - 1.0).abs() < 1e-14, "{line}");
    }
    for (si, words, usual) in laval::units::quantities() {
        for word in usual.split(", ").filter(|u| !u.starts_with(|c: char| c.is_ascii_digit()) || u.starts_with("1/")) {
            assert!(laval::units::read_quantity(&format!("1 {word}"), si).is_ok(), "{words}: {word}");
        }
    }
}

/// What a part adds to the machine that can be named: its coordinates and internal states.
fn named(kind: &laval::model::field::KindInfo) -> Option<(Vec<String>, Vec<String>)> {
    let body =
        |name: &str| format!("[[part]]\nkind = \"disc\"\nname = \"{name}\"\nmass = 1\ndiametral_inertia = 0.01\npolar_inertia = 0.015\n");
    // optional keys are remarks in an example; a disc tilts only with them
    let own =
        if kind.kind == "disc" { body("the part") } else { docs::every_key("part", kind).replacen('\n', "\nname = \"the part\"\n", 2) };
    let own = own.replacen("[[part]]\nname = \"the part\"\n", "[[part]]\n", 1);
    // the usual radius of an example is that of the cavity itself
    let fill = |l: &str| if l.starts_with("fill =") { "fill = { volume_fraction = 0.5 }".to_string() } else { l.to_string() };
    let own: String = own.lines().map(|l| fill(l) + "\n").collect();
    let text = format!("[machine]\nspeed = \"100 rad/s\"\n{}{}{own}", body("drum"), body("base"));
    let loaded = laval::file::load(&text).ok()?;
    let slot = loaded.system.slots().iter().position(|s| s.name == "the part")?;
    let of = |list: &[laval::model::system::GlobalDof]| {
        list.iter()
            .filter(|c| c.slot == slot)
            .map(|c| format!("{} [{}]", c.name.strip_prefix("the part.").unwrap_or(&c.name), c.dof.unit))
            .collect()
    };
    Some((of(loaded.system.coordinates()), of(loaded.system.states())))
}

#[test]
fn page_of_the_machine_file_is_current() {
    let c = catalog();
    let mut text = String::from(
        "# The machine file\n\nA file is [TOML](https://toml.io): one `[machine]`, then any number of `[[part]]` and `[[study]]` blocks in any order; `[[cup]]` and `[suspension]`\n\
         describe a separation, `[limits]` and `[operation]` what the machine must keep to and at which speeds it runs, `[report]` language and units ([pages](separation-blocks.md)). Each part has\n\
         a `kind` ([parts](parts.md)) and may have a `name`, by which others attach to it; each study has a `kind` ([studies](studies.md)) and may have a `name`,\n\
         which becomes its folder of results. Without a name a block is called after its kind, then kind-2, kind-3 ...\n\n\
         Values with a unit ([all units](units.md)) are texts (`\"70 mm\"`, `\"3000 rpm\"`, `\"1.1e7 N/m\"`, `\"30 g mm\"`); a bare number is in SI units. A constant that may differ in\n\
         the two lateral directions is one value or `{ x = .., y = .. }`. `laval check FILE` says all that is wrong at once, each mistake once and\n\
         at its place, and which studies this machine cannot answer. Errors caused by an earlier error are not reported separately. Syntax errors are\n\
         reported first; the other checks run once the file parses.\n\n",
    );
    text.push_str(docs::markdown("machine", &docs::machine()).replacen("## `machine`", "## `[machine]`", 1).trim_end());
    text.push_str(
        "\n\nA vertical axis is the default: weight then acts along the shaft and bends nothing. A horizontal machine sags under its weight, and motions are\n\
         measured from there.\n\n## Names of coordinates and states\n\nThe keys `initial` and `kick` of the studies in time name a coordinate as `\"part.coordinate\"`, its rate with a mark\n\
         (`\"drum.x'\"`), an internal state as `\"part.state\"`:\n\n```toml\ninitial = { \"drum.x\" = \"0.1 mm\", \"drum.x'\" = \"20 mm/s\" }\nkick = { \"drum.y'\" = \"0.1 m/s\" }\n```\n\n\
         Displacements are counted from the undeflected place; what is not named starts at rest.\n\n| kind | coordinates | internal states |\n| --- | --- | --- |\n",
    );
    let mut seen = Vec::new();
    for kind in &c.parts {
        // an example of required keys alone is not always a whole part
        let Some((coordinates, states)) = named(kind).filter(|n| !n.0.is_empty() || !n.1.is_empty()) else { continue };
        seen.push(kind.kind);
        // the nodes of a shaft have the same coordinates: those of the first stand for all
        let further = |n: &&String| n.starts_with("node_") && !n.starts_with("node_1.");
        let cell = |list: &[String]| {
            let all = if list.iter().any(|n| further(&n)) { ", and the same of `node_2`, `node_3` ..." } else { "" };
            list.iter()
                .filter(|n| !further(n))
                .map(|n| format!("`{}`", n.replace(" [", "` [").trim_end_matches('`')))
                .collect::<Vec<_>>()
                .join(", ")
                .replace("]`", "]")
                + all
        };
        text.push_str(&format!("| `{}` | {} | {} |\n", kind.kind, cell(&coordinates), cell(&states)));
    }
    assert_eq!(seen, ["disc", "foundation", "shaft", "liquid", "balancer_ball"], "the kinds with coordinates or states of their own");
    text.push_str("\nA disc has tilts when it is given a `diametral_inertia`, and no coordinates of its own when it stands `on` a shaft; a shaft has four for each node, numbered from its lower end; a ball balancer has an angle for each ball and `tilt` (`tilt_1`, `tilt_2` ... of several tracks) for each\n\
         ring that is `free`. All other parts join bodies and have none of their own.\n");
    current("machine-file.md", &text);
}
