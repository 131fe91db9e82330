//! `laval studio` from outside: its address, its runs beside those of `laval run`, its end.

use crate::launcher::{Dir, ROTOR, tree};
use serde_json::{Value, json};
use std::io::{BufRead, BufReader, Read, Write};
use std::net::TcpStream;
use std::process::{Child, Stdio};
use std::time::{Duration, Instant};

struct Studio {
    child: Child,
    address: String,
}

impl Studio {
    fn new(dir: &Dir, args: &[&str]) -> Studio {
        let all = ["studio", "--no-browser"].iter().chain(args);
        let mut child = dir.command(all).stdout(Stdio::piped()).spawn().unwrap();
        let mut address = String::new();
        BufReader::new(child.stdout.take().unwrap()).read_line(&mut address).unwrap();
        Studio { child, address: address.trim().into() }
    }

    fn ask(&self, path: &str, body: Option<&Value>) -> String {
        let rest = self.address.strip_prefix("http://").unwrap();
        let (host, token) = rest.split_once('/').unwrap();
        let mut stream = TcpStream::connect(host).unwrap();
        let text = body.map_or_else(String::new, Value::to_string);
        let (method, more) = match body {
            Some(_) => ("POST", format!("Origin: http://{host}\r\nContent-Type: application/json\r\nContent-Length: {}\r\n", text.len())),
            None => ("GET", String::new()),
        };
        write!(stream, "{method} /{token}{path} HTTP/1.1\r\nHost: {host}\r\nConnection: close\r\n{more}\r\n{text}").unwrap();
        let mut answer = String::new();
        stream.read_to_string(&mut answer).unwrap();
        answer
    }
}

impl Drop for Studio {
    fn drop(&mut self) {
        let _ = self.child.kill();
        let _ = self.child.wait();
    }
}

#[test]
fn a_run_writes_the_files_of_laval_run() {
    let dir = Dir::new("studio");
    let studies = "[[study]]\nkind = \"sweep\"\nname = \"slow\"\nspeed = { from = 50, to = 400, points = 8 }\n[[study]]\nkind = \"modes\"\nspeed = 100\n";
    let text = format!("{ROTOR}{studies}");
    dir.file("x.toml", &text);
    let studio = Studio::new(&dir, &["x.toml"]);
    let begun = studio.ask("api/runs", Some(&json!({ "text": text, "study": "slow" })));
    let id = begun.split("\"id\":\"").nth(1).and_then(|t| t.split('"').next()).unwrap_or_else(|| panic!("{begun}"));
    let since = Instant::now();
    loop {
        let runs = studio.ask("api/runs", None);
        if runs.contains(&format!("\"id\":\"{id}\"")) && runs.contains("\"state\":\"done\"") {
            break;
        }
        assert!(!runs.contains("failed") && since.elapsed() < Duration::from_secs(60), "{runs}");
        std::thread::sleep(Duration::from_millis(20));
    }
    let own = tree(&dir.0.join("out/x"));
    dir.laval(["run", "x.toml", "--only", "slow", "--out", "beside"]).done();
    let beside = tree(&dir.0.join("beside"));
    assert!(own.keys().eq(beside.keys()) && own.len() > 4, "{:?} {:?}", own.keys(), beside.keys());
    for (name, content) in &own {
        assert!(*content == beside[name], "{} differs", name.display());
    }
}

#[test]
fn what_cannot_be_served_is_said() {
    let dir = Dir::new("studio-wrong");
    dir.file("x.toml", ROTOR);
    for (args, sentence) in [
        (&["none.toml"][..], "there is no file none.toml"),
        (&["."], ". is a folder"),
        (&["x.toml", "--token", "a/b"], "a token has at least 8 letters and digits"),
    ] {
        let said = dir.laval(["studio", "--no-browser"].iter().chain(args));
        assert!(said.code == 1 && said.err.contains(sentence), "{}", said.err);
    }
    let first = Studio::new(&dir, &["x.toml"]);
    let port = first.address.split([':', '/']).nth(4).unwrap().to_string();
    let said = dir.laval(["studio", "--no-browser", "--port", &port, "x.toml"]);
    assert!(
        said.code == 1 && said.err.contains(&format!("port {port} cannot be used")) && said.err.contains("a free one is taken"),
        "{}",
        said.err
    );
}

/// Ctrl-C ends it, also while a page looks at a run.
#[cfg(unix)]
#[test]
fn an_interrupt_ends_it() {
    let dir = Dir::new("studio-end");
    dir.file("x.toml", format!("{ROTOR}[[study]]\nkind = \"transient\"\nname = \"long\"\nduration = \"1e7 s\"\n"));
    let mut studio = Studio::new(&dir, &["x.toml"]);
    let text = dir.read("x.toml");
    let begun = studio.ask("api/runs", Some(&json!({ "text": text, "study": "long" })));
    assert!(begun.contains("\"id\""), "{begun}");
    let id = studio.child.id().to_string();
    assert!(std::process::Command::new("kill").args(["-INT", &id]).status().unwrap().success());
    let since = Instant::now();
    while studio.child.try_wait().unwrap().is_none() {
        assert!(since.elapsed() < Duration::from_secs(60), "it goes on");
        std::thread::sleep(Duration::from_millis(20));
    }
    assert_eq!(studio.child.wait().unwrap().code(), Some(0));
}
