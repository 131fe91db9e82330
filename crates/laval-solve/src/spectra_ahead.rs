//! Spectra at many speeds, some of them at a time, on all processors.

use super::locate::State;
use super::pencil::Spectrum;
use super::sweep::spectrum;
use crate::diagnostic::Diagnostic;
use crate::model::system::System;
use laval_num::work::Here;
use rayon::prelude::*;
use std::collections::VecDeque;

/// Spectra computed together, at most: as many whatever the number of processors, so that the work does not depend on it. The first blocks are smaller, since a search may
/// end early.
pub(super) const TOGETHER: usize = 16;

/// Spectra at these speeds, in their order.
pub(super) struct Ahead<'a> {
    system: &'a System,
    state: State<'a>,
    speeds: &'a [f64],
    known: VecDeque<Result<Spectrum, Diagnostic>>,
    block: usize,
}

impl<'a> Ahead<'a> {
    pub fn new(system: &'a System, state: State<'a>, speeds: &'a [f64]) -> Self {
        Ahead { system, state, speeds, known: VecDeque::new(), block: 1 }
    }
}

impl Iterator for Ahead<'_> {
    type Item = Result<Spectrum, Diagnostic>;

    fn next(&mut self) -> Option<Self::Item> {
        if self.known.is_empty() {
            let (some, rest) = self.speeds.split_at(self.block.min(self.speeds.len()));
            (self.speeds, self.block) = (rest, (2 * self.block).min(TOGETHER));
            self.known = at(self.system, self.state, some).into();
        }
        self.known.pop_front()
    }
}

/// Spectra at these speeds.
pub(super) fn at(system: &System, state: State, speeds: &[f64]) -> Vec<Result<Spectrum, Diagnostic>> {
    together(speeds, |&w| spectrum(system, state, w).map(|s| s.1))
}

/// Results for these, on all processors, in their order.
pub(super) fn together<T: Sync, R: Send>(all: &[T], one: impl Fn(&T) -> R + Sync) -> Vec<R> {
    if all.len() < 2 {
        return all.iter().map(one).collect();
    }
    let here = Here::now();
    let counted = |x: &T| {
        let _counted = here.enter();
        one(x)
    };
    all.par_iter().map(counted).collect()
}
