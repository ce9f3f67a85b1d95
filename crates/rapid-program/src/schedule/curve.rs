//! A few targets' drift as polygons over time, fine enough that the corners cut off do not matter.
//!
//! On a straight piece the distance from any fixed point is convex, so its maximum over a stretch of
//! minutes stands at the stretch's ends or at a node: everything here is exact for the polygon.

use super::drift::{Drift, Moment, minus, norm, norm2};

/// Where the search for the horizon gives up: about 15 years.
const LAST_HORIZON_MIN: f64 = 8.0e6;
/// Halvings of one interval at most.
const DEEPEST: u32 = 24;

/// Drift of some targets over time, from minute 0 to where it has settled.
pub(super) struct Curve {
    /// Times of the nodes, ascending; after the last one nothing moves any more.
    t_min: Vec<f64>,
    /// Displacements, node by node, `targets` of them each, metres.
    d_m: Vec<[f64; 3]>,
    targets: usize,
}

/// The minute by which every one of `targets` stands within `rest_m` of where it will settle.
pub(super) fn horizon_min(drift: &dyn Drift, targets: &[usize], rest_m: f64) -> Option<f64> {
    let settled = drift.displacements_m(Moment::Settled, targets);
    let mut at_min = drift.bends_min().last().copied().unwrap_or(0.0).max(0.0);
    loop {
        let here = drift.displacements_m(Moment::Minute(at_min), targets);
        let rest = here.iter().zip(&settled).map(|(&a, &b)| norm2(minus(a, b))).fold(0.0, f64::max);
        if rest.sqrt() <= rest_m {
            return Some(at_min);
        }
        at_min = (2.0 * at_min).max(1.0);
        if at_min > LAST_HORIZON_MIN {
            return None;
        }
    }
}

impl Curve {
    /// The polygon through nodes so close that no target is off it by more than `sag_m`.
    pub(super) fn sample(drift: &dyn Drift, targets: &[usize], horizon_min: f64, sag_m: f64) -> Self {
        let mut curve = Self { t_min: Vec::new(), d_m: Vec::new(), targets: targets.len() };
        let mut coarse: Vec<f64> = (0..=32).map(|k| horizon_min * f64::from(k) / 32.0).collect();
        coarse.extend(drift.bends_min().iter().copied().filter(|&t| t > 0.0 && t < horizon_min));
        coarse.sort_by(f64::total_cmp);
        coarse.dedup();
        let mut left: Option<(f64, Vec<[f64; 3]>)> = None;
        for t in coarse {
            let moment = if t >= horizon_min { Moment::Settled } else { Moment::Minute(t) };
            let d = drift.displacements_m(moment, targets);
            if let Some((t_left, d_left)) = &left {
                curve.refine(drift, targets, (*t_left, d_left), (t, &d), sag_m, DEEPEST);
            }
            curve.push(t, &d);
            left = Some((t, d));
        }
        curve
    }

    fn push(&mut self, t_min: f64, d_m: &[[f64; 3]]) {
        self.t_min.push(t_min);
        self.d_m.extend_from_slice(d_m);
    }

    fn refine(
        &mut self,
        drift: &dyn Drift,
        targets: &[usize],
        left: (f64, &[[f64; 3]]),
        right: (f64, &[[f64; 3]]),
        sag_m: f64,
        depth: u32,
    ) {
        let t_mid = 0.5 * (left.0 + right.0);
        let mid = drift.displacements_m(Moment::Minute(t_mid), targets);
        let sag = (0..self.targets)
            .map(|i| {
                let chord = std::array::from_fn(|c| 0.5 * (left.1[i][c] + right.1[i][c]));
                norm2(minus(mid[i], chord))
            })
            .fold(0.0, f64::max);
        if depth == 0 || sag.sqrt() <= sag_m {
            return;
        }
        self.refine(drift, targets, left, (t_mid, &mid), sag_m, depth - 1);
        self.push(t_mid, &mid);
        self.refine(drift, targets, (t_mid, &mid), right, sag_m, depth - 1);
    }

    /// Its minutes without those that a straight line to `sag_m` can do without.
    pub(super) fn into_minutes(self, sag_m: f64) -> Vec<f64> {
        let mut kept = vec![0];
        let last = self.t_min.len() - 1;
        let mut from = 0;
        while from < last {
            // The furthest node to which a straight line is good enough for all between.
            let mut to = from + 1;
            while to < last && self.is_straight(from, to + 1, sag_m) {
                to += 1;
            }
            kept.push(to);
            from = to;
        }
        kept.dedup();
        kept.into_iter().map(|k| self.t_min[k]).collect()
    }

