//! Lanes of every level of this processor against `f64`, bit for bit.

use laval_num::dual::Dual;
use laval_num::lanes::{Apply, Entry, Family, Kernel, LANES, LaneScalar, Level, Slots, dispatch};
use laval_num::scalar::Scalar;

/// xorshift64*, so that every run sees the same numbers.
struct Random(u64);
impl Random {
    fn bits(&mut self) -> u64 {
        self.0 ^= self.0 >> 12;
        self.0 ^= self.0 << 25;
        self.0 ^= self.0 >> 27;
        self.0.wrapping_mul(0x2545_F491_4F6C_DD1D)
    }
    fn unit(&mut self) -> f64 {
        (self.bits() >> 11) as f64 / (1u64 << 53) as f64
    }
    /// Ordinary sizes, all sizes, and the special values.
    fn number(&mut self) -> f64 {
        const SPECIAL: [f64; 16] = [
            0.0,
            -0.0,
            1.0,
            -1.0,
            f64::INFINITY,
            f64::NEG_INFINITY,
            f64::NAN,
            f64::MIN_POSITIVE,
            5e-324,
            -5e-324,
            f64::MAX,
            f64::MIN,
            1e6,
            1_000_000.1,
            -1e22,
            std::f64::consts::FRAC_PI_2,
        ];
        match self.bits() % 8 {
            0 => f64::from_bits(self.bits()),
            1 => SPECIAL[(self.bits() % 16) as usize],
            2 | 3 => (self.unit() - 0.5) * 1e3,
            4 => (self.unit() - 0.5) * 2.5e6,
            _ => (self.unit() - 0.5) * 8.0,
        }
    }
    fn lanes(&mut self) -> [f64; LANES] {
        std::array::from_fn(|_| self.number())
    }
}

/// Every operation of the trait, in a list.
#[inline(always)]
fn everything<S: Scalar>(x: S, y: S) -> [S; 27] {
    let (s, c) = x.sin_cos();
    let (sq, cq) = x.sin_cos_quarters();
    [
        sq,
        cq,
        x + y,
        x - y,
        x * y,
        x / y,
        -x,
        s,
        c,
        x.sqrt(),
        x.exp(),
        x.ln(),
        y.atan2(x),
        x.pos(),
        x.pow_pos(1.5),
        x.pow_pos(0.5),
        x.pow_pos(10.0 / 9.0),
        x.pow_pos(-2.7),
        x.pow_pos(1.0),
        x.pow_pos(2.0),
        x.select_pos(y, -y),
        x.scale(0.3),
        x.abs(),
        x.norm2(y),
        x.square(),
        x.sin(),
        x.cos(),
    ]
}

/// Equal bits, any NaN equal to any other.
fn same(a: f64, b: f64) -> bool {
    a.to_bits() == b.to_bits() || (a.is_nan() && b.is_nan())
}

struct Values<'a>(&'a [f64; LANES], &'a [f64; LANES]);
impl Kernel for Values<'_> {
    type Out = [[f64; LANES]; 27];
    #[inline(always)]
    fn run<S: LaneScalar>(self) -> Self::Out {
        everything(S::load(self.0), S::load(self.1)).map(|v| v.to_array())
    }
}

#[test]
fn lanes_equal_scalar_at_every_level() {
    let mut random = Random(7);
    for _ in 0..20_000 {
        let (x, y) = (random.lanes(), random.lanes());
        let expected: [_; LANES] = std::array::from_fn(|i| everything(x[i], y[i]));
        for level in Level::supported() {
            let got = dispatch(level, Values(&x, &y));
            for op in 0..got.len() {
                for i in 0..LANES {
                    let (g, e) = (got[op][i], expected[i][op]);
                    assert!(same(g, e), "{level:?}, operation {op} of ({:e}, {:e}): {g:e} for {e:e}", x[i], y[i]);
                }
            }
        }
    }
}

struct Errors<'a>(&'a [f64; LANES], &'a [f64; LANES]);
impl Kernel for Errors<'_> {
    type Out = [f64; LANES];
    #[inline(always)]
    fn run<S: LaneScalar>(self) -> Self::Out {
        let (x, y) = (S::load(self.0), S::load(self.1));
        x.product_error(y, x * y).to_array()
    }
}

