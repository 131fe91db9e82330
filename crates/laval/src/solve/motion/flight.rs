//! Integration of a [`Motion`](super::Motion) with what a study wants to know of it.