    fn is_straight(&self, from: usize, to: usize, sag_m: f64) -> bool {
        (from + 1..to).all(|k| {
            let s = (self.t_min[k] - self.t_min[from]) / (self.t_min[to] - self.t_min[from]);
            let chord = blend(self.node(from), self.node(to), s);
            let far = self.node(k).iter().zip(&chord).map(|(&a, &b)| norm2(minus(a, b)));
            far.fold(0.0, f64::max).sqrt() <= sag_m
        })
    }

    /// Displacements of one node.
    fn node(&self, k: usize) -> &[[f64; 3]] {
        &self.d_m[k * self.targets..(k + 1) * self.targets]
    }

    /// Where the drift has settled.
    pub(super) fn last_min(&self) -> f64 {
        self.t_min.last().copied().unwrap_or(0.0)
    }

    /// The minute of a moment, no later than where everything has settled.
    pub(super) fn minute(&self, moment: Moment) -> f64 {
        match moment {
            Moment::Minute(t) => t.min(self.last_min()),
            Moment::Settled => self.last_min(),
        }
    }

    /// Displacements at a minute.
    fn at(&self, t_min: f64) -> Vec<[f64; 3]> {
        let after = self.t_min.partition_point(|&t| t <= t_min);
        if after == 0 {
            return self.node(0).to_vec();
        }
        if after >= self.t_min.len() {
            return self.node(self.t_min.len() - 1).to_vec();
        }
        let (t0, t1) = (self.t_min[after - 1], self.t_min[after]);
        let s = (t_min - t0) / (t1 - t0);
        blend(self.node(after - 1), self.node(after), s)
    }

    /// The last moment up to which no target goes further than `limit_m` from where it is at `from_min`.
    pub(super) fn reach(&self, from_min: f64, limit_m: f64) -> Moment {
        let start = self.at(from_min);
        let mut left = start.clone();
        let mut t_left = from_min;
        let first = self.t_min.partition_point(|&t| t <= from_min);
        for k in first..self.t_min.len() {
            let right = self.node(k);
            let crossing = (0..self.targets)
                .filter_map(|i| crossing(minus(left[i], start[i]), minus(right[i], start[i]), limit_m))
                .min_by(f64::total_cmp);
            if let Some(s) = crossing {
                return Moment::Minute(t_left + s * (self.t_min[k] - t_left));
            }
            left.copy_from_slice(right);
            t_left = self.t_min[k];
        }
        Moment::Settled
    }

    /// The first minute after which no target goes further than `limit_m` from where it will settle.
    pub(super) fn settles_within(&self, limit_m: f64) -> f64 {
        let settled = self.node(self.t_min.len() - 1);
        for k in (1..self.t_min.len()).rev() {
            let (left, right) = (self.node(k - 1), self.node(k));
            let crossing = (0..self.targets)
                .filter_map(|i| crossing(minus(right[i], settled[i]), minus(left[i], settled[i]), limit_m))
                .min_by(f64::total_cmp);
            if let Some(s) = crossing {
                return self.t_min[k] - s * (self.t_min[k] - self.t_min[k - 1]);
            }
        }
        0.0
    }

    /// A stretch of minutes with its ends, ready to be asked.
    pub(super) fn stretch(&self, from_min: f64, to: Moment) -> Stretch {
        let from_min = from_min.min(self.last_min());
        let to_min = self.minute(to).max(from_min);
        let first = self.t_min.partition_point(|&t| t <= from_min);
        let end = self.t_min.partition_point(|&t| t < to_min);
        let mut stretch = Stretch { t_min: vec![from_min], d_m: self.at(from_min), targets: self.targets };
        for k in first..end {
            stretch.t_min.push(self.t_min[k]);
            stretch.d_m.extend_from_slice(self.node(k));
        }
        if to_min > from_min {
            stretch.t_min.push(to_min);
            stretch.d_m.extend(self.at(to_min));
        }
        stretch
    }
}

/// A stretch of a curve.
pub(super) struct Stretch {
    t_min: Vec<f64>,
    d_m: Vec<[f64; 3]>,
    targets: usize,
}

impl Stretch {
    fn node(&self, k: usize) -> &[[f64; 3]] {
        &self.d_m[k * self.targets..(k + 1) * self.targets]
    }

