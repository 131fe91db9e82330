//! `laval new`: machine files to start from. They are the examples.

use crate::{DONE, FAILED, WRONG, input, terminal};
use laval::diagnostic::{Diagnostic, meant, nearest};
use laval::text;
use std::fs::{self, File, OpenOptions};
use std::io::{ErrorKind, Write};
use std::path::{Path, PathBuf};

/// A machine file to start from.
pub struct Template {
    /// Its word on the command line.
    pub name: &'static str,
    /// What it is, as a phrase.
    pub about: &'static str,
    /// The file.
    pub text: &'static str,
}

impl Template {
    /// The file, as it stands in a folder of its own under this name.
    fn named(&self, stem: &str) -> String {
        let line = |l: &str| match l {
            l if l.starts_with("#   cargo run ") => format!("#   laval run {stem}.toml\n"),
            l if l.starts_with("# then open out/") => format!("# then open out/{stem}/report.html.\n"),
            l => format!("{l}\n"),
        };
        self.text.lines().map(line).collect()
    }
}

/// All of them, the simplest first.
pub const TEMPLATES: &[Template] = &[
    Template {
        name: "rigid-rotor",
        about: "a rotor on a hardening bearing and a movable foundation",
        text: include_str!("../../../examples/02-rigid-rotor/machine.toml"),
    },
    Template {
        name: "oil-separator",
        about: "the same rotor with a cavity partly filled with liquid",
        text: include_str!("../../../examples/01-oil-separator/machine.toml"),
    },
    Template {
        name: "overhung-disc",
        about: "a disc that tilts, with gyroscopic coupling, outboard of its bearings",
        text: include_str!("../../../examples/03-overhung-disc/machine.toml"),
    },
    Template {
        name: "ball-balancer",
        about: "a disc on a flexible shaft with an automatic ball balancer",
        text: include_str!("../../../examples/04-ball-balancer/machine.toml"),
    },
    Template {
        name: "cup-separator",
        about: "a centrifuge with swinging cups: its operating window and the separation of sand from oil",
        text: include_str!("../../../examples/05-oil-desludging/machine.toml"),
    },
    Template {
        name: "spatial-liquid",
        about: "a rotor that tilts, with liquid that flows along its axis, on a frame that differs in x and y",
        text: include_str!("../../../examples/06-spatial-liquid/machine.toml"),
    },
    Template {
        name: "viscoelastic-shaft",
        about: "a disc on a plastic shaft whose material remembers, and whirls above the critical speed",
        text: include_str!("../../../examples/07-viscoelastic-shaft/machine.toml"),
    },
    Template {
        name: "three-disc-rotor",
        about: "an elastic shaft with three discs on two bearings: a rotor of the literature, with its printed results",
        text: include_str!("../../../examples/08-three-disc-rotor/machine.toml"),
    },
    Template {
        name: "cream-separator",
        about: "a bowl with milk on an elastic spindle, a neck bearing that stiffens, a frame on rubber feet",
        text: include_str!("../../../examples/09-cream-separator/machine.toml"),
    },
];

/// What may be said to `new`.
#[derive(clap::Args)]
pub struct Args {
    /// The template; without one, list them
    template: Option<String>,
    /// The file to write; "-" is standard output [default: TEMPLATE.toml]
    #[arg(long)]
    out: Option<PathBuf>,
}

/// Writes a template; never over an existing file.
pub fn new(args: &Args) -> u8 {
    let Some(word) = &args.template else {
        let column = TEMPLATES.iter().map(|t| t.name.len()).max().unwrap_or(0);
        let lines: String = TEMPLATES.iter().map(|t| format!("{:column$}  {}\n", t.name, t.about)).collect();
        terminal::print(&format!("{lines}\nlaval new TEMPLATE writes TEMPLATE.toml.\n"));
        return DONE;
    };
    let Some(template) = TEMPLATES.iter().find(|t| t.name == word) else {
        let names = || TEMPLATES.iter().map(|t| t.name);
        let all = names().collect::<Vec<_>>().join(", ");
        let help = nearest(word, names())
            .map_or_else(|| text!("templates: {all}", all), |n| meant(text::quoted(&n), text!("templates: {all}", all)));
        input::complain(
            &Diagnostic::error("request.template", text!("there is no template {word}", word = text::quoted(&word))).help(help),
        );
        return WRONG;
    };
    let path = args.out.clone().unwrap_or_else(|| PathBuf::from(format!("{}.toml", template.name)));
    if path == Path::new("-") {
        terminal::print(&template.named(template.name));
        return DONE;
    }
    let text = template.named(&path.file_stem().map_or_else(|| template.name.into(), |s| s.to_string_lossy()));
    let code = create(&path, &text);
    if code == DONE {
        terminal::print(&format!("{}\n", path.display()));
    }
    code
}

/// Writes a file that did not exist.
pub fn create(path: &Path, text: &str) -> u8 {
    // create_new: a file that appears in between is not overwritten either
    let fill = |mut file: File| {
        let filled = file.write_all(text.as_bytes());
        if filled.is_err() {
            // the reason of the failure matters, not that of the clean-up
            let _ = fs::remove_file(path);
        }
        filled
    };
    match OpenOptions::new().write(true).create_new(true).open(path).and_then(fill) {
        Ok(()) => DONE,
        Err(e) if e.kind() == ErrorKind::AlreadyExists => {
            let d = Diagnostic::error("request.exists", text!("{path} exists and is not overwritten", path = path.display()));
            input::complain(&d.help(text!("name another file with --out")));
            WRONG
        }
        Err(e) => {
            input::complain(&Diagnostic::error("file.write", text!("cannot write {path}: {e}", path = path.display(), e)));
            if e.kind() == ErrorKind::StorageFull { FAILED } else { WRONG }
        }
    }
}
