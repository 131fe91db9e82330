//! `laval import ross`.

use crate::launcher::Dir;

const ROTOR: &str = include_str!("../../laval/tests/reference/ross/cones.toml");

#[test]
fn a_saved_rotor_becomes_a_machine_file() {
    let dir = Dir::new("import");
    dir.file("rotor.toml", ROTOR);
    let said = dir.laval(["import", "ross", "rotor.toml"]);
    assert!(
        said.done().starts_with("rotor-machine.toml\nLeft out, or different in ROSS:\n- \"BearingElement_drive end\": kzz, czz left out\n"),
        "{}",
        said.out
    );
    assert!(dir.laval(["check", "rotor-machine.toml"]).done().starts_with("ok: 5 parts, "));
    // never over a file
    dir.laval(["import", "ross", "rotor.toml"]).refused(&["rotor-machine.toml exists and is not overwritten"]);
    let printed = dir.laval(["import", "ross", "rotor.toml", "--out", "-"]);
    assert_eq!((printed.code, printed.out), (0, dir.read("rotor-machine.toml")));
    assert!(printed.err.starts_with("- \""), "{}", printed.err);
    let russian = dir.laval(["import", "ross", "rotor.toml", "--out", "r.toml", "--lang", "ru"]);
    assert!(russian.done().contains("не перенесено: kzz, czz"), "{}", russian.out);
}

#[test]
fn mistakes_stand_at_their_place() {
    let dir = Dir::new("import-wrong");
    dir.file("rotor.toml", ROTOR.replace("m = 15.0\n", ""));
    dir.laval(["import", "ross", "rotor.toml"]).refused(&["rotor.toml:", "error[ross.key]: \"DiskElement_impeller\" has no m"]);
    dir.file("other.toml", "[machine]\nname = \"pump\"\n");
    dir.laval(["import", "ross", "other.toml"]).refused(&["other.toml:1", "elements of the kind \"machine\" are not imported"]);
    dir.laval(["import", "ross", "nowhere.toml"]).refused(&["there is no file nowhere.toml"]);
    dir.laval(["import", "ross"]).refused(&["FILE"]);
}
