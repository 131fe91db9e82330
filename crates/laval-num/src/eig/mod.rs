//! Eigenvalue problems: all modes of small and medium dense matrices, some of large sparse ones.
//!
//! | problem | call |
//! | --- | --- |
//! | `A x = s x` | [`eigenvalues`], [`Spectrum`] (reusable, fast for small real matrices), [`modes`] |
//! | `A x = s E x`, E possibly singular | [`Pencil`] |
//! | `A x = s E x`, real symmetric, E positive definite | [`definite`] |
//! | `(A0 + s A1 + s^2 A2) x = 0`, sparse: those nearest to a shift | [`nearest`], [`nearest_real`] |
//! | the same near starts, side by side | [`polish`] |
//! | modes along a parameter | [`Track`] |
//!
//! Every problem is scaled before it is solved (rows and columns by powers of two, so without rounding), and every mode carries the
//! evidence for itself: a backward error and a sensitivity, both measured in the scaled coordinates, where they do not depend on units.
//!
//! **Order.** Modes come by frequency |Im s|, then by growth Re s; of a conjugate pair the member with Im s > 0 comes first and the other,
//! exactly conjugate, directly after it. [`upper_half`] keeps Im s >= 0.
//!
//! **Vectors.** Right and left vectors (`A x = s x`, `y^H A = s y^H`) have Euclidean norm one. The first of the largest components of the
//! right vector is real and positive; the phase of the left vector makes `y^H x` (`y^H E x`, `y^H P'(s) x`) real and not negative.

mod balance;
mod deflate;
mod krylov;
mod mode;
mod number;
mod pencil;
mod polish;
mod small;
mod standard;
mod symmetric;
#[cfg(test)]
mod tests;
mod track;

pub use krylov::{Nearest, Quadratic, nearest, nearest_real};
pub use mode::{Mode, upper_half};
pub use number::{Number, Svd};
pub use pencil::{Modes, Pencil};
pub use polish::{Root, Start, polish};
pub use standard::{Spectrum, derivative, eigenvalues, modes};
pub use symmetric::definite;
pub use track::{Match, Track, assign};

/// Why a spectrum could not be computed.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum EigError {
    /// An entry is NaN or infinite.
    NotFinite,
    /// The QR or QZ iteration did not converge.
    NoConvergence,
    /// Every number is an eigenvalue: `det(A - s E)` vanishes for all s.
    SingularPencil,
}

impl std::fmt::Display for EigError {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.write_str(match self {
            EigError::NotFinite => "a matrix of the eigenvalue problem has an entry that is not finite",
            EigError::NoConvergence => "the eigenvalue iteration did not converge",
            EigError::SingularPencil => "every number is an eigenvalue: the determinant vanishes identically",
        })
    }
}
impl std::error::Error for EigError {}
