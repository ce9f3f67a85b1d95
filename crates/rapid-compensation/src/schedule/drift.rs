//! What a schedule is chosen from: how far each target drifts, and how far off a corrected one is.

/// A warm-up minute, or the end of all drift.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Moment {
    /// So many minutes since the cold start.
    Minute(f64),
    /// When everything has settled.
    Settled,
}

/// Displacements as a function of the moment.
pub type Displacements<'a> = Box<dyn Fn(Moment) -> Vec<[f64; 3]> + 'a>;

/// Targets that drift with warm-up time.
pub trait Drift {
    /// How many targets there are.
    fn targets(&self) -> usize;

    /// How far the uncorrected TCP stands from each of `targets` at any moment, as vectors in one frame,
    /// metres; in the order of `targets`.
    fn displacements_m(&self, targets: &[usize]) -> Displacements<'_>;

    /// For each pair of moments the target whose displacement differs most between the two, the first of equals, and by how
    /// much, metres.
    fn furthest(&self, pairs: &[(Moment, Moment)]) -> Vec<(usize, f64)>;

    /// The worst distance over `moments` of each of `targets`' TCP from where it is meant to be, when it
    /// is corrected for `at_min`: exact, by forward kinematics of the deformed arm. Metres, in the order
    /// of `targets`; `None` for a target that has no correction at `at_min`.
    fn errors_m(&self, targets: &[usize], at_min: f64, moments: &[Moment]) -> Vec<Option<f64>>;

    /// Minutes at which the drift may bend (a table's times), ascending; between two of them, and after the
    /// last, each target drifts smoothly in one direction.
    fn knots_min(&self) -> &[f64];
}

pub(super) fn minus(a: [f64; 3], b: [f64; 3]) -> [f64; 3] {
    [a[0] - b[0], a[1] - b[1], a[2] - b[2]]
}

pub(super) fn norm2(a: [f64; 3]) -> f64 {
    a[0] * a[0] + a[1] * a[1] + a[2] * a[2]
}

pub(super) fn norm(a: [f64; 3]) -> f64 {
    norm2(a).sqrt()
}
