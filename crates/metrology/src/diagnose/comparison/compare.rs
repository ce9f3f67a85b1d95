//! What has changed between two measurements of one robot, before and after a crash, say: pose by pose, so that all that
//! was wrong before as much as after drops out.

use super::base_shift::{BaseSigma, base_sigma};
use super::nest_scale::nest_scale;
use super::pose_pairs::{Pair, as_measurements, first_line, paired, point_pairs};
use super::scale_change::{FittedScale, ScaleChange};
use super::two_files::are_mostly_copies;
use crate::diagnose::examine::diagnose;
use crate::diagnose::options::DiagnosisOptions;
use crate::diagnose::outcome::{Findings, Verdict};
use measurements::{
    Fault, Measurements, OneStand, Reading, RegisterError, Registration, STATED_FREEDOM, Station, Stations,
    TOOL_M, ToolApart, check_rows, describe_false_repeats, from_sound_file, gather, register, tool_apart,
};
use nalgebra::{Isometry3, Point3, Vector3};
use rapid_syntax::diagnostic::Diagnostic;
use robot_model::kinematics::SerialChain;
use robot_model::robot::SerialArm;
use statistics::{MEDIAN_NORM_3D, median};

/// Fewer poses in both say nothing.
const FEWEST: usize = 12;
/// A shift of the tool beyond this many sigmas is one.
const SURE: f64 = 4.0;
/// Points that differ by less are the same but for the arithmetic, metres: a nanometre.
const SAME_M: f64 = 1e-9;
/// A point that has moved by more than so many standard deviations of a coordinate has not moved by noise: one in 65,000 does by chance.
const FURTHEST: f64 = 5.0;
/// Pairs with the largest change that are listed.
const LISTED: usize = 10;

/// Why two files cannot be compared.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum CompareError {
    /// Too few poses were measured both times.
    #[error(
        "only {pairs} poses were measured both times (joints, target, payload and direction alike); {FEWEST} are needed"
    )]
    TooFew {
        /// Poses that were measured both times.
        pairs: usize,
    },
    /// The rows of a file contradict the robot.
    #[error("{reason}")]
    Fault {
        /// In what way, as a sentence.
        reason: String,
    },
    /// The poses are too few or too alike to register.
    #[error(transparent)]
    Register(#[from] RegisterError),
}

impl CompareError {
    /// Stable code of the message, listed in `docs/MESSAGES.md`.
    #[must_use]
    pub fn code(&self) -> &'static str {
        match self {
            Self::TooFew { .. } => "changed::too-few",
            Self::Fault { .. } => "measure::fault",
            Self::Register(error) => error.code(),
        }
    }
}

impl From<CompareError> for Diagnostic {
    fn from(error: CompareError) -> Self {
        let message = Self::error(error.code(), error.to_string());
        match error {
            // What is wrong in one file is said with what to do about it.
            CompareError::Fault { .. } => message,
            CompareError::TooFew { .. } | CompareError::Register(_) => {
                message.help("measure the same poses with the same target each time, 30 spread ones")
            }
        }
    }
}

/// What has changed between two measurements.
#[derive(Clone, Debug)]
pub struct MeasurementComparison {
    /// Poses in both files.
    pub pairs: usize,
    /// Poses in one file alone: before, after.
    pub alone: [usize; 2],
    /// rms change of the points, base and tool as they were each time, metres.
    pub rms_m: f64,
    /// What noise alone would give, where the noise is known.
    pub noise_rms_m: Option<f64>,
    /// Names of the targets that were measured both times, as the file before has them: empty where it names none.
    pub targets: Vec<String>,
    /// Where each of them sat on the flange before, metres.
    pub tools_m: Vec<Vector3<f64>>,
    /// How far each target has moved on the flange, with its largest standard deviation, metres.
    pub tools_moved_m: Vec<(Vector3<f64>, f64)>,
    /// The one target, before and after, where the points have it elsewhere than it was given.
    pub tool_apart: [Option<ToolApart>; 2],
    /// The base now in the frame of the base before: real where the instrument has not moved.
    pub base_moved: Isometry3<f64>,
    /// How exactly that is told; `None` where it is not, or where the arm has changed, which may be a part of it.
    pub base_sigma: Option<BaseSigma>,
    /// The points that have moved furthest, the furthest first.
    pub worst: Vec<MovedPoint>,
    /// The diagnosis of the differences.
    pub diagnosis: Findings,
    /// The change of all lengths alike, where that is what has changed.
    pub scale: Option<ScaleChange>,
    /// What noise does not explain, whatever the cause.
    pub beyond: BeyondNoise,
    /// Whether the arm has changed: how base and target have moved is then told with a part of it.
    pub arm_is_changed: bool,
    /// Whether arm or tool have changed.
    pub is_changed: bool,
    /// What a person should look at in the files before and after: rows that were left out.
    pub warnings: [Vec<Diagnostic>; 2],
}

