//! Lanes.
/// Elementary functions.
pub mod math {
    /// Sine and cosine.
    #[inline(always)]
    pub fn sin_cos(x: f64) -> (f64, f64) {
        x.sin_cos()
    }
    /// Exponential.
    #[inline(always)]
    pub fn exp(x: f64) -> f64 {
        x.exp()
    }
    /// Logarithm.
    #[inline(always)]
    pub fn ln(x: f64) -> f64 {
        x.ln()
    }
}
