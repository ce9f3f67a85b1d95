//! Corrected targets as RAPID text, beside what the standard library's formatting makes of the same numbers.

use rapid_compensation::emit::write_pos;
use rapid_syntax::write_list;
use std::fmt::Write as _;

/// Position (m) and orientation (w first, of length one) of a target.
pub type Target = ([f64; 3], [f64; 4]);

/// How many numbers a target's text holds.
pub const NUMBERS: usize = 7;

/// Targets of the paper's cube as a warm-up moves them: up to 0.2 mm and 0.3 mrad beside where they were meant.
pub fn targets() -> Vec<Target> {
    let one = |k: usize| {
        let off = |n: usize| ((k * 7 + n) as f64 * 12.9898).sin();
        let at = [0.4, -0.15, 0.25];
        let position_m = std::array::from_fn(|i| at[i] + 0.15 * (k % 3) as f64 + 2e-4 * off(i));
        let [w, x, y, z] = [0.5_f64.sqrt(), 1.5e-4 * off(3), 0.5_f64.sqrt(), 1.5e-4 * off(4)];
        let length = (w * w + x * x + y * y + z * z).sqrt();
        (position_m, [w, x, y, z].map(|part| part / length))
    };
    (0..1000).map(one).collect()
}

/// As a compensated program has them.
pub fn ours(targets: &[Target], out: &mut Vec<u8>) {
    for (position_m, wxyz) in targets {
        write_pos(out, *position_m);
        write_list(out, *wxyz);
    }
}

/// The shortest digits of the same single-precision numbers, by `{}`.
pub fn by_std(targets: &[Target], out: &mut String) {
    for ([x, y, z], [a, b, c, d]) in targets {
        let [x, y, z] = [x, y, z].map(|m| (m * 1000.0) as f32);
        let [a, b, c, d] = [a, b, c, d].map(|part| *part as f32);
        _ = write!(out, "[{x},{y},{z}][{a},{b},{c},{d}]"); // writing to a String does not fail
    }
}
