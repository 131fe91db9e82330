use crate::client::{SEPARATOR, Studio, TOKEN};
use serde_json::json;
use std::fs;
use std::net::TcpStream;
use std::time::Duration;

#[test]
fn nothing_is_answered_without_the_token() {
    let s = Studio::new("token");
    assert_eq!(s.get("").status, 200);
    for path in
        ["/", "/api/start", "/0123456789abcdee/", "/0123456789abcde/", "/0123456789abcdef0/api/start", "//", "/../", "/%30123456789abcdef/"]
    {
        let a = s.request("GET", path, &[], b"");
        assert_eq!((a.status, a.body.len()), (403, 0), "{path}");
    }
    // of a wrong address below the token nothing but that is known
    assert_eq!(s.get("assets/../../etc/passwd").status, 404);
    assert_eq!(s.get("assets/index.html").status, 404);
}

#[test]
fn other_origins_and_hosts_are_refused() {
    let s = Studio::new("origin");
    let body = json!({ "text": SEPARATOR }).to_string();
    let post = |headers: &[(&str, &str)]| s.request("POST", &format!("/{TOKEN}/api/check"), headers, body.as_bytes()).status;
    assert_eq!(post(&[]), 200);
    let other = format!("http://127.0.0.1:{}", s.port ^ 1);
    let secure = s.origin().replace("http:", "https:");
    for origin in ["http://example.org", "null", "", "http://localhost", &other, &secure, "http://127.0.0.1.example.org:80"] {
        assert_eq!(post(&[("Origin", origin)]), 403, "{origin}");
    }
    for host in ["example.org", "127.0.0.1", "localhost:1", &format!("example.org:{}", s.port), &format!("127.0.0.1.nip.io:{}", s.port)] {
        assert_eq!(post(&[("Host", host)]), 421, "{host}");
        assert_eq!(s.request("GET", &format!("/{TOKEN}/"), &[("Host", host)], b"").status, 421, "{host}");
    }
    let local = [("Host", &*format!("localhost:{}", s.port)), ("Origin", &*format!("http://localhost:{}", s.port))];
    assert_eq!(post(&local), 200);
    assert_eq!(post(&[("Sec-Fetch-Site", "cross-site")]), 403);
    assert_eq!(s.request("GET", &format!("/{TOKEN}/api/start"), &[("Sec-Fetch-Site", "same-site")], b"").status, 403);
    assert_eq!(s.request("GET", &format!("/{TOKEN}/api/start"), &[("Origin", "http://example.org")], b"").status, 403);
    // what a form of another page can send without a question to the server
    for kind in ["text/plain", "application/x-www-form-urlencoded", "", "multipart/form-data; boundary=x"] {
        assert_eq!(post(&[("Content-Type", kind)]), 415, "{kind}");
    }
    assert_eq!(
        s.request(
            "POST",
            &format!("/{TOKEN}/api/check"),
            &[("Host", &format!("127.0.0.1:{}\r\nHost: 127.0.0.1:{}", s.port, s.port))],
            b"{}"
        )
        .status
            / 100,
        4
    );
}

#[test]
fn methods_beside_get_and_post_are_refused() {
    let s = Studio::new("method");
    for method in ["PUT", "DELETE", "OPTIONS", "PATCH", "TRACE"] {
        assert_eq!(s.request(method, &format!("/{TOKEN}/api/check"), &[], b"").status, 405, "{method}");
    }
    assert_eq!(s.request("GET", &format!("/{TOKEN}/api/check"), &[], b"").status, 405);
    assert_eq!(s.post("api/start", &json!({})).status, 405);
}

#[test]
fn every_answer_has_a_strict_policy() {
    let s = Studio::new("policy");
    for path in ["", "api/start", "nothing"] {
        let head = s.get(path).head.to_lowercase();
        for line in [
            "content-security-policy: default-src 'none'; script-src 'self';",
            "frame-ancestors 'none'",
            "x-content-type-options: nosniff",
            "referrer-policy: no-referrer",
            "cache-control: no-store",
            "cross-origin-resource-policy: same-origin",
        ] {
            assert!(head.contains(line), "{path}: {line}\n{head}");
        }
        assert!(!head.contains("access-control-allow"));
    }
}

#[test]
fn no_file_outside_the_folder_is_read_or_written() {
    let s = Studio::new("outside");
    let outside = s.folder.with_extension("outside.toml");
    fs::write(&outside, SEPARATOR).unwrap();
    fs::create_dir(s.folder.join("inner")).unwrap();
    fs::write(s.folder.join("inner/a b.toml"), SEPARATOR).unwrap();
    fs::write(s.folder.join("secret.txt"), "part").unwrap();
    let name = outside.file_name().unwrap().to_str().unwrap();
    let mut names = vec![
        format!("../{name}"),
        format!("inner/../../{name}"),
        outside.to_str().unwrap().to_string(),
        format!("%2e%2e%2f{name}"),
        "secret.txt".into(),
        "/etc/passwd".into(),
        "..%5c..%5cx.toml".into(),
        "separator.toml%00.toml".into(),
        "".into(),
        "inner".into(),
        "C:x.toml".into(),
    ];
    #[cfg(unix)]
    {
        std::os::unix::fs::symlink(&outside, s.folder.join("link.toml")).unwrap();
        std::os::unix::fs::symlink(s.folder.parent().unwrap(), s.folder.join("way")).unwrap();
        names.extend(["link.toml".to_string(), format!("way/{name}")]);
    }
    for name in &names {
        let a = s.get(&format!("api/open?file={name}"));
        assert_eq!(a.status, 422, "{name}: {}", a.text());
        assert!(a.text().starts_with("{\"error\":"), "{}", a.text());
        let a = s.post("api/save", &json!({ "file": name.replace("%2e", ".").replace("%2f", "/").replace("%5c", "\\").replace("%00", "\0"), "text": "x", "force": true }));
        assert_eq!(a.status, 422, "{name}: {}", a.text());
    }
    assert_eq!(fs::read_to_string(&outside).unwrap(), SEPARATOR);
    assert_eq!(fs::read_to_string(s.folder.join("secret.txt")).unwrap(), "part");
    assert_eq!(s.get("api/open?file=inner/a%20b.toml").json()["text"], SEPARATOR);
    let start = s.get("api/start").json();
    assert_eq!(start["folder_files"], json!(["inner/a b.toml", "separator.toml"]));
    fs::remove_file(outside).unwrap();
}

