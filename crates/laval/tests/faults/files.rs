//! Rows that a long study stores, limits on memory.

use crate::common::files::load;
use laval::file;
use laval::outcome::Outcome;
use laval::store::{Keep, Work};
use laval::study::Context;
use std::fs;
use std::path::PathBuf;

struct Folder(PathBuf);

impl Drop for Folder {
    fn drop(&mut self) {
        let _ = fs::remove_dir_all(&self.0);
    }
}

/// One bit of a stored chunk flipped and the manifest gone: the rows are computed again, and the tables are
/// those of the undisturbed study, bit for bit.
#[test]
fn no_flipped_bit_in_the_rows_of_a_map_reaches_its_tables() {
    let text = include_str!("machines/map_of_a_rotor.toml").replace("points = 20", "points = 8");
    let l = load(&text);
    let folder = Folder(std::env::temp_dir().join(format!("laval-map-{}", std::process::id())));
    let _ = fs::remove_dir_all(&folder.0);
    let keep = Keep { folder: folder.0.clone(), input: serde_json::json!({ "machine": 1 }), fresh: false, work: Work::Missing };
    let run = || -> Outcome {
        let context = Context { keep: Some(&keep), ..Context::quiet("map") };
        l.studies[0].study.run(&l.system, &context).unwrap_or_else(|d| panic!("{d:?}"))
    };
    let tables = |o: &Outcome| o.tables.iter().map(laval::report::csv).collect::<Vec<_>>();
    let whole = tables(&run());
    let chunk = folder.0.join("chunk-000000.parquet");
    let sound = fs::read(&chunk).unwrap();
    // multiplicative generator of Lehmer
    let mut seed: usize = 20_241_123;
    for _ in 0..12 {
        seed = seed * 48_271 % 2_147_483_647;
        let mut bytes = sound.clone();
        bytes[seed % sound.len()] ^= 1 << (seed % 8);
        fs::write(&chunk, bytes).unwrap();
        fs::remove_file(folder.0.join("manifest.json")).unwrap();
        assert!(tables(&run()) == whole, "byte {} of {}", seed % sound.len(), sound.len());
        assert!(fs::read(&chunk).unwrap() == sound);
    }
}

/// The states of one part would take a matrix of gigabytes.
#[test]
fn a_machine_that_no_matrix_holds_is_refused() {
    let text = |rows: usize| {
        format!(
            "[machine]\nspeed = 100\n[[part]]\nkind = \"disc\"\nname = \"d\"\nmass = 1\n[[part]]\nkind = \"shaft_viscoelastic\"\n\
             between = [\"d\", \"ground\"]\nstiffness = 1e5\nexponentials = {{ share = [{}], rate = [{}] }}\n",
            "1e-6, ".repeat(rows),
            "10.0, ".repeat(rows)
        )
    };
    let refused = file::load(&text(10_000)).map(drop).unwrap_err();
    assert_eq!(refused.0.iter().map(|d| d.code).collect::<Vec<_>>(), ["machine.size"], "{refused:?}");
    assert!(file::load(&text(10)).is_ok());
}

/// A hundred discs that tilt, a million places of time with velocities: refused before anything is computed,
/// with the size and a way out.
#[test]
fn a_million_rows_of_a_hundred_discs_are_refused() {
    let mut text = String::from("[machine]\nspeed = \"300 rad/s\"\n");
    for k in 0..100 {
        text += &format!(
            "[[part]]\nkind = \"disc\"\nname = \"d{k}\"\nmass = \"1 kg\"\neccentricity = 1e-5\ndiametral_inertia = 0.01\npolar_inertia = 0.01\n\
             [[part]]\nkind = \"shaft_lumped\"\nbetween = [\"d{k}\", \"ground\"]\nstiffness = 1e6\ntilt_stiffness = 1e4\n\
             [[part]]\nkind = \"damper\"\nbetween = [\"d{k}\", \"ground\"]\ndamping = 10\n"
        );
    }
    text += "[[study]]\nkind = \"transient\"\nduration = \"0.01 s\"\npoints = 1000000\nvelocities = true\n";
    let l = load(&text);
    let refused = l.refusals();
    let d = &refused[0].diagnostic;
    // a displacement and a velocity of 400 coordinates take 6.4 GB, before anything else
    assert!(d.code == "request.memory" && d.message.contains("1000000") && d.message.contains("400 coordinates"), "{d:?}");
    assert!(d.help.as_deref().is_some_and(|h| h.contains("fewer points")), "{d:?}");
    assert_eq!(l.studies[0].study.run(&l.system, &Context::quiet("t")).unwrap_err().code, "request.memory");
}
