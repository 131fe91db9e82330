//! Centrifugal separation: particles, recovery, operating windows.

mod carried;
mod ensemble;
mod motion;
mod operating_window;
mod recovery;
mod release;
mod window_edges;
