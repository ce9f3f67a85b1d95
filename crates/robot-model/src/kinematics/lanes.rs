//! Eight numbers side by side, on any machine.

use super::matrix::{Mat3, Vec3};
use super::real::Real;
use std::ops::{Add, Div, Mul, Neg, Sub};

/// How many numbers lie side by side.
pub(crate) const LANES: usize = 8;

/// A vector of space.
pub(crate) trait Column: Copy + Add<Output = Self> + Sub<Output = Self> + Mul<Output = Self> {
    fn splat(value: f64) -> Self;
    fn load(values: &Vec3) -> Self;
}

/// A [`Column`] with a fourth number beside it that nothing is asked of.
pub(crate) trait Register: Column {
    fn store(self) -> [f64; 4];
}

/// A [`Register`] on any machine.
#[derive(Clone, Copy)]
pub(crate) struct Four([f64; 4]);

impl Column for Four {
    #[inline(always)]
    fn splat(value: f64) -> Self {
        Self([value; 4])
    }

    #[inline(always)]
    fn load(&[x, y, z]: &Vec3) -> Self {
        Self([x, y, z, 0.0])
    }
}

impl Register for Four {
    #[inline(always)]
    fn store(self) -> [f64; 4] {
        self.0
    }
}

/// A [`Column`] of numbers that are computed with one by one, each perhaps eight side by side.
#[derive(Clone, Copy)]
pub(crate) struct Three<T>(pub(crate) Vec3<T>);

impl<T: Real> Column for Three<T> {
    #[inline(always)]
    fn splat(value: f64) -> Self {
        let value = T::splat(value);
        Self([value, value, value])
    }

    #[inline(always)]
    fn load(&[x, y, z]: &Vec3) -> Self {
        Self([T::splat(x), T::splat(y), T::splat(z)])
    }
}

/// Eight numbers that the kernels take for one.
pub(crate) trait Wide: Real {
    type Column: Register;
    fn load(values: &Lanes) -> Self;
    fn store(self) -> Lanes;
    /// Whether any of them is more than one half.
    fn any(self) -> bool;
}

/// Eight numbers as they lie in memory, and what the kernels run on where a machine has nothing wider.
#[derive(Clone, Copy, Debug, PartialEq)]
#[repr(align(64))]
pub(crate) struct Lanes(pub(crate) [f64; LANES]);

impl Wide for Lanes {
    type Column = Four;

    #[inline(always)]
    fn load(values: &Lanes) -> Self {
        *values
    }

    #[inline(always)]
    fn store(self) -> Lanes {
        self
    }

    #[inline(always)]
    fn any(self) -> bool {
        self.0.iter().any(|a| *a > 0.5)
    }
}

macro_rules! elementwise {
    ($of:ident, $trait:ident, $method:ident, $op:tt) => {
        impl $trait for $of {
            type Output = Self;
            #[inline(always)]
            fn $method(self, other: Self) -> Self {
                Self(std::array::from_fn(|i| self.0[i] $op other.0[i]))
            }
        }
    };
}

elementwise!(Lanes, Add, add, +);
elementwise!(Lanes, Sub, sub, -);
elementwise!(Lanes, Mul, mul, *);
elementwise!(Lanes, Div, div, /);
elementwise!(Four, Add, add, +);
elementwise!(Four, Sub, sub, -);
elementwise!(Four, Mul, mul, *);

macro_rules! one_by_one {
    ($trait:ident, $method:ident, $op:tt) => {
        impl<T: Real> $trait for Three<T> {
            type Output = Self;
            #[inline(always)]
            fn $method(self, Self([x, y, z]): Self) -> Self {
                Self([self.0[0] $op x, self.0[1] $op y, self.0[2] $op z])
            }
        }
    };
}

one_by_one!(Add, add, +);
one_by_one!(Sub, sub, -);
one_by_one!(Mul, mul, *);

impl Neg for Lanes {
    type Output = Self;
    #[inline(always)]
    fn neg(self) -> Self {
        Self(self.0.map(|a| -a))
    }
}

impl Real for Lanes {
    #[inline(always)]
    fn splat(value: f64) -> Self {
        Self([value; LANES])
    }

    #[inline(always)]
    fn square_root(self) -> Self {
        Self(self.0.map(f64::sqrt))
    }

    #[inline(always)]
    fn size(self) -> Self {
        Self(self.0.map(f64::abs))
    }

    #[inline(always)]
    fn at_most(self, limit: Self) -> Self {
        Self(std::array::from_fn(|i| self.0[i].at_most(limit.0[i])))
    }

    #[inline(always)]
    fn choose(self, yes: Self, no: Self) -> Self {
        Self(std::array::from_fn(|i| self.0[i].choose(yes.0[i], no.0[i])))
    }

