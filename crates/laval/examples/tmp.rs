use laval::cavity::{Cavity, Truncation};
use laval_num::complex::Complex;
use laval_num::complex::c;
use laval_num::dual::Dual;
type D = Dual<f64, 1>;
fn main() {
    let l = |x: f64| D { re: x, eps: [0.0] };
    let cav = Cavity { radius: l(0.15), free: l(0.105), height: l(0.3), density: l(1000.0) };
    let om = 400.0;
    for g in [1.0, 4.0, 40.0, 400.0] {
        let (mut h, mut n, mut worst) = (0usize, 0usize, 0);
        let t0 = std::time::Instant::now();
        let mut w = -1000.0;
        let mut sum = 0.0;
        while w < 1500.0 {
            let s = Complex { re: D { re: w, eps: [0.0] }, im: D { re: -g, eps: [-1.0] } };
            let t = cav.tilt(s, l(om), Truncation::Rough);
            h += t.harmonics;
            n += 1;
            worst = worst.max(t.harmonics);
            sum += t.value.re.re;
            w += 1.7;
        }
        let el = t0.elapsed().as_secs_f64();
        println!(
            "g {g}: mean harmonics {}, worst {worst}, {:.1} us per evaluation, {:.2} us per harmonic {sum:e}",
            h / n,
            1e6 * el / n as f64,
            1e6 * el / h as f64
        );
    }
    let _ = c(0.0, 0.0);
}
