//! A server in a folder of its own, and requests to it as a browser makes them.

use laval_studio::{Example, Handle, Options, Server};
use serde_json::Value as Json;
use std::fs;
use std::io::{Read, Write};
use std::net::TcpStream;
use std::path::PathBuf;
use std::sync::atomic::{AtomicUsize, Ordering};
use std::thread::JoinHandle;
use std::time::Duration;

pub const TOKEN: &str = "0123456789abcdef";

pub const SEPARATOR: &str = include_str!("../../../../examples/01-oil-separator/machine.toml");

pub struct Studio {
    pub port: u16,
    pub folder: PathBuf,
    handle: Handle,
    thread: Option<JoinHandle<()>>,
}

pub struct Answer {
    pub status: u16,
    pub head: String,
    pub body: Vec<u8>,
}

impl Answer {
    pub fn text(&self) -> &str {
        std::str::from_utf8(&self.body).unwrap()
    }
    pub fn json(&self) -> Json {
        assert_eq!(self.status, 200, "{}", self.text());
        serde_json::from_slice(&self.body).unwrap_or_else(|e| panic!("{e}: {}", self.text()))
    }
    /// Lines of an answer that comes in pieces.
    pub fn lines(&self) -> Vec<Json> {
        assert_eq!(self.status, 200, "{}", self.text());
        self.text().lines().map(|l| serde_json::from_str(l).unwrap()).collect()
    }
}

impl Studio {
    pub fn new(name: &str) -> Studio {
        static NEXT: AtomicUsize = AtomicUsize::new(0);
        let own = format!("laval-studio-{name}-{}-{}", std::process::id(), NEXT.fetch_add(1, Ordering::Relaxed));
        let folder = std::env::temp_dir().join(own);
        fs::create_dir_all(&folder).unwrap();
        fs::write(folder.join("separator.toml"), SEPARATOR).unwrap();
        let folder = folder.canonicalize().unwrap();
        let options = Options {
            folder: folder.clone(),
            file: Some(folder.join("separator.toml")),
            token: Some(TOKEN.into()),
            examples: vec![Example { name: "oil-separator", title: "a drum with oil", text: SEPARATOR }],
            ..Options::default()
        };
        let server = Server::new(options).unwrap_or_else(|d| panic!("{d}"));
        let port = server.address().split([':', '/']).nth(4).unwrap().parse().unwrap();
        let handle = server.handle();
        let thread = std::thread::spawn(move || server.serve().unwrap_or_else(|d| panic!("{d}")));
        Studio { port, folder, handle, thread: Some(thread) }
    }

    pub fn origin(&self) -> String {
        format!("http://127.0.0.1:{}", self.port)
    }

    /// Any bytes of a request.
    pub fn raw(&self, request: &[u8]) -> Answer {
        let mut stream = TcpStream::connect(("127.0.0.1", self.port)).unwrap();
        stream.set_read_timeout(Some(Duration::from_secs(120))).unwrap();
        // a server that refuses does not read all
        let _ = stream.write_all(request);
        let mut all = Vec::new();
        let _ = stream.read_to_end(&mut all);
        let split = all.windows(4).position(|w| w == b"\r\n\r\n").unwrap_or_else(|| panic!("{}", String::from_utf8_lossy(&all)));
        let head = String::from_utf8(all[..split].to_vec()).unwrap();
        let status = head.split(' ').nth(1).unwrap().parse().unwrap();
        let body = all[split + 4..].to_vec();
        let body = if head.to_lowercase().contains("transfer-encoding: chunked") { joined(&body) } else { body };
        Answer { status, head, body }
    }

    /// A request of the page with other headers in place of its own, or further ones.
    pub fn request(&self, method: &str, path: &str, headers: &[(&str, &str)], body: &[u8]) -> Answer {
        self.raw(&self.bytes(method, path, headers, body))
    }

    pub fn bytes(&self, method: &str, path: &str, headers: &[(&str, &str)], body: &[u8]) -> Vec<u8> {
        let host = format!("127.0.0.1:{}", self.port);
        let origin = self.origin();
        let mut own = vec![("Host", host.as_str()), ("Connection", "close")];
        if method == "POST" {
            own.extend([("Origin", origin.as_str()), ("Content-Type", "application/json")]);
        }
        let mut text = format!("{method} {path} HTTP/1.1\r\n");
        for (name, value) in own.iter().filter(|o| headers.iter().all(|h| h.0 != o.0)).chain(headers).filter(|h| !h.1.is_empty()) {
            text += &format!("{name}: {value}\r\n");
        }
        text += &format!("Content-Length: {}\r\n\r\n", body.len());
        [text.as_bytes(), body].concat()
    }

    pub fn get(&self, path: &str) -> Answer {
        self.request("GET", &format!("/{TOKEN}/{path}"), &[], b"")
    }

    pub fn post(&self, path: &str, body: &Json) -> Answer {
        self.request("POST", &format!("/{TOKEN}/{path}"), &[], body.to_string().as_bytes())
    }
}

/// Pieces of a body.
fn joined(mut body: &[u8]) -> Vec<u8> {
    let mut out = Vec::new();
    while let Some(line) = body.windows(2).position(|w| w == b"\r\n") {
        let size = usize::from_str_radix(std::str::from_utf8(&body[..line]).unwrap().trim(), 16).unwrap();
        if size == 0 {
            break;
        }
        out.extend_from_slice(&body[line + 2..line + 2 + size]);
        body = &body[line + 4 + size..];
    }
    out
}

impl Drop for Studio {
    fn drop(&mut self) {
        self.handle.stop();
        let ended = self.thread.take().map(JoinHandle::join);
        let _ = fs::remove_dir_all(&self.folder);
        if !std::thread::panicking() {
            assert!(ended.is_some_and(|e| e.is_ok()));
        }
    }
}