    #[inline(always)]
    fn larger(self, other: Self) -> Self {
        Self(std::array::from_fn(|i| self.0[i].larger(other.0[i])))
    }

    #[inline(always)]
    fn turned_by_quarters(quarters: Self, sin: Self, cos: Self) -> (Self, Self) {
        let (mut sine, mut cosine) = (sin, cos);
        for i in 0..LANES {
            (sine.0[i], cosine.0[i]) = f64::turned_by_quarters(quarters.0[i], sin.0[i], cos.0[i]);
        }
        (sine, cosine)
    }
}

#[inline(always)]
pub(super) fn load<V: Wide>(v: &Vec3<Lanes>) -> Vec3<V> {
    [V::load(&v[0]), V::load(&v[1]), V::load(&v[2])]
}

#[inline(always)]
pub(super) fn load_rows<V: Wide>(a: &Mat3<Lanes>) -> Mat3<V> {
    [load(&a[0]), load(&a[1]), load(&a[2])]
}

#[inline(always)]
pub(super) fn store_rows<V: Wide>(a: &Mat3<V>) -> Mat3<Lanes> {
    let [a, b, c] = a;
    [store3(a), store3(b), store3(c)]
}

#[inline(always)]
pub(super) fn store3<V: Wide>(v: &Vec3<V>) -> Vec3<Lanes> {
    [v[0].store(), v[1].store(), v[2].store()]
}

#[inline(always)]
pub(super) fn load6<V: Wide>(q: &[Lanes; 6]) -> [V; 6] {
    [V::load(&q[0]), V::load(&q[1]), V::load(&q[2]), V::load(&q[3]), V::load(&q[4]), V::load(&q[5])]
}

#[inline(always)]
pub(super) fn store6<V: Wide>(q: &[V; 6]) -> [Lanes; 6] {
    [q[0].store(), q[1].store(), q[2].store(), q[3].store(), q[4].store(), q[5].store()]
}

/// Eight of something, a number of each; what is missing at the end repeats the first.
pub(super) fn gather<T>(some: &[T], number: impl Fn(&T) -> f64) -> Lanes {
    Lanes(std::array::from_fn(|k| some.get(k).or(some.first()).map_or(0.0, &number)))
}

#[cfg(test)]
mod tests {
    use super::super::dispatch::{Kernel, Width, on};
    use super::*;

    /// Every operation there is, on numbers of all sizes.
    struct Everything([f64; LANES]);

    impl Kernel for Everything {
        type Output = [Lanes; 11];

        #[inline(always)]
        fn run<V: Wide>(self) -> [Lanes; 11] {
            let x = V::load(&Lanes(self.0));
            let (s, c) = x.sin_cos();
            let limit = V::splat(0.75);
            let results = [
                s,
                c,
                -x,
                x * s - c + x,
                V::splat(1.0) / x,
                x.size().square_root(),
                x.at_most(limit),
                x.rounded(),
            ];
            let [a, b, c, d, e, f, g, h] = results;
            let all = [a, b, c, d, e, f, g, h, x.choose(s, e), x.angle(c), x.larger(limit)];
            let mut stored = [Lanes([0.0; LANES]); 11];
            for (stored, result) in stored.iter_mut().zip(&all) {
                *stored = result.store();
            }
            assert!(x.any() == self.0.iter().any(|x| *x > 0.5));
            stored
        }
    }

    fn one(x: f64) -> [f64; 11] {
        let (s, c) = Real::sin_cos(x);
        let at_most = if x <= 0.75 { 1.0 } else { 0.0 };
        let chosen = if x > 0.5 { s } else { 1.0 / x };
        [
            s,
            c,
            -x,
            x * s - c + x,
            1.0 / x,
            x.abs().sqrt(),
            at_most,
            Real::rounded(x),
            chosen,
            Real::angle(x, -x),
            if x > 0.75 { x } else { 0.75 },
        ]
    }

    #[test]
    fn lanes_of_every_width_give_the_bits_of_one_number() {
        let rows = [
            [0.0, -0.0, 1.0, -1.0, 0.5, 0.75, 1e-300, -1e5],
            [0.1, -0.2, 0.3, -0.4, 0.2, -0.6, 0.1, -0.8],
            [3.3, 1e-9, f64::INFINITY, 7.7, f64::NAN, 4e-310, -2.5, 100.0],
        ];
        for width in Width::all() {
            for row in rows {
                let found = on(width, Everything(row));
                for (k, x) in row.into_iter().enumerate() {
                    for (found, expected) in found.iter().zip(one(x)) {
                        let both_none = found.0[k].is_nan() && expected.is_nan();
                        assert!(both_none || found.0[k].to_bits() == expected.to_bits(), "{width:?} {x}");
                    }
                }
            }
        }
    }
}