    /// The largest distance of any target from its place `d_m` over the stretch; stops counting above
    /// `enough_m`. The ends come first: they are where the worst usually stands.
    fn radius(&self, d_m: &[[f64; 3]], enough_m: f64) -> f64 {
        let last = self.t_min.len() - 1;
        let enough = enough_m * enough_m;
        let mut worst: f64 = 0.0;
        for k in std::iter::once(last).chain(0..last) {
            for (&a, &b) in self.node(k).iter().zip(d_m) {
                worst = worst.max(norm2(minus(a, b)));
            }
            if worst > enough {
                break;
            }
        }
        worst.sqrt()
    }

    /// The largest distance over the stretch when the targets are right at `at_min`.
    pub(super) fn radius_at(&self, at_min: f64) -> f64 {
        let k = self.t_min.partition_point(|&t| t <= at_min).clamp(1, self.t_min.len().max(2) - 1);
        if self.t_min.len() < 2 {
            return 0.0;
        }
        let s = (at_min - self.t_min[k - 1]) / (self.t_min[k] - self.t_min[k - 1]);
        self.radius(&blend(self.node(k - 1), self.node(k), s), f64::INFINITY)
    }

    /// The minute of the stretch to be right at so that the largest distance over it is least, and that
    /// distance: `(at_min, radius_m)`.
    pub(super) fn center(&self) -> (f64, f64) {
        let mut best = (self.t_min[0], f64::INFINITY);
        let mut lower = Vec::with_capacity(self.t_min.len());
        for k in 0..self.t_min.len() {
            let radius = self.radius(self.node(k), best.1);
            lower.push(radius);
            if radius < best.1 {
                best = (self.t_min[k], radius);
            }
        }
        for k in 1..self.t_min.len() {
            // Within a piece the radius falls below its ends' by no more than the piece is long.
            let length = (0..self.targets)
                .map(|i| norm2(minus(self.node(k)[i], self.node(k - 1)[i])))
                .fold(0.0, f64::max)
                .sqrt();
            if lower[k].max(lower[k - 1]) - length < best.1 {
                self.center_of_piece(k, &mut best);
            }
        }
        best
    }

    /// Golden-section search on the piece that ends at node `k`: the radius is convex there.
    fn center_of_piece(&self, k: usize, best: &mut (f64, f64)) {
        const GOLDEN: f64 = 0.618_033_988_749_894_9;
        let value = |s: f64| self.radius(&blend(self.node(k - 1), self.node(k), s), f64::INFINITY);
        let (mut a, mut b) = (0.0, 1.0);
        let (mut x, mut y) = (b - GOLDEN * (b - a), a + GOLDEN * (b - a));
        let (mut fx, mut fy) = (value(x), value(y));
        for _ in 0..28 {
            if fx <= fy {
                (b, y, fy) = (y, x, fx);
                x = b - GOLDEN * (b - a);
                fx = value(x);
            } else {
                (a, x, fx) = (x, y, fy);
                y = a + GOLDEN * (b - a);
                fy = value(y);
            }
        }
        let (s, f) = if fx <= fy { (x, fx) } else { (y, fy) };
        if f < best.1 {
            *best = (self.t_min[k - 1] + s * (self.t_min[k] - self.t_min[k - 1]), f);
        }
    }
}

fn blend(a: &[[f64; 3]], b: &[[f64; 3]], s: f64) -> Vec<[f64; 3]> {
    a.iter().zip(b).map(|(a, b)| std::array::from_fn(|c| a[c] + s * (b[c] - a[c]))).collect()
}

/// Where on the way from `a` to `b` the distance from the origin first exceeds `limit`: 0..1.
fn crossing(a: [f64; 3], b: [f64; 3], limit: f64) -> Option<f64> {
    if norm(b) <= limit {
        return None;
    }
    let v = minus(b, a);
    let (vv, av) = (norm2(v), a[0] * v[0] + a[1] * v[1] + a[2] * v[2]);
    let rest = norm2(a) - limit * limit;
    if rest >= 0.0 || vv == 0.0 {
        return Some(0.0);
    }
    Some(((-av + (av * av - vv * rest).sqrt()) / vv).clamp(0.0, 1.0))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_straight_way_leaves_a_ball_where_the_quadratic_says() {
        // From (1, 0, 0) along x leaves the ball of radius 3 at x = 3: half of the way to 5.
        assert_eq!(crossing([1.0, 0.0, 0.0], [5.0, 0.0, 0.0], 3.0), Some(0.5));
        assert_eq!(crossing([1.0, 0.0, 0.0], [2.0, 0.0, 0.0], 3.0), None);
        // Across: (0, 0) to (0, 5) meets 3 at 3/5.
        assert_eq!(crossing([0.0; 3], [0.0, 5.0, 0.0], 3.0), Some(0.6));
    }
}
