//! Numbers that look random, the same for every case at every run.

pub struct Random(u64);

impl Random {
    pub fn new(case: u64) -> Self {
        Random(case.wrapping_mul(0xD134_2543_DE82_EF95) ^ 0x0FE1_57EE_1F00_D5A1)
    }
    fn bits(&mut self) -> u64 {
        self.0 = self.0.wrapping_add(0x9E37_79B9_7F4A_7C15);
        let mut z = self.0;
        z = (z ^ (z >> 30)).wrapping_mul(0xBF58_476D_1CE4_E5B9);
        z = (z ^ (z >> 27)).wrapping_mul(0x94D0_49BB_1331_11EB);
        z ^ (z >> 31)
    }
    pub fn unit(&mut self) -> f64 {
        (self.bits() >> 11) as f64 / (1u64 << 53) as f64
    }
    pub fn below(&mut self, n: usize) -> usize {
        (self.bits() >> 11) as usize % n.max(1)
    }
    pub fn chance(&mut self, percent: usize) -> bool {
        self.below(100) < percent
    }
    pub fn between(&mut self, from: f64, to: f64) -> f64 {
        from + (to - from) * self.unit()
    }
    /// Spread evenly over the orders of magnitude.
    pub fn size(&mut self, from: f64, to: f64) -> f64 {
        from * (to / from).powf(self.unit())
    }
}
