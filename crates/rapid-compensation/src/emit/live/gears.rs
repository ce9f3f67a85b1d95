//! Gear lines as RAPID: sines and cosines of a joint's multiples from those of the joint by products, no function a line.

use super::deformation::LiveModel;
use super::gravity::{cosine, sine};
use super::text::{Body, Summand, num, sum};
use super::turns::Turn;
use robot_model::units::rad_from_deg;
use std::collections::{BTreeMap, BTreeSet};

/// Lines and gains that change by more than this with the joint (rad/rad) are looked at once more, at the corrected joints.
const STEEP: f64 = 1e-4;
/// Lines of more periods a turn may go through a good part of one by a correction: their change is carried to fourth order.
const FOURTH_ORDER_FROM: u32 = 20;

/// The lines of a joint: periods in a turn, weights of sine and cosine (rad), those of one number together.
pub(super) fn lines(model: &LiveModel, joint: usize) -> BTreeMap<u32, [f64; 2]> {
    let mut lines: BTreeMap<u32, [f64; 2]> = BTreeMap::new();
    for turn in &model.turns[joint] {
        if let Turn::Gear { n, sin_rad, cos_rad } = *turn {
            let [sin, cos] = lines.entry(n).or_default();
            *sin += sin_rad;
            *cos += cos_rad;
        }
    }
    lines.retain(|_, [sin, cos]| *sin != 0.0 || *cos != 0.0);
    lines
}

/// Statements for the lines of a joint whose sine and cosine are there: what each turns it by. Gives the sum.
pub(super) fn body(model: &LiveModel, joint: usize, sign: f64, body: &mut Body) -> Vec<Summand> {
    let lines = lines(model, joint);
    let mut known = BTreeSet::from([1]);
    for n in lines.keys() {
        multiple(joint, *n, &mut known, body);
    }
    let turned = |(n, by): (&u32, &[f64; 2])| {
        let summands = [(by[0], multiple_name(sine, joint, *n)), (by[1], multiple_name(cosine, joint, *n))];
        if model.looks_again() && is_steep(*n, by) {
            body.set(&line_name(joint, *n), &summands);
            vec![(sign, line_name(joint, *n))]
        } else {
            summands.into_iter().map(|(by, name)| (sign * by, name)).collect()
        }
    };
    lines.iter().flat_map(turned).collect()
}

/// Statements for what lines and gains of a joint turn it by more where the joints are `tcJ` in place of `tcQ`; gives the sum.
pub(super) fn change(model: &LiveModel, joint: usize, sign: f64, body: &mut Body) -> Vec<Summand> {
    let mut summands = Vec::new();
    for turn in &model.turns[joint] {
        if let Turn::Gain { by, gain } = *turn
            && gain.abs() > STEEP
        {
            let n = by + 1;
            summands.push((sign * gain * rad_from_deg(1.0), format!("(tcJ.rax_{n}-tcQ.rax_{n})")));
        }
    }
    let lines = lines(model, joint);
    let steep: Vec<_> = lines.iter().filter(|(n, by)| is_steep(**n, by)).collect();
    if steep.is_empty() {
        return summands;
    }
    let k = joint + 1;
    body.line(format!("tcE:={}*(tcJ.rax_{k}-tcQ.rax_{k});", num(rad_from_deg(1.0))));
    for (n, by) in steep {
        let [sin, cos] = [multiple_name(sine, joint, *n), multiple_name(cosine, joint, *n)];
        let slope = sum(&[(by[0], cos), (-by[1], sin)]);
        let line = line_name(joint, *n);
        body.set("tcA", &[(f64::from(*n), "tcE".to_owned())]);
        if *n > FOURTH_ORDER_FROM {
            body.line("tcB:=tcA*tcA;");
            body.line(format!("{line}:=tcA*(1-tcB/6)*({slope})-tcB*(0.5-tcB/24)*{line};"));
        } else {
            body.line(format!("{line}:=tcA*({slope}-0.5*tcA*{line});"));
        }
        summands.push((sign, line));
    }
    summands
}

/// Statements for sine and cosine of `n` times the joint, where they are not there yet: of the half doubled, or of two together.
fn multiple(joint: usize, n: u32, known: &mut BTreeSet<u32>, body: &mut Body) {
    if known.contains(&n) || n == 0 {
        return;
    }
    let [sin, cos] = [sine, cosine].map(|of| multiple_name(of, joint, n));
    let both = known.iter().copied().find(|a| *a < n && known.contains(&(n - a)) && 2 * a != n);
    if n.is_multiple_of(2) && (both.is_none() || known.contains(&(n / 2))) {
        multiple(joint, n / 2, known, body);
        let [half_sin, half_cos] = [sine, cosine].map(|of| multiple_name(of, joint, n / 2));
        body.line(format!("{sin}:=2*{half_sin}*{half_cos};"));
        body.line(format!("{cos}:=1-2*{half_sin}*{half_sin};"));
    } else {
        let a = both.unwrap_or(1);
        multiple(joint, n - a, known, body);
        let [sin_a, cos_a] = [sine, cosine].map(|of| multiple_name(of, joint, a));
        let [sin_b, cos_b] = [sine, cosine].map(|of| multiple_name(of, joint, n - a));
        body.line(format!("{sin}:={sin_a}*{cos_b}+{cos_a}*{sin_b};"));
        body.line(format!("{cos}:={cos_a}*{cos_b}-{sin_a}*{sin_b};"));
    }
    known.insert(n);
}

/// The name of the sine or the cosine of `n` times a joint.
fn multiple_name(of: fn(usize) -> String, joint: usize, n: u32) -> String {
    if n == 1 { of(joint) } else { format!("{}_{n}", of(joint)) }
}

/// The name of what a line turns its joint by.
fn line_name(joint: usize, n: u32) -> String {
    format!("tcG{}_{n}", joint + 1)
}

fn is_steep(n: u32, [sin_rad, cos_rad]: &[f64; 2]) -> bool {
    f64::from(n) * sin_rad.hypot(*cos_rad) > STEEP
}
