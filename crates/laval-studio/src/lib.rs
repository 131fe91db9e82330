//! `laval studio`: a page that shows a machine and answers while it is changed, and the server beside it.
//!
//! The server listens on the loopback address alone. Every address begins with a random token, requests of other origins are refused, and no file outside the
//! folder that it was started in is read or written (`guard`, `folder`). Computations run on threads of their own and end when the page no longer waits for them (`abandon`).

#![warn(missing_docs)]
#![forbid(unsafe_code)]

mod abandon;
mod answer;
mod behind;
mod check;
mod completion;
mod drawing;
mod edit;
mod folder;
mod guard;
mod live;
mod machines;
mod motion;
mod offsets;
mod page;
mod parameters;
mod query;
mod ranges;
mod reach;
mod routes;
mod runs;
mod scene;
mod server;
mod share;
mod start;
mod stream;
mod targets;

pub use behind::share_behind;
pub use server::{Handle, Server};

use laval::report::Language;
use std::path::PathBuf;

/// A machine file that comes with the program.
#[derive(Clone, Copy, Debug)]
pub struct Example {
    /// Its word.
    pub name: &'static str,
    /// Its content as a phrase.
    pub title: &'static str,
    /// The file.
    pub text: &'static str,
}

/// How the server is started.
#[derive(Clone, Debug, Default)]
pub struct Options {
    /// The folder whose machine files may be opened and saved.
    pub folder: PathBuf,
    /// The machine file that is opened first, in that folder.
    pub file: Option<PathBuf>,
    /// Port; 0 takes a free one.
    pub port: u16,
    /// The token of the address; random unless given.
    pub token: Option<String>,
    /// Language of the page until the reader chooses another.
    pub language: Language,
    /// Machine files that come with the program.
    pub examples: Vec<Example>,
    /// The text that the page begins with, in place of that of the file.
    pub text: Option<String>,
    /// Pages of this computer may show the studio in a frame, as notebooks do.
    pub framed: bool,
}
