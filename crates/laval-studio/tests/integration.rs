//! Tests of the server through its own socket.

#[path = "answers.rs"]
mod answers;
#[path = "client/mod.rs"]
mod client;
#[path = "motions.rs"]
mod motions;
#[path = "runs.rs"]
mod runs;
#[path = "security.rs"]
mod security;
