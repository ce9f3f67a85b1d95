//! The widest vectors that the machine has, chosen while the program runs: AVX-512, AVX2, or plain arrays.
//!
//! All of them give the same bits: each operation is IEEE's own on each of eight numbers, or one on its bits, and none is fused
//! (neither function below may use FMA, and the compiler fuses nothing by itself).
//!
//! `unsafe` stands here alone. What makes it sound: a function marked `target_feature` is called only after the processor
//! was asked for exactly that feature; the vector types are private to this file and reach a [`Kernel`] only through those
//! functions, so that no intrinsic runs without it; and no pointer is taken but to the 64 aligned bytes of a [`Lanes`] and to four
//! numbers on the stack.

#![allow(unsafe_code, reason = "intrinsics need it; the argument stands above")]

use super::lanes::{Column, Lanes, Register, Wide};

/// Work on eight numbers at a time.
pub(crate) trait Kernel {
    type Output;
    /// Must be `#[inline(always)]`: what it calls is compiled for the vectors of its caller.
    fn run<V: Wide>(self) -> Self::Output;
}

/// Which vectors the kernels run on.
#[cfg(test)]
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Width {
    /// Plain arrays `[f64; 8]`.
    Portable,
    /// Two registers of four.
    #[cfg(target_arch = "x86_64")]
    Avx2,
    /// One register of eight.
    #[cfg(target_arch = "x86_64")]
    Avx512,
}

#[cfg(test)]
impl Width {
    /// Those the machine has, the widest last.
    pub(crate) fn all() -> impl Iterator<Item = Self> {
        #[cfg(target_arch = "x86_64")]
        let wide = [
            is_x86_feature_detected!("avx2").then_some(Self::Avx2),
            is_x86_feature_detected!("avx512f").then_some(Self::Avx512),
        ];
        #[cfg(not(target_arch = "x86_64"))]
        let wide: [Option<Self>; 0] = [];
        [Self::Portable].into_iter().chain(wide.into_iter().flatten())
    }
}

/// Whether the machine has vectors on which eight numbers cost less than one after the other.
pub(crate) fn is_wide() -> bool {
    #[cfg(target_arch = "x86_64")]
    return is_x86_feature_detected!("avx2");
    #[cfg(not(target_arch = "x86_64"))]
    false
}

/// Runs a kernel on the widest vectors that the machine has.
#[inline]
pub(crate) fn on_widest<K: Kernel>(kernel: K) -> K::Output {
    #[cfg(target_arch = "x86_64")]
    {
        if is_x86_feature_detected!("avx512f") {
            // SAFETY: the processor has AVX-512F.
            return unsafe { x86::on_avx512(kernel) };
        }
        if is_x86_feature_detected!("avx2") {
            // SAFETY: the processor has AVX2.
            return unsafe { x86::on_avx2(kernel) };
        }
    }
    kernel.run::<Lanes>()
}

/// The same for a kernel whose operations wait for each other and take single numbers out of vectors: registers of four, on which that
/// took half of the time that it took on registers of eight.
#[inline]
pub(crate) fn on_quickest<K: Kernel>(kernel: K) -> K::Output {
    #[cfg(target_arch = "x86_64")]
    if is_x86_feature_detected!("avx2") {
        // SAFETY: the processor has AVX2.
        return unsafe { x86::on_avx2(kernel) };
    }
    kernel.run::<Lanes>()
}

/// Runs a kernel on vectors of [`Width::all`]; on others than the machine has, on plain arrays.
#[cfg(test)]
pub(crate) fn on<K: Kernel>(width: Width, kernel: K) -> K::Output {
    match width {
        #[cfg(target_arch = "x86_64")]
        // SAFETY: the processor has AVX-512F.
        Width::Avx512 if is_x86_feature_detected!("avx512f") => unsafe { x86::on_avx512(kernel) },
        #[cfg(target_arch = "x86_64")]
        // SAFETY: the processor has AVX2.
        Width::Avx2 if is_x86_feature_detected!("avx2") => unsafe { x86::on_avx2(kernel) },
        _ => kernel.run::<Lanes>(),
    }
}

#[cfg(target_arch = "x86_64")]
mod x86 {
    use super::super::real::Real;
    use super::{Column, Kernel, Lanes, Register, Wide};
    use std::arch::x86_64::*;
    use std::ops::{Add, Div, Mul, Neg, Sub};

    #[target_feature(enable = "avx512f")]
    pub(super) fn on_avx512<K: Kernel>(kernel: K) -> K::Output {
        kernel.run::<Eight>()
    }

    #[target_feature(enable = "avx2")]
    pub(super) fn on_avx2<K: Kernel>(kernel: K) -> K::Output {
        kernel.run::<TwiceFour>()
    }

    /// Made only within [`on_avx512`]: whoever has one may use AVX-512F.
    #[derive(Clone, Copy)]
    struct Eight(__m512d);

