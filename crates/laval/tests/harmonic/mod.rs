//! Periodic motions by harmonic balance: branches, bifurcations, free whirls, maps of responses.

mod bifurcation_loci;
mod branches;
mod claims;
mod contact;
mod duffing;
mod findings;
mod first_order;
mod free_studies;
mod free_whirls;
mod limit_cycles;
mod maps;
mod methods;
mod open_gap;
mod orders;
mod planar;
mod reference;
mod response_map;
mod response_starts;
mod sagged;
mod sketch;
mod spectra;
mod unbounded;
