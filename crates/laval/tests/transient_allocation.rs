//! No evaluation of a machine's right side allocates, compiled or general, memory states and free spin included.

mod common;

use common::Base;
use laval::model::system::System;
use laval::parts::disc::*;
use laval::solve::motion::{Motion, SpinLaw};
use laval::solve::programme::{Programme, Shape};
use laval_num::ode::Ode;
use std::alloc::{GlobalAlloc, Layout};
use std::cell::Cell;

thread_local! {
    static COUNT: Cell<u64> = const { Cell::new(0) };
}

struct Counting;

fn count() {
    // a thread that is ending has no counter any more, and no test to answer to
    let _ = COUNT.try_with(|c| c.set(c.get() + 1));
}

// SAFETY: every call is passed on unchanged to the system's allocator.
unsafe impl GlobalAlloc for Counting {
    unsafe fn alloc(&self, layout: Layout) -> *mut u8 {
        count();
        unsafe { std::alloc::System.alloc(layout) }
    }
    unsafe fn dealloc(&self, p: *mut u8, layout: Layout) {
        unsafe { std::alloc::System.dealloc(p, layout) }
    }
    unsafe fn realloc(&self, p: *mut u8, layout: Layout, size: usize) -> *mut u8 {
        count();
        unsafe { std::alloc::System.realloc(p, layout, size) }
    }
}

#[global_allocator]
static ALLOCATOR: Counting = Counting;

fn allocations(system: &System, law: SpinLaw, account: bool) -> u64 {
    let mut m = Motion::new(system, law).unwrap();
    if account {
        m.keep_account().unwrap();
    }
    let (y, mut dy) = (vec![1e-3; m.dim()], vec![0.0; m.dim()]);
    for i in 0..3 {
        m.rhs(0.01 * f64::from(i), &y, &mut dy).unwrap();
    }
    let before = COUNT.with(Cell::get);
    for i in 0..50 {
        m.rhs(0.01 * f64::from(i), &y, &mut dy).unwrap();
    }
    COUNT.with(Cell::get) - before
}

#[test]
fn right_sides_do_not_allocate() {
    let base = Base { fill: Some(0.7), ..Base::default() };
    let system = base.builder().build().unwrap();
    let wheel = DiscParams { polar_inertia: 0.3, ..DiscParams::new(1.0) };
    let free = base.builder().part("wheel", Disc::planar(), wheel).free_spin().build().unwrap();
    let level = base.builder().horizontal().build().unwrap();
    let ramp = || SpinLaw::Programme(Programme::ramp(100.0, 900.0, 0.3, Shape::Smooth, 0.2).unwrap());
    let constant = || SpinLaw::Programme(Programme::constant(900.0, 0.0));
    for account in [false, true] {
        assert_eq!(allocations(&system, constant(), account), 0);
        assert_eq!(allocations(&system, ramp(), account), 0);
        assert_eq!(allocations(&free, SpinLaw::Free, account), 0);
        assert_eq!(allocations(&level, ramp(), account), 0);
    }
}