#[test]
fn a_file_that_changed_on_the_disk_is_not_overwritten() {
    let s = Studio::new("save");
    let save = |text: &str, base: &str, force: bool| {
        s.post("api/save", &json!({ "file": "separator.toml", "text": text, "base": base, "force": force })).status
    };
    assert_eq!(save("first", SEPARATOR, false), 200);
    assert_eq!(save("second", "first", false), 200);
    fs::write(s.folder.join("separator.toml"), "by another").unwrap();
    assert_eq!(save("third", "second", false), 409);
    assert_eq!(fs::read_to_string(s.folder.join("separator.toml")).unwrap(), "by another");
    assert_eq!(save("third", "second", true), 200);
    assert_eq!(s.post("api/save", &json!({ "file": "new.toml", "text": "new" })).status, 200);
    assert_eq!(fs::read_to_string(s.folder.join("new.toml")).unwrap(), "new");
    assert_eq!(s.post("api/save", &json!({ "file": "new.toml", "text": "other" })).status, 409);
    assert_eq!(fs::read_dir(&s.folder).unwrap().count(), 2, "no unfinished file is left");
}

#[test]
fn oversized_and_malformed_bodies_are_refused() {
    let s = Studio::new("malformed");
    let large = json!({ "text": "x".repeat(2 << 20) }).to_string();
    let send = |body: &[u8]| s.request("POST", &format!("/{TOKEN}/api/check"), &[], body).status;
    assert_eq!(send(large.as_bytes()), 413);
    let bodies: [&[u8]; 9] = [
        b"",
        b"{",
        b"[]",
        b"null",
        b"{\"text\": 3}",
        b"{\"serial\": 1}",
        b"\xff\xfe",
        b"{\"text\": \"\", \"more\": 1}",
        b"{\"text\": \"\\ud800\"}",
    ];
    for body in bodies {
        assert_eq!(send(body), 400, "{}", String::from_utf8_lossy(body));
    }
    assert_eq!(send(format!("{}1{}", "[".repeat(100_000), "]".repeat(100_000)).as_bytes()), 400);
    assert!(s.raw(b"nonsense\r\n\r\n").status == 400);
    let words = [json!({ "text": SEPARATOR, "want": ["everything"] }), json!({ "text": SEPARATOR, "want": "modes" })];
    assert!(words.iter().all(|w| s.post("api/answer", w).status == 400));
    assert_eq!(s.post("api/runs/7/pause", &json!({})).status, 404);
    assert_eq!(s.get("api/runs/7/report").status, 404);
    // texts of machines that are none are answered
    for text in ["", "\0", "= = =", "[[part]]", &"[".repeat(10_000), "\u{feff}[machine]", "machine = 3"] {
        let a = s.post("api/check", &json!({ "text": text })).json();
        assert!(a["machine"].is_null() && !a["diagnostics"].as_array().unwrap().is_empty(), "{text}: {a}");
    }
}

/// The port is open on the loopback address and on no other address of this computer.
#[test]
fn nothing_listens_beyond_loopback() {
    let s = Studio::new("loopback");
    assert!(TcpStream::connect(("127.0.0.1", s.port)).is_ok());
    // another loopback address is one of this computer, too, and is not served
    let other = TcpStream::connect_timeout(&format!("127.0.0.2:{}", s.port).parse().unwrap(), Duration::from_secs(2));
    assert!(other.is_err());
    #[cfg(target_os = "linux")]
    for table in ["/proc/self/net/tcp", "/proc/self/net/tcp6"] {
        let Ok(text) = fs::read_to_string(table) else { continue };
        let port = format!(":{:04X}", s.port);
        let listening = text.lines().filter(|l| l.split_whitespace().nth(3) == Some("0A"));
        for line in listening.filter(|l| l.split_whitespace().nth(1).is_some_and(|a| a.ends_with(&port))) {
            assert!(line.contains(&format!("0100007F{port}")), "{line}");
        }
    }
}

#[test]
fn a_token_has_letters_and_digits_and_is_random_unless_given() {
    use laval_studio::{Options, Server};
    let with = |token: Option<&str>| Server::new(Options { folder: ".".into(), token: token.map(Into::into), ..Options::default() });
    for token in ["", "short", "with/slash", "with space", "ünïcödë12", "a.b.c.d.e"] {
        assert!(with(Some(token)).is_err(), "{token}");
    }
    let address = || with(None).unwrap_or_else(|d| panic!("{d}")).address();
    let token = |a: String| a.split('/').nth(3).unwrap().to_string();
    let (a, b) = (token(address()), token(address()));
    assert!(a != b && a.len() == 32, "{a} {b}");
}
