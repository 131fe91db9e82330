//! Centrifugal separation: particles, recovery, operating windows.

mod carried;
mod motion;
mod operating_window;
mod recovery;
mod release;
mod suspension;
mod window_edges;
