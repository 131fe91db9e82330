//! Ctrl-C.

use crate::{STOPPED, terminal};
use laval::text;
use std::sync::atomic::{AtomicBool, Ordering};

/// Calls `stop` at the first Ctrl-C; the second one ends the program at once.
pub fn listen(stop: impl Fn() + Send + 'static) {
    let pressed = AtomicBool::new(false);
    let pressed = move || {
        if pressed.swap(true, Ordering::Relaxed) {
            std::process::exit(i32::from(STOPPED));
        }
        stop();
    };
    if let Err(e) = ctrlc::set_handler(pressed) {
        terminal::say(&text!("warning: Ctrl-C will stop at once and lose what is not yet written ({e})", e = e.to_string()));
    }
}