/// Fused or not, what a product loses is the same; of whole numbers it is known exactly.
#[test]
fn rounding_errors_of_products() {
    let mut random = Random(5);
    for _ in 0..20_000 {
        // 53 bits each
        let [a, b]: [[i64; LANES]; 2] = std::array::from_fn(|_| std::array::from_fn(|_| (random.bits() >> 11) as i64 - (1 << 52)));
        let [x, y] = [a, b].map(|all| all.map(|k| k as f64));
        for level in Level::supported() {
            let got = dispatch(level, Errors(&x, &y));
            for i in 0..LANES {
                let exact = i128::from(a[i]) * i128::from(b[i]) - (x[i] * y[i]) as i128;
                assert!(got[i] == exact as f64 && got[i] == x[i].product_error(y[i], x[i] * y[i]), "{level:?}: {} {}", a[i], b[i]);
            }
        }
    }
}

struct Derivatives<'a>(&'a [f64; LANES], &'a [f64; LANES]);
impl Kernel for Derivatives<'_> {
    type Out = [[[f64; LANES]; 3]; 27];
    #[inline(always)]
    fn run<S: LaneScalar>(self) -> Self::Out {
        let (x, y) = (Dual::<S, 2>::seed(S::load(self.0), 0), Dual::seed(S::load(self.1), 1));
        everything(x, y).map(|d| [d.re.to_array(), d.eps[0].to_array(), d.eps[1].to_array()])
    }
}

#[test]
fn derivatives_in_lanes_equal_scalar_derivatives() {
    let mut random = Random(11);
    for _ in 0..5_000 {
        let (x, y) = (random.lanes(), random.lanes());
        for level in Level::supported() {
            let got = dispatch(level, Derivatives(&x, &y));
            for i in 0..LANES {
                let expected = everything(Dual::<f64, 2>::seed(x[i], 0), Dual::seed(y[i], 1));
                for (op, (g, e)) in got.iter().zip(expected).enumerate() {
                    let e = [e.re, e.eps[0], e.eps[1]];
                    for j in 0..3 {
                        assert!(same(g[j][i], e[j]), "{level:?}, operation {op}, part {j} of ({:e}, {:e})", x[i], y[i]);
                    }
                }
            }
        }
    }
}

struct Kinks;
impl Kernel for Kinks {
    type Out = ();
    #[inline(always)]
    fn run<S: LaneScalar>(self) {
        let zero = Dual::<S, 1>::seed(S::zero(), 0);
        for d in [zero.sqrt(), zero.pos(), zero.pow_pos(1.5), zero.pow_pos(10.0 / 9.0), zero.abs(), zero.norm2(Dual::zero())] {
            assert_eq!((d.re.to_array(), d.eps[0].to_array()), ([0.0; LANES], [0.0; LANES]));
        }
        let nan = S::cst(f64::NAN);
        for v in [nan.pos(), nan.abs(), nan.sqrt(), nan.exp(), nan.ln(), nan.sin(), nan.cos(), nan.atan2(S::one()), S::one().atan2(nan)] {
            assert!(v.to_array().iter().all(|x| x.is_nan()) && !v.finite().any());
        }
        for p in [0.5, 1.0, 1.1, 1.5, 2.0, -1.0] {
            assert!(nan.pow_pos(p).to_array().iter().all(|x| x.is_nan()));
            assert_eq!(S::cst(-3.0).pow_pos(p).to_array(), [0.0; LANES]);
        }
        assert_eq!(nan.select_pos(S::one(), S::zero()).to_array(), [0.0; LANES]);
    }
}

#[test]
fn kinks_are_finite_and_nan_passes() {
    for level in Level::supported() {
        dispatch(level, Kinks);
    }
}