    /// Made only within [`on_avx2`]: whoever has one may use AVX2.
    #[derive(Clone, Copy)]
    struct TwiceFour(__m256d, __m256d);

    /// Made only within [`on_avx512`] or [`on_avx2`]: whoever has one may use AVX.
    #[derive(Clone, Copy)]
    struct OneFour(__m256d);

    macro_rules! elementwise {
        ($trait:ident, $method:ident, $eight:ident, $four:ident) => {
            impl $trait for Eight {
                type Output = Self;
                #[inline(always)]
                fn $method(self, other: Self) -> Self {
                    // SAFETY: there is an `Eight`, so there is AVX-512F.
                    Self(unsafe { $eight(self.0, other.0) })
                }
            }
            impl $trait for TwiceFour {
                type Output = Self;
                #[inline(always)]
                fn $method(self, other: Self) -> Self {
                    // SAFETY: there is a `TwiceFour`, so there is AVX2.
                    unsafe { Self($four(self.0, other.0), $four(self.1, other.1)) }
                }
            }
            impl $trait for OneFour {
                type Output = Self;
                #[inline(always)]
                fn $method(self, other: Self) -> Self {
                    // SAFETY: there is a `OneFour`, so there is AVX.
                    Self(unsafe { $four(self.0, other.0) })
                }
            }
        };
    }

    elementwise!(Add, add, _mm512_add_pd, _mm256_add_pd);
    elementwise!(Sub, sub, _mm512_sub_pd, _mm256_sub_pd);
    elementwise!(Mul, mul, _mm512_mul_pd, _mm256_mul_pd);
    elementwise!(Div, div, _mm512_div_pd, _mm256_div_pd);

    // SAFETY of all that follows: as above; what makes the first of them, `splat` and `load`, runs within `on_avx512` or
    // `on_avx2`.
    impl Neg for Eight {
        type Output = Self;
        #[inline(always)]
        fn neg(self) -> Self {
            // Minus zero minus x is minus x, for both zeros too.
            Self::splat(-0.0) - self
        }
    }

    impl Real for Eight {
        #[inline(always)]
        fn splat(value: f64) -> Self {
            Self(unsafe { _mm512_set1_pd(value) })
        }

        #[inline(always)]
        fn square_root(self) -> Self {
            Self(unsafe { _mm512_sqrt_pd(self.0) })
        }

        #[inline(always)]
        fn size(self) -> Self {
            Self(unsafe { _mm512_abs_pd(self.0) })
        }

        #[inline(always)]
        fn at_most(self, limit: Self) -> Self {
            unsafe {
                let yes = _mm512_cmp_pd_mask::<_CMP_LE_OQ>(self.0, limit.0);
                Self(_mm512_maskz_mov_pd(yes, _mm512_set1_pd(1.0)))
            }
        }

        #[inline(always)]
        fn choose(self, yes: Self, no: Self) -> Self {
            unsafe {
                let which = _mm512_cmp_pd_mask::<_CMP_GT_OQ>(self.0, _mm512_set1_pd(0.5));
                Self(_mm512_mask_blend_pd(which, no.0, yes.0))
            }
        }

        #[inline(always)]
        fn larger(self, other: Self) -> Self {
            Self(unsafe { _mm512_max_pd(self.0, other.0) })
        }

        #[inline(always)]
        fn turned_by_quarters(quarters: Self, sin: Self, cos: Self) -> (Self, Self) {
            unsafe {
                let k = _mm512_castpd_si512(quarters.0);
                let one = _mm512_set1_epi64(1);
                let odd = _mm512_test_epi64_mask(k, one);
                let sine = Self(_mm512_mask_blend_pd(odd, sin.0, cos.0));
                let cosine = Self(_mm512_mask_blend_pd(odd, cos.0, sin.0));
                (sine.changed_by(k), cosine.changed_by(_mm512_add_epi64(k, one)))
            }
        }
    }

    impl Eight {
        /// The other sign where the second bit is one.
        #[inline(always)]
        fn changed_by(self, k: __m512i) -> Self {
            unsafe {
                let sign = _mm512_and_si512(_mm512_slli_epi64::<62>(k), _mm512_set1_epi64(i64::MIN));
                Self(_mm512_castsi512_pd(_mm512_xor_si512(_mm512_castpd_si512(self.0), sign)))
            }
        }
    }

    impl Column for OneFour {
        #[inline(always)]
        fn splat(value: f64) -> Self {
            Self(unsafe { _mm256_set1_pd(value) })
        }

        #[inline(always)]
        fn load(&[x, y, z]: &[f64; 3]) -> Self {
            Self(unsafe { _mm256_setr_pd(x, y, z, 0.0) })
        }
    }

    impl Register for OneFour {
        #[inline(always)]
        fn store(self) -> [f64; 4] {
            let mut values = [0.0; 4];
            unsafe { _mm256_storeu_pd(values.as_mut_ptr(), self.0) };
            values
        }
    }

    impl Wide for Eight {
        type Column = OneFour;

