//! A few targets' drift as polygons over time, fine enough that the corners cut off do not matter.
//!
//! On a straight piece the distance from any fixed point is convex, so its maximum over a stretch of
//! minutes stands at the stretch's ends or at a node: everything here is exact for the polygon.

use super::drift::{Displacements, Moment, minus, norm, norm2};

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

/// The minute by which all that drift stand within `rest_m` of where they will settle; no earlier than the last of `knots_min`.
pub(super) fn horizon_min(
    displacements_m: &Displacements<'_>,
    knots_min: &[f64],
    rest_m: f64,
) -> Option<f64> {
    let settled = displacements_m(Moment::Settled);
    let mut at_min = knots_min.last().copied().unwrap_or(0.0).max(0.0);
    loop {
        let here = displacements_m(Moment::Minute(at_min));
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
    pub(super) fn sample(
        displacements_m: &Displacements<'_>,
        knots_min: &[f64],
        horizon_min: f64,
        sag_m: f64,
    ) -> Self {
        let mut curve = Self { t_min: Vec::new(), d_m: Vec::new(), targets: 0 };
        let mut coarse: Vec<f64> = (0..=32).map(|k| horizon_min * f64::from(k) / 32.0).collect();
        coarse.extend(knots_min.iter().copied().filter(|&t| t > 0.0 && t < horizon_min));
        sorting::numbers(&mut coarse);
        coarse.dedup();
        let mut left: Option<(f64, Vec<[f64; 3]>)> = None;
        for t in coarse {
            let moment = if t >= horizon_min { Moment::Settled } else { Moment::Minute(t) };
            let d = displacements_m(moment);
            curve.targets = d.len();
            if let Some((t_left, d_left)) = &left {
                curve.refine(displacements_m, (*t_left, d_left), (t, &d), sag_m, DEEPEST);
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
        displacements_m: &Displacements<'_>,
        left: (f64, &[[f64; 3]]),
        right: (f64, &[[f64; 3]]),
        sag_m: f64,
        depth: u32,
    ) {
        let t_mid = 0.5 * (left.0 + right.0);
        let mid = displacements_m(Moment::Minute(t_mid));
        let sag = (0..self.targets)
            .map(|i| {
                let chord = std::array::from_fn(|c| 0.5 * (left.1[i][c] + right.1[i][c]));
                norm2(minus(mid[i], chord))
            })
            .fold(0.0, f64::max);
        if depth == 0 || sag.sqrt() <= sag_m {
            return;
        }
        self.refine(displacements_m, left, (t_mid, &mid), sag_m, depth - 1);
        self.push(t_mid, &mid);
        self.refine(displacements_m, (t_mid, &mid), right, sag_m, depth - 1);
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
    pub(super) fn stretch(&self, from_min: f64, to: Moment) -> Stretch<'_> {
        let from_min = from_min.min(self.last_min());
        let to_min = self.minute(to).max(from_min);
        let first = self.t_min.partition_point(|&t| t <= from_min);
        let end = self.t_min.partition_point(|&t| t < to_min).max(first);
        Stretch {
            curve: self,
            inner: first..end,
            from: (from_min, self.at(from_min)),
            to: (to_min > from_min).then(|| (to_min, self.at(to_min))),
        }
    }
}

/// A stretch of a curve: its own ends, and the curve's nodes between them.
pub(super) struct Stretch<'a> {
    curve: &'a Curve,
    /// Nodes of the curve that lie inside.
    inner: std::ops::Range<usize>,
    /// Its start, and its end where that is another minute.
    from: (f64, Vec<[f64; 3]>),
    to: Option<(f64, Vec<[f64; 3]>)>,
}

impl Stretch<'_> {
    /// How many nodes it has, its ends among them.
    fn len(&self) -> usize {
        1 + self.inner.len() + usize::from(self.to.is_some())
    }

    /// Minute and displacements of node `k`.
    fn node(&self, k: usize) -> (f64, &[[f64; 3]]) {
        let end = self.to.as_ref().filter(|_| k > self.inner.len()).unwrap_or(&self.from);
        match k {
            0 => (self.from.0, &self.from.1),
            k if k <= self.inner.len() => {
                let k = self.inner.start + k - 1;
                (self.curve.t_min[k], self.curve.node(k))
            }
            _ => (end.0, &end.1),
        }
    }

    /// The displacements between node `k - 1` and node `k`, a share `s` of the way, into `out`.
    fn blend_into(&self, k: usize, s: f64, out: &mut Vec<[f64; 3]>) {
        out.clear();
        out.extend(blended(self.node(k - 1).1, self.node(k).1, s));
    }

    /// The largest distance of any target from its place `d_m` over the stretch; stops counting above
    /// `enough_m`. The ends come first: they are where the worst usually stands.
    fn radius(&self, d_m: &[[f64; 3]], enough_m: f64) -> f64 {
        let enough = enough_m * enough_m;
        let furthest = |worst: f64, node: &[[f64; 3]]| {
            // Not `f64::max`, which looks for NaN in both.
            node.iter().zip(d_m).fold(worst, |worst, (&a, &b)| {
                let apart = norm2(minus(a, b));
                if apart > worst { apart } else { worst }
            })
        };
        let mut worst = self.to.iter().fold(0.0, |worst, (_, end)| furthest(worst, end));
        worst = if worst > enough { worst } else { furthest(worst, &self.from.1) };
        let targets = self.curve.targets;
        let inner = &self.curve.d_m[self.inner.start * targets..self.inner.end * targets];
        for node in inner.chunks_exact(targets.max(1)) {
            if worst > enough {
                break;
            }
            worst = furthest(worst, node);
        }
        worst.sqrt()
    }

    /// The largest distance over the stretch when the targets are right at `at_min`.
    pub(super) fn radius_at(&self, at_min: f64) -> f64 {
        let len = self.len();
        if len < 2 {
            return 0.0;
        }
        let k = (1..len).find(|&k| self.node(k).0 > at_min).unwrap_or(len - 1);
        let (t_left, t_right) = (self.node(k - 1).0, self.node(k).0);
        let mut place = Vec::with_capacity(self.curve.targets);
        self.blend_into(k, (at_min - t_left) / (t_right - t_left), &mut place);
        self.radius(&place, f64::INFINITY)
    }

    /// The minute of the stretch to be right at so that the largest distance over it is least, and that
    /// distance: `(at_min, radius_m)`.
    pub(super) fn center(&self) -> (f64, f64) {
        self.least((self.node(0).0, f64::INFINITY), |_| false)
    }

    /// Whether the stretch has a minute at which no target is further off than `limit_m` all over it.
    pub(super) fn fits(&self, limit_m: f64) -> bool {
        // Nothing above the limit is of interest, and the first minute within it is enough.
        let above = (self.node(0).0, limit_m * (1.0 + 1e-12));
        self.least(above, |radius_m| radius_m <= limit_m).1 <= limit_m
    }

    /// The best minute and its radius where that is under `best`'s; the first that is `enough`.
    fn least(&self, mut best: (f64, f64), enough: impl Fn(f64) -> bool) -> (f64, f64) {
        let len = self.len();
        let mut lower = Vec::with_capacity(len);
        for k in 0..len {
            let (t_min, d_m) = self.node(k);
            let radius = self.radius(d_m, best.1);
            lower.push(radius);
            if radius < best.1 {
                best = (t_min, radius);
            }
            if enough(best.1) {
                return best;
            }
        }
        let mut place = Vec::with_capacity(self.curve.targets);
        for k in 1..len {
            // Within a piece the radius falls below its ends' by no more than the piece is long.
            let (left, right) = (self.node(k - 1).1, self.node(k).1);
            let far = left.iter().zip(right).map(|(&a, &b)| norm2(minus(a, b)));
            let length = far.fold(0.0, f64::max).sqrt();
            if lower[k].max(lower[k - 1]) - length < best.1 {
                self.center_of_piece(k, &mut best, &enough, &mut place);
            }
            if enough(best.1) {
                return best;
            }
        }
        best
    }

    /// Golden-section search on the piece that ends at node `k`: the radius is convex there.
    fn center_of_piece(
        &self,
        k: usize,
        best: &mut (f64, f64),
        enough: impl Fn(f64) -> bool,
        place: &mut Vec<[f64; 3]>,
    ) {
        const GOLDEN: f64 = 0.618_033_988_749_894_9;
        let mut value = |s: f64| {
            self.blend_into(k, s, place);
            self.radius(place, f64::INFINITY)
        };
        let (mut a, mut b) = (0.0, 1.0);
        let (mut x, mut y) = (b - GOLDEN * (b - a), a + GOLDEN * (b - a));
        let (mut fx, mut fy) = (value(x), value(y));
        for _ in 0..28 {
            if enough(fx.min(fy)) {
                break;
            }
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
            let (t_left, t_right) = (self.node(k - 1).0, self.node(k).0);
            *best = (t_left + s * (t_right - t_left), f);
        }
    }
}

fn blended<'d>(a: &'d [[f64; 3]], b: &'d [[f64; 3]], s: f64) -> impl Iterator<Item = [f64; 3]> + 'd {
    a.iter().zip(b).map(move |(a, b)| std::array::from_fn(|c| a[c] + s * (b[c] - a[c])))
}

fn blend(a: &[[f64; 3]], b: &[[f64; 3]], s: f64) -> Vec<[f64; 3]> {
    blended(a, b, s).collect()
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