impl MeasurementComparison {
    /// Whether the differences are more than base, tool and noise make.
    #[must_use]
    pub fn arm_is_changed(&self) -> bool {
        is_of_the_arm(&self.diagnosis)
    }

    /// The targets, as indices, that sit so far from where they sat before that they are others, or were put on anew: no wear or drift of a
    /// tool goes so far.
    #[must_use]
    pub fn other_targets(&self) -> Vec<usize> {
        let all = self.tools_moved_m.iter().enumerate();
        all.filter(|(_, (by, sigma))| by.norm() > TOOL_M + SURE * sigma).map(|(target, _)| target).collect()
    }
}

fn is_of_the_arm(diagnosis: &Findings) -> bool {
    !matches!(diagnosis.verdict, Verdict::NothingAboveNoise | Verdict::InsufficientData)
}

/// What has moved by more than noise moves it.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct BeyondNoise {
    /// Number of poses whose points have, base and tool refitted.
    pub poses: usize,
    /// Whether all points together have, where the noise is known.
    pub is_scattered: bool,
    /// Whether the base stands elsewhere for the instrument: one of the two has moved, or axis 1's zero has.
    pub base_is_moved: bool,
}

/// A point that was measured twice.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct MovedPoint {
    /// Its lines in the file before and in the one after.
    pub lines: [u64; 2],
    /// How far it has moved, metres.
    pub by_m: f64,
}

/// Compares `after` with `before`.
///
/// # Errors
/// [`CompareError`]
pub fn compare_measurements(
    before: &Measurements,
    after: &Measurements,
    robot: &SerialArm,
    options: &DiagnosisOptions,
) -> Result<MeasurementComparison, CompareError> {
    let before = FileSeen::new("before", before, robot)?;
    let after = FileSeen::new("after", after, robot)?;
    compared([&before, &after], robot, options)
}

fn compared(
    files: [&FileSeen; 2],
    robot: &SerialArm,
    options: &DiagnosisOptions,
) -> Result<MeasurementComparison, CompareError> {
    let chain = SerialChain::nominal(robot);
    let [old, new] = files.map(FileSeen::stations);
    let [before, after] = files.map(|file| &file.measurements);
    let all = paired(&old, &new, before, after, &chain);
    let (pairs, targets) = (&all.all, all.targets.len());
    if pairs.len() < FEWEST {
        return Err(CompareError::TooFew { pairs: pairs.len() });
    }
    let Registered { flange, was, is, moved, shown } = registered(pairs, targets, options.tool_m)?;
    let fit = register(&shown, &flange, targets, Some(was.tools_m.first().copied().unwrap_or_default()))?;
    let left: Vec<Vector3<f64>> =
        shown.iter().zip(&flange).map(|(s, pose)| fit.residual_m(s, pose)).collect();

    let reading = ReadingNoise::new(&old, &new, options);
    let sigma_m = reading.as_ref().map(|reading| reading.of_differences_m(pairs));
    let sameness = Sameness::new(&moved, [before, after]);
    let tool_m = fit.tools_m.first().copied().filter(|_| targets == 1);
    let differences = as_measurements(&all, &shown, before);
    let diagnosis = diagnosed(&differences, robot, &DiagnosisOptions { tool_m, sigma_m }, sameness);
    let points = FittedScale::new(&point_pairs(pairs, &was, &moved), targets, sigma_m.unwrap_or(0.0));
    let reading_m = options.sigma_m.or_else(|| old.repeats.map(|repeats| repeats.sigma_m));
    let nests = |left_m: f64| nest_scale(files.map(FileSeen::rows), reading_m.unwrap_or(left_m));
    let scale = points.and_then(|fit| fit.as_change(&diagnosis, rms_m(&left), nests(fit.left_m)));
    let diagnosis = scale.iter().fold(diagnosis, |diagnosis, scale| scale.shared(diagnosis));
    let tools_moved_m: Vec<(Vector3<f64>, f64)> =
        fit.tools_m.iter().zip(&was.tools_m).map(|(a, b)| (a - b, fit.tool_sigma_m)).collect();
    let tool_is_changed = tools_moved_m.iter().any(|(by, sigma)| by.norm() > SURE * sigma);
    let arm_is_changed = is_of_the_arm(&diagnosis);
    let base_moved = was.instrument_from_base.inverse() * is.instrument_from_base * fit.instrument_from_base;
    let base_sigma = told_sigma(pairs, &was, sigma_m, &left).filter(|_| !arm_is_changed);
    let is_beyond_sigma = base_sigma.is_some_and(|sigma| sigma.is_exceeded_by(&base_moved));
    let by_rms_m = base_shift_m(pairs, &was, &base_moved);
    let noise = Noise::new(sigma_m, reading.map(|reading| reading.degrees_of_freedom), &left);
    let beyond = noise.beyond(&left, (by_rms_m, is_beyond_sigma), sameness);
    let is_changed = tool_is_changed || arm_is_changed || beyond.poses > 0 || beyond.is_scattered;
    Ok(MeasurementComparison {
        pairs: pairs.len(),
        alone: [old.stations.len() - pairs.len(), new.stations.len() - pairs.len()],
        rms_m: rms_m(&left),
        noise_rms_m: sigma_m.map(|sigma_m| sigma_m * 3.0_f64.sqrt()),
        tool_apart: [&was, &is].map(|fit| tool_apart(fit, targets, options.tool_m, pairs.len())),
        targets: all.targets.clone(),
        tools_m: was.tools_m,
        tools_moved_m,
        base_moved,
        base_sigma,
        worst: worst_changes(pairs, &left, before, after),
        diagnosis,
        scale,
        beyond,
        arm_is_changed,
        is_changed: is_changed && sameness != Sameness::All,
        warnings: [files[0].warnings_with(&old), files[1].warnings_with(&new)],
    })
}

