//! Which build computed, and on what processor: the last digits of results may depend on both.

use laval_num::lanes::Level;

/// Sources, versions of the libraries, compiler and target of this build, as sixteen hexadecimal digits.
pub const ID: &str = env!("LAVAL_BUILD");

/// The widest instructions of this processor: dense algebra sums in an order that depends on them.
pub fn processor() -> &'static str {
    Level::best().name()
}
