//! Diagnostics in the languages of the program: the sentences change, code and place do not.

use crate::launcher::Dir;

/// A body that does not exist, in line 8.
const WRONG: &str = r#"[machine]
name = "fan"
[[part]]
kind = "disc"
name = "drum"
mass = "2 kg"
[[part]]
kind = "damper"
between = ["drun", "ground"]
damping = "40 N s/m"
"#;

/// What stands before the sentence: place, severity and code.
fn head(line: &str) -> (String, String) {
    let (place, rest) = line.split_once(": ").unwrap();
    let code = rest.split_once('[').unwrap().1.split_once(']').unwrap().0;
    (place.into(), code.into())
}

#[test]
fn a_mistake_is_said_in_every_language() {
    let dir = Dir::new("languages");
    dir.file("fan.toml", WRONG);
    let said = |more: &[&str]| {
        let said = dir.laval(["check", "fan.toml"].iter().chain(more));
        said.refused(&["[body.missing]"]);
        said.err
    };
    let english = said(&[]);
    let want = "fan.toml:9:11: error[body.missing]: damper \"damper\" is attached to \"drun\", which does not exist\n  help: did you mean \"drum\"? Bodies of this machine: \"drum\", \"ground\"\n";
    assert_eq!(english, want);
    let sentences =
        [("ru", "ошибка", "подсказка", "которого нет"), ("kk", "қате", "кеңес", "денесі жоқ"), ("uz", "xato", "maslahat", "mavjud emas")];
    for (language, error, help, words) in sentences {
        let text = said(&["--lang", language]);
        assert!(text.contains(&format!(" {error}[")) && text.contains(&format!("\n  {help}: ")) && text.contains(words), "{text}");
        assert!(!text.contains("is attached to") && !text.contains("did you mean") && !text.contains("odies of"), "{text}");
        // names, kinds and keys are those of the file
        assert!(["drun", "damper", "\"drum\", \"ground\""].iter().all(|w| text.contains(w)), "{text}");
    }
}

#[test]
fn code_and_place_are_the_same_in_every_language() {
    let dir = Dir::new("same");
    let wrong = WRONG.replace("mass = \"2 kg\"", "mass = \"2 mm\"\neccentrcity = 3").replace("\"40 N s/m\"", "-40");
    dir.file("fan.toml", &wrong);
    let lines = |text: &str| text.lines().filter(|l| l.starts_with("fan.toml:")).map(head).collect::<Vec<_>>();
    let english = lines(&dir.laval(["check", "fan.toml"]).err);
    assert!(english.len() >= 4, "{english:?}");
    for language in ["ru", "kk", "uz"] {
        assert_eq!(lines(&dir.laval(["check", "fan.toml", "--lang", language]).err), english, "{language}");
        assert_eq!(lines(&dir.laval(["run", "fan.toml", "--lang", language]).err), english, "{language}");
    }
    // editors read the same, with sentences in the language that is requested
    let json = |more: &[&str]| -> serde_json::Value {
        let said = dir.laval(["check", "fan.toml", "--json"].iter().chain(more));
        serde_json::from_str(&said.out).unwrap()
    };
    let (plain, russian) = (json(&[]), json(&["--lang", "ru"]));
    let pairs = plain["diagnostics"].as_array().unwrap().iter().zip(russian["diagnostics"].as_array().unwrap());
    assert!(pairs.clone().all(|(a, b)| a["code"] == b["code"] && a["place"] == b["place"] && a["severity"] == b["severity"]));
    assert!(pairs.clone().any(|(a, b)| a["message"] != b["message"]), "{russian:#}");
}

/// The file and the environment choose the language too, the file also where it has mistakes of syntax; the option comes first.
#[test]
fn the_file_and_the_environment_choose_the_language() {
    let dir = Dir::new("chosen");
    dir.file("fan.toml", WRONG);
    let uzbek = dir.command(["check", "fan.toml"]).env("LC_ALL", "uz_UZ.UTF-8").output().unwrap();
    assert!(String::from_utf8(uzbek.stderr).unwrap().contains("xato[body.missing]"));
    dir.file("own.toml", format!("{WRONG}[report]\nlanguage = \"kk\"\n"));
    dir.laval(["check", "own.toml"]).refused(&["қате[body.missing]"]);
    dir.laval(["check", "own.toml", "--lang", "ru"]).refused(&["ошибка[body.missing]"]);
    dir.file("broken.toml", format!("[report]\nlanguage = \"ru\"\n{WRONG}speed 3\n"));
    dir.laval(["check", "broken.toml"]).refused(&["ошибка[toml.syntax]"]);
    dir.command(["check", "none.toml"])
        .env("LC_ALL", "ru_RU.UTF-8")
        .output()
        .map(|o| {
            assert!(String::from_utf8(o.stderr).unwrap().starts_with("ошибка[file.read]"));
        })
        .unwrap();
}