/// The diagnosis of what has moved, where anything has.
fn diagnosed(
    differences: &Measurements,
    robot: &SerialArm,
    options: &DiagnosisOptions,
    sameness: Sameness,
) -> Findings {
    let poses = match sameness {
        Sameness::None => return diagnose(differences, robot, options),
        Sameness::Most => "most poses have",
        Sameness::All => "each pose has",
    };
    Findings::without_causes(Verdict::NothingAboveNoise, format!("{poses} the same reading both times"))
}

/// How many poses have the same reading both times. Such have no noise against which anything of the arm could be told.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Sameness {
    None,
    Most,
    All,
}

impl Sameness {
    fn new(moved: &[Vector3<f64>], [before, after]: [&Measurements; 2]) -> Self {
        match moved.iter().all(|by| by.norm() < SAME_M) {
            true => Self::All,
            false if are_mostly_copies(before, after) => Self::Most,
            false => Self::None,
        }
    }
}

/// Pairs in the base's frame, as registered each time.
struct Registered {
    /// `base_from_flange` of each, before.
    flange: Vec<Isometry3<f64>>,
    was: Registration,
    is: Registration,
    /// What the points have moved by, metres.
    moved: Vec<Vector3<f64>>,
    /// The stations as the first registration would show them now.
    shown: Vec<Station>,
}

fn registered(
    pairs: &[Pair],
    targets: usize,
    tool_m: Option<Vector3<f64>>,
) -> Result<Registered, RegisterError> {
    let flange: Vec<Isometry3<f64>> = pairs.iter().map(|p| p.flange).collect();
    let flange_after: Vec<Isometry3<f64>> = pairs.iter().map(|p| p.flange_after).collect();
    let first: Vec<Station> = pairs.iter().map(|p| p.before.clone()).collect();
    let second: Vec<Station> = pairs.iter().map(|p| p.after.clone()).collect();
    let was = register(&first, &flange, targets, tool_m)?;
    let is = register(&second, &flange_after, targets, tool_m)?;
    let moved = moved_m(pairs, [&was, &is]);
    let shown = shown(&second, &flange, &was, &moved);
    Ok(Registered { flange, was, is, moved, shown })
}