struct Access;
impl Kernel for Access {
    type Out = Level;
    #[inline(always)]
    fn run<S: LaneScalar>(self) -> Level {
        let mut x = S::from_array(std::array::from_fn(|i| i as f64));
        x = x.with(2, f64::NAN).with(5, f64::INFINITY);
        assert_eq!((x.get(1), x.get(5)), (1.0, f64::INFINITY));
        assert_eq!(S::bits(x.lt(S::cst(4.0))).0, 0b1011);
        assert_eq!(S::bits(x.le(S::cst(4.0))).0, 0b1_1011);
        assert_eq!(x.finite().0, !0b10_0100);
        let y = S::select(S::cst(4.0).lt(x), S::cst(-1.0), x);
        assert_eq!(y.to_array()[3..8], [3.0, 4.0, -1.0, -1.0, -1.0]);
        assert!(S::bits(S::zero().lt(S::one())).all() && S::bits(S::one().lt(S::one())) == laval_num::lanes::LaneBits(0));
        assert!(x.finite().get(0) && !x.finite().get(2) && !x.finite().get(LANES));
        S::LEVEL
    }
}

#[test]
fn lanes_are_reached_in_order_and_the_level_is_the_one_requested_for() {
    for level in Level::supported() {
        assert_eq!(dispatch(level, Access), level);
    }
    assert_eq!(dispatch(Level::Avx512, Access), Level::best());
}

// an erased force law: the object-safe face, values and derivatives

struct Force<'a, S> {
    q: &'a [S],
    r: &'a mut [S],
}
struct Plain;
impl Family for Plain {
    type Args<'a, S: Scalar> = Force<'a, S>;
}
struct Gradient;
impl Family for Gradient {
    type Args<'a, S: Scalar> = Force<'a, Dual<S, 2>>;
}
trait Law {
    fn residual<S: Scalar>(&self, q: &[S], r: &mut [S]);
}
struct Hertz {
    stiffness: f64,
}
impl Law for Hertz {
    #[inline(always)]
    fn residual<S: Scalar>(&self, q: &[S], r: &mut [S]) {
        let (s, c) = q[1].sin_cos();
        let f = (q[0] * c).pow_pos(1.5).scale(self.stiffness);
        r[0] += f * c;
        r[1] += f * s + q[1].atan2(q[0]);
    }
}
impl<L: Law> Apply<L> for Plain {
    #[inline(always)]
    fn apply<S: Scalar>(law: &L, args: &mut Force<'_, S>) {
        law.residual(args.q, args.r);
    }
}
impl<L: Law> Apply<L> for Gradient {
    #[inline(always)]
    fn apply<S: Scalar>(law: &L, args: &mut Force<'_, Dual<S, 2>>) {
        law.residual(args.q, args.r);
    }
}
trait Erased: Slots<Plain> + Slots<Gradient> {}
impl<T: Slots<Plain> + Slots<Gradient>> Erased for T {}

#[inline(always)]
fn erased_call<S: Entry>(law: &dyn Erased, q: [S; 2]) -> [S; 8] {
    let mut r = [S::zero(); 2];
    S::enter::<Plain, _>(law, &mut Force { q: &q, r: &mut r });
    let mut d = [Dual::zero(); 2];
    S::enter::<Gradient, _>(law, &mut Force { q: &[Dual::seed(q[0], 0), Dual::seed(q[1], 1)], r: &mut d });
    [r[0], r[1], d[0].re, d[0].eps[0], d[0].eps[1], d[1].re, d[1].eps[0], d[1].eps[1]]
}

struct Call<'a>(&'a dyn Erased, &'a [f64; LANES], &'a [f64; LANES]);
impl Kernel for Call<'_> {
    type Out = [[f64; LANES]; 8];
    #[inline(always)]
    fn run<S: LaneScalar>(self) -> Self::Out {
        erased_call(self.0, [S::load(self.1), S::load(self.2)]).map(|v| v.to_array())
    }
}

#[test]
fn erased_slots_give_the_same_bits() {
    let law: Box<dyn Erased> = Box::new(Hertz { stiffness: 3.7 });
    let mut random = Random(13);
    for _ in 0..2_000 {
        let (x, y) = (random.lanes(), random.lanes());
        let expected: [_; LANES] = std::array::from_fn(|i| erased_call(&*law, [x[i], y[i]]));
        for level in Level::supported() {
            let got = dispatch(level, Call(&*law, &x, &y));
            for i in 0..LANES {
                for j in 0..8 {
                    assert!(same(got[j][i], expected[i][j]), "{level:?} {j} at ({:e}, {:e})", x[i], y[i]);
                }
            }
        }
    }
}