        #[inline(always)]
        fn load(values: &Lanes) -> Self {
            Self(unsafe { _mm512_loadu_pd(values.0.as_ptr()) })
        }

        #[inline(always)]
        fn store(self) -> Lanes {
            let mut values = Lanes([0.0; 8]);
            unsafe { _mm512_storeu_pd(values.0.as_mut_ptr(), self.0) };
            values
        }

        #[inline(always)]
        fn any(self) -> bool {
            unsafe { _mm512_cmp_pd_mask::<_CMP_GT_OQ>(self.0, _mm512_set1_pd(0.5)) != 0 }
        }
    }

    impl TwiceFour {
        #[inline(always)]
        fn each(self, work: impl Fn(__m256d) -> __m256d) -> Self {
            Self(work(self.0), work(self.1))
        }
    }

    impl Neg for TwiceFour {
        type Output = Self;
        #[inline(always)]
        fn neg(self) -> Self {
            Self::splat(-0.0) - self
        }
    }

    impl Real for TwiceFour {
        #[inline(always)]
        fn splat(value: f64) -> Self {
            let four = unsafe { _mm256_set1_pd(value) };
            Self(four, four)
        }

        #[inline(always)]
        fn square_root(self) -> Self {
            self.each(|x| unsafe { _mm256_sqrt_pd(x) })
        }

        #[inline(always)]
        fn size(self) -> Self {
            self.each(|x| unsafe { _mm256_andnot_pd(_mm256_set1_pd(-0.0), x) })
        }

        #[inline(always)]
        fn at_most(self, limit: Self) -> Self {
            let compare = |x, limit| unsafe {
                _mm256_and_pd(_mm256_cmp_pd::<_CMP_LE_OQ>(x, limit), _mm256_set1_pd(1.0))
            };
            Self(compare(self.0, limit.0), compare(self.1, limit.1))
        }

        #[inline(always)]
        fn choose(self, yes: Self, no: Self) -> Self {
            let choose = |which, yes, no| unsafe {
                _mm256_blendv_pd(no, yes, _mm256_cmp_pd::<_CMP_GT_OQ>(which, _mm256_set1_pd(0.5)))
            };
            Self(choose(self.0, yes.0, no.0), choose(self.1, yes.1, no.1))
        }

        #[inline(always)]
        fn larger(self, other: Self) -> Self {
            unsafe { Self(_mm256_max_pd(self.0, other.0), _mm256_max_pd(self.1, other.1)) }
        }

        #[inline(always)]
        fn turned_by_quarters(quarters: Self, sin: Self, cos: Self) -> (Self, Self) {
            let low = turned_four(quarters.0, sin.0, cos.0);
            let high = turned_four(quarters.1, sin.1, cos.1);
            (Self(low.0, high.0), Self(low.1, high.1))
        }
    }

    // Functions, for closures are not always inlined, and without AVX2 each of these would be a call.

    /// [`Real::turned_by_quarters`] of four.
    #[inline(always)]
    fn turned_four(quarters: __m256d, sin: __m256d, cos: __m256d) -> (__m256d, __m256d) {
        unsafe {
            let k = _mm256_castpd_si256(quarters);
            let odd = _mm256_castsi256_pd(_mm256_slli_epi64::<63>(k));
            let sine = changed_four(_mm256_blendv_pd(sin, cos, odd), k);
            let behind = _mm256_add_epi64(k, _mm256_set1_epi64x(1));
            (sine, changed_four(_mm256_blendv_pd(cos, sin, odd), behind))
        }
    }

    /// The other sign where the second bit is one.
    #[inline(always)]
    fn changed_four(value: __m256d, k: __m256i) -> __m256d {
        unsafe {
            let sign = _mm256_and_si256(_mm256_slli_epi64::<62>(k), _mm256_set1_epi64x(i64::MIN));
            _mm256_xor_pd(value, _mm256_castsi256_pd(sign))
        }
    }

    impl Wide for TwiceFour {
        type Column = OneFour;

        #[inline(always)]
        fn load(values: &Lanes) -> Self {
            let [a, b, c, d, e, f, g, h] = values.0;
            unsafe { Self(_mm256_setr_pd(a, b, c, d), _mm256_setr_pd(e, f, g, h)) }
        }

        #[inline(always)]
        fn store(self) -> Lanes {
            let mut values = Lanes([0.0; 8]);
            let (low, high) = values.0.split_at_mut(4);
            unsafe {
                _mm256_storeu_pd(low.as_mut_ptr(), self.0);
                _mm256_storeu_pd(high.as_mut_ptr(), self.1);
            }
            values
        }

        #[inline(always)]
        fn any(self) -> bool {
            let any = |four| unsafe {
                _mm256_movemask_pd(_mm256_cmp_pd::<_CMP_GT_OQ>(four, _mm256_set1_pd(0.5))) != 0
            };
            any(self.0) || any(self.1)
        }
    }
}