/// What the points have moved by, the base as it is now, the targets where they were: each reading beside where its own joints put the point.
fn moved_m(pairs: &[Pair], [was, is]: [&Registration; 2]) -> Vec<Vector3<f64>> {
    let now = Registration { tools_m: was.tools_m.clone(), ..is.clone() };
    let moved = |pair: &Pair| {
        now.residual_m(&pair.after, &pair.flange_after) - was.residual_m(&pair.before, &pair.flange)
    };
    pairs.iter().map(moved).collect()
}

/// The stations as an instrument would see them that had stood where it was: `was`, and what has moved.
fn shown(
    stations: &[Station],
    flange: &[Isometry3<f64>],
    was: &Registration,
    moved: &[Vector3<f64>],
) -> Vec<Station> {
    let show = |((s, pose), moved): ((&Station, &Isometry3<f64>), &Vector3<f64>)| Station {
        reading: Reading::Point { position_m: was.predicted_m(s, pose) + moved },
        orientation: None,
        ..s.clone()
    };
    stations.iter().zip(flange).zip(moved).map(show).collect()
}

fn rms_m(all: &[Vector3<f64>]) -> f64 {
    (all.iter().map(Vector3::norm_squared).sum::<f64>() / all.len().max(1) as f64).sqrt()
}

/// By how much the points are elsewhere where the base is, rms, metres.
fn base_shift_m(pairs: &[Pair], was: &Registration, base_moved: &Isometry3<f64>) -> f64 {
    let shift = |pair: &Pair| {
        let tool_m = was.tools_m.get(pair.before.target).copied().unwrap_or_default();
        let point = pair.flange * Point3::from(tool_m);
        base_moved * point - point
    };
    rms_m(&pairs.iter().map(shift).collect::<Vec<_>>())
}

/// How exactly the pairs tell a shift of the base, with the noise that is known, or, where more is `left` of the points, with that.
fn told_sigma(
    pairs: &[Pair],
    was: &Registration,
    known_m: Option<f64>,
    left: &[Vector3<f64>],
) -> Option<BaseSigma> {
    let unknowns = 6 + 3 * was.tools_m.len();
    let freedom = 1.0 - unknowns as f64 / (3 * pairs.len()) as f64;
    let left_m = rms_m(left) / (3.0 * freedom.max(0.1)).sqrt();
    let poses = pairs.iter().map(|pair| (pair.flange, pair.before.target));
    base_sigma(poses, was, known_m.unwrap_or(0.0).max(left_m))
}

/// A file whose rows do not contradict the robot.
struct FileSeen {
    /// In the frame of one stand of the instrument.
    measurements: Measurements,
    /// Rows to use, as indices.
    used: Vec<usize>,
    /// What is to be said of those left out, and of an instrument or a target that was moved in between.
    warnings: Vec<Diagnostic>,
}

impl FileSeen {
    fn new(name: &str, file: &Measurements, robot: &SerialArm) -> Result<Self, CompareError> {
        let contradicted = |fault: Fault| CompareError::Fault { reason: format!("{name}: {}", fault.reason) };
        let checked = check_rows(file, robot);
        let OneStand { used, warnings, measurements, .. } =
            from_sound_file(file, robot, &checked).map_err(contradicted)?;
        let warnings = checked.warnings.into_iter().chain(warnings).collect();
        Ok(Self { used, warnings, measurements: measurements.into_owned() })
    }

    /// Those of the arm: a nest on the base is no pose of it, nor is its noise that of one.
    fn stations(&self) -> Stations {
        let of_arm =
            |&row: &usize| self.measurements.rows.get(row).is_some_and(|row| row.reading.involves_arm());
        gather(&self.measurements, &self.used.iter().copied().filter(of_arm).collect::<Vec<usize>>(), None)
    }

    /// What is to be said of the file, whose stations are `stations`.
    fn warnings_with(&self, stations: &Stations) -> Vec<Diagnostic> {
        let far = describe_false_repeats(&self.measurements, stations);
        self.warnings.iter().cloned().chain(far).collect()
    }

    fn rows(&self) -> (&Measurements, &[usize]) {
        (&self.measurements, &self.used)
    }
}

/// What noise makes of the differences.
struct Noise {
    /// Of a coordinate of a difference, metres.
    sigma_m: f64,
    /// How far off that may be, as a share of it.
    error: f64,
    is_known: bool,
    pairs: f64,
}

