//! Tests of the server through its own socket.

#[path = "answers.rs"]
mod answers;
#[path = "client/mod.rs"]
mod client;
#[path = "live.rs"]
mod live;
#[path = "motions.rs"]
mod motions;
#[path = "runs.rs"]
mod runs;
#[path = "security.rs"]
mod security;
