//! The connection that stays open.

use crate::client::{SEPARATOR, Studio, TOKEN};
use serde_json::{Value as Json, json};
use std::net::TcpStream;
use std::time::{Duration, Instant};
use tungstenite::client::IntoClientRequest;
use tungstenite::{Message, WebSocket, client};

impl Studio {
    fn connect(&self, origin: Option<&str>, path: &str) -> Result<WebSocket<TcpStream>, String> {
        let mut request = format!("ws://127.0.0.1:{}{path}", self.port).into_client_request().unwrap();
        if let Some(origin) = origin {
            request.headers_mut().insert("Origin", origin.parse().unwrap());
        }
        let stream = TcpStream::connect(("127.0.0.1", self.port)).unwrap();
        stream.set_read_timeout(Some(Duration::from_secs(60))).unwrap();
        client(request, stream).map(|c| c.0).map_err(|e| e.to_string())
    }

    fn live(&self) -> WebSocket<TcpStream> {
        self.connect(Some(&self.origin()), &format!("/{TOKEN}/api/live")).unwrap_or_else(|e| panic!("{e}"))
    }
}

fn send(socket: &mut WebSocket<TcpStream>, value: &Json) {
    socket.send(Message::text(value.to_string())).unwrap();
}

fn line(socket: &mut WebSocket<TcpStream>) -> Json {
    serde_json::from_str(socket.read().unwrap().to_text().unwrap()).unwrap()
}

/// The next lines, so many at least, of one message or of several.
fn lines(socket: &mut WebSocket<TcpStream>, count: usize) -> Vec<Json> {
    let mut out: Vec<Json> = Vec::new();
    while out.len() < count {
        let message = socket.read().unwrap();
        out.extend(message.to_text().unwrap().split('\n').map(|l| strip(serde_json::from_str(l).unwrap())));
    }
    out
}

/// A line but for the time that it took.
fn strip(mut l: Json) -> Json {
    l.as_object_mut().unwrap().remove("ms");
    l
}

/// What the page asks for over it is what it gets by requests.
#[test]
fn answers_are_those_of_requests() {
    let s = Studio::new("live");
    let mut socket = s.live();
    let body = json!({ "serial": 7, "text": SEPARATOR, "want": ["modes", "campbell"], "set": [{ "path": "drum.mass", "value": 2.5 }] });
    let asked: Vec<Json> = s.post("api/answer", &body).lines().into_iter().map(strip).collect();
    send(&mut socket, &json!({ "answer": body }));
    assert_eq!(asked, lines(&mut socket, asked.len()));
    // sentences in the language of the page
    send(&mut socket, &json!({ "answer": { "serial": 8, "text": "[[part]]", "want": ["modes"] }, "lang": "ru" }));
    let refused = line(&mut socket);
    assert!(refused["serial"] == 8 && refused["error"].as_str().unwrap().chars().any(|c| ('а'..='я').contains(&c)), "{refused}");
}

/// Modes of a drag, the first on a thread of their own, those after them without where they are brief: also those of a text that is wrong, and those after it.
#[test]
fn modes_that_follow_each_other_are_those_of_requests() {
    let s = Studio::new("live-drag");
    let mut socket = s.live();
    for serial in 1..=12 {
        let (text, mass) = if serial % 5 == 4 {
            ("[[part]]", 2.5)
        } else {
            (SEPARATOR, if serial % 5 == 2 { -1.0 } else { 2.5 + 0.01 * f64::from(serial) })
        };
        let body = json!({ "serial": serial, "text": text, "want": ["modes"], "set": [{ "path": "drum.mass", "value": mass }] });
        let asked: Vec<Json> = s.post("api/answer", &body).lines().into_iter().map(strip).collect();
        send(&mut socket, &json!({ "answer": body }));
        assert_eq!(asked, lines(&mut socket, asked.len()));
        let fine = serial % 5 != 4 && serial % 5 != 2;
        assert_eq!((asked.len(), asked[0].get("error").is_some()), if fine { (2, false) } else { (1, true) }, "{asked:?}");
    }
}

#[test]
fn an_answer_that_is_cancelled_ends_and_others_come() {
    let s = Studio::new("live-cancel");
    let mut socket = s.live();
    let heavy = SEPARATOR.replace("points = 20", "points = 21");
    for serial in 1..=20 {
        let want = ["stability", "campbell", "forced", "nonlinear"];
        send(&mut socket, &json!({ "answer": { "serial": serial, "text": format!("{heavy}\n# {serial}"), "want": want, "points": 2000 } }));
        send(&mut socket, &json!({ "cancel": serial }));
    }
    let begun = Instant::now();
    send(&mut socket, &json!({ "answer": { "serial": 99, "text": SEPARATOR, "want": ["modes"] } }));
    let answer = loop {
        let l = line(&mut socket);
        if l["serial"] == 99 {
            break l;
        }
    };
    assert!(answer["html"].is_string() && begun.elapsed() < Duration::from_secs(30), "{:?}", begun.elapsed());
}

#[test]
fn connections_of_other_pages_and_messages_that_are_none_are_refused() {
    let s = Studio::new("live-refused");
    let path = format!("/{TOKEN}/api/live");
    for origin in [None, Some("http://example.org"), Some("null"), Some("http://127.0.0.1:1"), Some("https://localhost")] {
        let refused = s.connect(origin, &path);
        assert!(refused.as_ref().is_err_and(|e| e.contains("403")), "{origin:?}: {:?}", refused.err());
    }
    let own = s.origin();
    for path in ["/api/live", "/0123456789abcdee/api/live"] {
        assert!(s.connect(Some(&own), path).is_err_and(|e| e.contains("403")), "{path}");
    }
    let large = format!("{{\"answer\": {{\"text\": \"{}\"}}}}", "x".repeat(3 << 20));
    for message in [Message::text("{"), Message::text("{\"other\": 1}"), Message::binary(vec![1, 2, 3]), Message::text(large)] {
        let mut socket = s.live();
        // a server that refuses does not read all
        let _ = socket.send(message);
        let end = socket.read();
        assert!(!matches!(end, Ok(Message::Text(_))), "{end:?}");
    }
    // and the server goes on
    assert_eq!(s.get("api/start").status, 200);
}