impl Noise {
    /// As it is stated or repeated (`known_m`, with the degrees of freedom that tell it); where it is neither, that of most of the
    /// differences `left`.
    fn new(known_m: Option<f64>, degrees_of_freedom: Option<usize>, left: &[Vector3<f64>]) -> Self {
        let pairs = left.len() as f64;
        let Some(sigma_m) = known_m else {
            let sigma_m = median(&mut left.iter().map(Vector3::norm).collect::<Vec<f64>>()) / MEDIAN_NORM_3D;
            // The median of n lengths is known to about 1 / the root of 2 n, as a share.
            return Self { sigma_m, error: 1.0 / (2.0 * pairs).sqrt(), is_known: false, pairs };
        };
        let freedom = degrees_of_freedom.unwrap_or(STATED_FREEDOM).max(1) as f64;
        Self { sigma_m, error: 1.0 / (2.0 * freedom).sqrt(), is_known: true, pairs }
    }

    /// What noise does not explain of the differences `left` and of a shift of the base; nothing where all readings are the same.
    fn beyond(
        &self,
        left: &[Vector3<f64>],
        (base_shift_m, is_beyond_sigma): (f64, bool),
        sameness: Sameness,
    ) -> BeyondNoise {
        if sameness == Sameness::All {
            return BeyondNoise::default();
        }
        BeyondNoise {
            poses: left.iter().filter(|by| by.norm() > self.furthest_m()).count(),
            is_scattered: self.is_known && rms_m(left) > self.largest_rms_m(),
            base_is_moved: is_beyond_sigma || base_shift_m > self.largest_base_shift_m(),
        }
    }

    /// So far at most noise moves a point, metres.
    fn furthest_m(&self) -> f64 {
        FURTHEST * self.sigma_m * (1.0 + 2.0 * self.error)
    }

    /// So large at most is the rms of all points by noise, metres.
    fn largest_rms_m(&self) -> f64 {
        // The standard deviation of an rms of n points, as a share, is 1 / the root of 6 n.
        let error = self.error.hypot(1.0 / (6.0 * self.pairs).sqrt());
        3.0_f64.sqrt() * self.sigma_m * (1.0 + SURE * error)
    }

    /// So far at most noise shifts the points, by rms, where the base is refitted, metres: six parameters of n points.
    fn largest_base_shift_m(&self) -> f64 {
        SURE * self.sigma_m * (1.0 + 2.0 * self.error) * (6.0 / self.pairs).sqrt()
    }
}

/// The pairs with the largest change, largest first.
fn worst_changes(
    pairs: &[Pair],
    changes_m: &[Vector3<f64>],
    before: &Measurements,
    after: &Measurements,
) -> Vec<MovedPoint> {
    let mut worst: Vec<MovedPoint> = pairs
        .iter()
        .zip(changes_m)
        .map(|(p, change)| MovedPoint {
            lines: [first_line(before, &p.before), first_line(after, &p.after)],
            by_m: change.norm(),
        })
        .collect();
    sorting::by(&mut worst, |a, b| b.by_m.total_cmp(&a.by_m).then(a.lines[0].cmp(&b.lines[0])));
    worst.truncate(LISTED);
    worst
}

/// Noise of one reading in each file.
struct ReadingNoise {
    /// Before and after, metres.
    sigma_m: [f64; 2],
    /// How well they are known.
    degrees_of_freedom: usize,
}

impl ReadingNoise {
    /// As stated, or as seen in both files' repeats.
    fn new(old: &Stations, new: &Stations, options: &DiagnosisOptions) -> Option<Self> {
        let stated = |sigma_m| Self { sigma_m: [sigma_m; 2], degrees_of_freedom: STATED_FREEDOM };
        let repeated = || {
            let (a, b) = old.repeats.zip(new.repeats)?;
            let degrees_of_freedom = a.degrees_of_freedom.min(b.degrees_of_freedom);
            Some(Self { sigma_m: [a.sigma_m, b.sigma_m], degrees_of_freedom })
        };
        options.sigma_m.map(stated).or_else(repeated)
    }

    /// Of a coordinate of the difference of a pair, on average, over the readings in each mean, metres.
    fn of_differences_m(&self, pairs: &[Pair]) -> f64 {
        let [before_m, after_m] = self.sigma_m;
        let of_pair = |pair: &Pair| {
            before_m.powi(2) / pair.before.rows.len().max(1) as f64
                + after_m.powi(2) / pair.after.rows.len().max(1) as f64
        };
        (pairs.iter().map(of_pair).sum::<f64>() / pairs.len().max(1) as f64).sqrt()
    }
}
