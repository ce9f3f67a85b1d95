//! Which of the arm's eight branches a robtarget is reached on: by confdata where the controller checks it, by where the arm
//! comes from where it does not.

use super::messages::span_of;
use super::model::Model;
use super::placement::skip;
use nalgebra::Isometry3;
use rapid_program::data::ConfData;
use rapid_program::motion::{Motion, Path, SkipReason};
use rapid_syntax::diagnostic::Diagnostic;
use robot_model::kinematics::{Configuration, Solution};
use robot_model::units::rad_from_deg;

/// Nearer to the wrist singularity than this a motion is kept, degrees.
pub(super) const WRIST_DEG: f64 = 2.0;
/// Joints closer than this are the same solution, radians.
const SAME_RAD: f64 = 1e-6;
/// So far from where branches meet no rounding makes one of two, metres and radians.
const APART: f64 = 1e-3;

/// The numbers of confdata as the kinematics takes them.
pub(super) fn configuration(ConfData { cf1, cf4, cf6, cfx }: ConfData) -> Configuration {
    Configuration { cf1, cf4, cf6, cfx }
}

/// Where the arm stands before a motion.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum StartPosture {
    /// With these joints, radians.
    Joints([f64; 6]),
    /// At a target that the text does not tell the branch of.
    UnknownBranch,
    /// The text does not tell where.
    Anywhere,
}

impl StartPosture {
    pub(super) fn joints(&self) -> Option<&[f64; 6]> {
        match self {
            Self::Joints(q_rad) => Some(q_rad),
            Self::UnknownBranch | Self::Anywhere => None,
        }
    }

    /// The same with the place forgotten.
    pub(super) fn anywhere(self) -> Self {
        if self == Self::UnknownBranch { self } else { Self::Anywhere }
    }
}

/// The joints a target is reached with.
#[derive(Clone, Debug)]
pub(super) struct Branch {
    /// Those that are meant, as far as can be told, radians.
    pub(super) q_rad: [f64; 6],
    /// Those of every other branch that the arm may take as well, radians; none where the branch is known.
    pub(super) others: Vec<[f64; 6]>,
    /// What is to be said about the choice.
    pub(super) note: Option<Note>,
}

impl Branch {
    /// The only one there is.
    pub(super) fn known(q_rad: [f64; 6]) -> Self {
        Self { q_rad, others: Vec::new(), note: None }
    }

    /// Where it leaves the arm.
    pub(super) fn exit(&self) -> StartPosture {
        if self.others.is_empty() { StartPosture::Joints(self.q_rad) } else { StartPosture::UnknownBranch }
    }
}

/// What is to be said about a choice of branch.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Note {
    /// Confdata means another solution than the one the arm comes along.
    Disagrees,
    /// cfx names a branch on which a quadrant of axis 1, 4 or 6 is another one than confdata says.
    Quadrant,
    /// No solution of the branch the arm comes along: a straight line cannot get there.
    BranchChange,
    /// `[0,0,0,0]` and nothing to check it against.
    Unset,
    /// Joints that are known from outside are on another branch than the straight line ends in.
    HintElsewhere,
    /// Nobody checks confdata, and the text does not tell where the arm comes from.
    Unchecked,
}

/// The joints that are meant.
///
/// A linear or circular move cannot change branch, so where the arm comes from decides and confdata is checked against it.
/// A joint move goes to the branch that cfx names, or under `ConfJ \Off` to the solution nearest to where the arm stands.
///
/// The branch is known where all places that the arm may come `from` lead to the same.
///
/// # Errors
/// Why there is none.
pub(super) fn branch_of(
    motion: &Motion,
    base_from_flange: &Isometry3<f64>,
    conf: &ConfData,
    from: &[StartPosture],
    model: &Model,
) -> Result<Branch, SkipReason> {
    let solutions = model.closed.solutions(base_from_flange);
    if solutions.is_empty() {
        let anywhere = model.closed.branches(base_from_flange).iter().any(Option::is_some);
        return Err(if anywhere {
            skip("reach::range", "its target is reached only outside the joints' ranges")
        } else {
            skip("reach::none", "its target is out of the arm's reach")
        });
    }
    let candidates = Candidates { solutions: &solutions, conf, model };
    let checked = motion.setup.conf_monitored;
    let one = |from: &StartPosture| match motion.setup.path {
        Path::Joint | Path::AbsJoint => candidates.of_joint_move(checked, from.joints()),
        Path::Linear | Path::Circular => candidates.of_line(checked, from),
    };
    let mut all = from.iter().map(one);
    let mut branch = all.next().unwrap_or_else(|| one(&StartPosture::Anywhere))?;
    for other in all {
        let other = other?;
        let same_branch = candidates.cfx(&other.q_rad) == candidates.cfx(&branch.q_rad);
        if !(same_branch && other.others.is_empty() && branch.others.is_empty()) {
            return candidates.any().ok_or_else(|| candidates.no_such());
        }
        branch.note = branch.note.or(other.note);
    }
    Ok(branch)
}

/// The same from the joints of one branch alone, `q_rad`, which is the one that confdata name: where [`branch_of`] asks for no other,
/// as the arm comes along that branch or is told to go to it. `None` where it must be asked.
pub(super) fn branch_as_written(
    motion: &Motion,
    q_rad: &[f64; 6],
    conf: &ConfData,
    from: &[StartPosture],
    model: &Model,
) -> Option<Branch> {
    let [from] = from else { return None };
    let posture = model.closed.posture(q_rad);
    // Where branches meet two of them may have one number.
    let apart = posture.shoulder_m.abs() > APART && posture.elbow_rad.abs() > APART;
    let solutions = model.closed.turns(q_rad);
    if solutions.is_empty() {
        // The branch that confdata name lies outside the joints' ranges alone.
        return None;
    }
    let candidates = Candidates { solutions: &solutions, conf, model };
    let on_branch = solutions.iter().all(|solution| solution.configuration.cfx == conf.cfx);
    if !(apart && on_branch && posture.wrist_rad.abs() > APART) {
        return None;
    }
    match motion.setup.path {
        Path::Linear | Path::Circular => {
            // The line stays on the branch, and only on it confdata may be right.
            let along_it =
                |q_rad: &&[f64; 6]| candidates.cfx(q_rad) == conf.cfx && !candidates.is_near_wrist(q_rad);
            from.joints().filter(along_it)?;
            candidates.of_line(motion.setup.conf_monitored, from).ok()
        }
        Path::Joint | Path::AbsJoint => {
            let branch = candidates.of_joint_move(motion.setup.conf_monitored, from.joints()).ok()?;
            let checked = motion.setup.conf_monitored == Some(true);
            (checked && branch.note.is_none() && candidates.as_written().is_some()).then_some(branch)
        }
    }
}

/// The solutions of a robtarget within the joints' ranges, of which there is one at least, and what its confdata say.
pub(super) struct Candidates<'t> {
    pub(super) solutions: &'t [Solution],
    pub(super) conf: &'t ConfData,
    pub(super) model: &'t Model<'t>,
}

impl Candidates<'_> {
    fn of_joint_move(
        &self,
        conf_monitored: Option<bool>,
        from: Option<&[f64; 6]>,
    ) -> Result<Branch, SkipReason> {
        let nearest = from.and_then(|from| nearest(self.solutions.iter(), from));
        match (conf_monitored, nearest) {
            (Some(true), _) => {
                let mut branch = self.by_cfx(from).ok_or_else(|| self.no_such())?;
                let elsewhere = from.is_some_and(|from| self.cfx(from) != self.conf.cfx);
                if self.is_unset() && elsewhere {
                    branch.note = Some(Note::Unset);
                }
                Ok(branch)
            }
            (Some(false), Some(nearest)) => Ok(Branch::known(nearest)),
            (Some(false), None) => self.any().ok_or_else(|| self.no_such()),
            (None, _) => {
                // Confdata are checked, or they are not: known where both come to the same.
                let same_branch = |q_rad: &[f64; 6]| self.cfx(q_rad) == self.conf.cfx;
                let known = nearest.filter(same_branch).map(Branch::known);
                known.or_else(|| self.any()).ok_or_else(|| self.no_such())
            }
        }
    }

    fn of_line(&self, conf_monitored: Option<bool>, from: &StartPosture) -> Result<Branch, SkipReason> {
        let along = from.joints().and_then(|from| self.along(from));
        let exact = self.as_written();
        let checked = conf_monitored == Some(true);
        let with = |q_rad, note| Ok(Branch { q_rad, others: Vec::new(), note: Some(note) });
        match (exact, along, from) {
            (Some(written), Some(along), _) if same(&written, &along) => Ok(Branch::known(along)),
            (_, Some(along), _) => with(along, Note::Disagrees),
            (Some(written), None, StartPosture::Joints(_)) => with(written, Note::BranchChange),
            (_, None, StartPosture::UnknownBranch) if !checked => self.any().ok_or_else(|| self.no_such()),
            (Some(written), None, _) if self.is_unset() => with(written, Note::Unset),
            (Some(written), None, _) if checked => Ok(Branch::known(written)),
            (Some(written), None, _) => with(written, Note::Unchecked),
            (None, None, _) if checked => self.by_cfx(from.joints()).ok_or_else(|| self.no_such()),
            (None, None, _) => Err(self.no_such()),
        }
    }

    /// The solution nearest to where the arm comes from on its branch. Close to the wrist singularity the sign of joint 5
    /// is none of the branch.
    pub(super) fn along(&self, from: &[f64; 6]) -> Option<[f64; 6]> {
        let drop = u32::from(self.is_near_wrist(from));
        let here = self.cfx(from) >> drop;
        nearest(self.solutions.iter().filter(|s| s.configuration.cfx >> drop == here), from)
    }

    fn is_near_wrist(&self, q_rad: &[f64; 6]) -> bool {
        self.model.closed.posture(q_rad).wrist_rad.abs() < rad_from_deg(WRIST_DEG)
    }

    /// The solution with all four numbers of confdata.
    pub(super) fn as_written(&self) -> Option<[f64; 6]> {
        let written = configuration(*self.conf);
        self.solutions.iter().find(|s| self.model.closed.agrees(&written, &s.q_rad)).map(|s| s.q_rad)
    }

    /// The solution on the branch that cfx names: with all numbers of confdata, else the one with fewest quarter turns
    /// amiss, and of those the nearest. Whole turns of axes 4 and 6 change no correction.
    pub(super) fn by_cfx(&self, from: Option<&[f64; 6]>) -> Option<Branch> {
        if let Some(written) = self.as_written() {
            return Some(Branch::known(written));
        }
        let amiss = |s: &Solution| {
            let c = s.configuration;
            let quarters = [(c.cf1, self.conf.cf1), (c.cf4, self.conf.cf4), (c.cf6, self.conf.cf6)];
            quarters.iter().map(|(own, written)| (i64::from(*own) - i64::from(*written)).abs()).sum::<i64>()
        };
        let far = |s: &Solution| from.map_or(0.0, |from| s.squared_distance(from));
        let on_branch = self.solutions.iter().filter(|s| s.configuration.cfx == self.conf.cfx);
        let least =
            on_branch.min_by(|a, b| amiss(a).cmp(&amiss(b)).then_with(|| far(a).total_cmp(&far(b))))?;
        Some(Branch { q_rad: least.q_rad, others: Vec::new(), note: Some(Note::Quadrant) })
    }

    /// Every branch within range, the one of confdata first where it is among them.
    fn any(&self) -> Option<Branch> {
        let first = self.as_written().or_else(|| self.by_cfx(None).map(|branch| branch.q_rad));
        let q_rad = first.or_else(|| Some(self.solutions.first()?.q_rad))?;
        let mut seen = vec![self.cfx(&q_rad)];
        let mut others = Vec::new();
        for solution in self.solutions {
            if !seen.contains(&solution.configuration.cfx) {
                seen.push(solution.configuration.cfx);
                others.push(solution.q_rad);
            }
        }
        Some(Branch { q_rad, others, note: None })
    }

    pub(super) fn cfx(&self, q_rad: &[f64; 6]) -> i32 {
        self.model.closed.configuration(q_rad).cfx
    }

    fn is_unset(&self) -> bool {
        *self.conf == ConfData::default()
    }

    fn no_such(&self) -> SkipReason {
        let ConfData { cf1, cf4, cf6, cfx } = *self.conf;
        skip(
            "keep::configuration",
            format!(
                "no solution has its configuration [{cf1},{cf4},{cf6},{cfx}], and nothing says which is meant"
            ),
        )
    }
}

fn nearest<'a>(solutions: impl Iterator<Item = &'a Solution>, from: &[f64; 6]) -> Option<[f64; 6]> {
    let far = |s: &&Solution| s.squared_distance(from);
    solutions.min_by(|a, b| far(a).total_cmp(&far(b))).map(|s| s.q_rad)
}

pub(super) fn same(a: &[f64; 6], b: &[f64; 6]) -> bool {
    a.iter().zip(b).all(|(a, b)| (a - b).abs() < SAME_RAD)
}

impl Note {
    /// The code of its warning.
    pub(super) fn code(self) -> &'static str {
        match self {
            Self::Disagrees | Self::Quadrant => "conf::disagrees",
            Self::BranchChange => "conf::branch-change",
            Self::HintElsewhere => "hint::line-branch",
            Self::Unset => "conf::unset",
            Self::Unchecked => "conf::unchecked",
        }
    }

    /// The warning of a motion whose target has these confdata.
    pub(super) fn message(self, motion: &Motion, conf: &ConfData) -> Diagnostic {
        let ConfData { cf1, cf4, cf6, cfx } = conf;
        let written = format!("[{cf1},{cf4},{cf6},{cfx}]");
        let (line, held) = (motion.line, motion.setup.conf_monitored != Some(false));
        let (text, help) = match self {
            Self::Disagrees if held => (
                format!(
                    "the configuration {written} is not the one a straight line ends in, and the controller is told to check it"
                ),
                "the arm was taken to stay on its branch; on the controller this move stops unless ConfL\\Off is in force",
            ),
            Self::Disagrees => (
                format!(
                    "the configuration {written} is not the one a straight line ends in; under ConfL\\Off the arm stays on its \
                     branch"
                ),
                "the branch the arm comes along was used; the source's numbers stay as they are",
            ),
            Self::Quadrant => (
                format!(
                    "no solution has the quadrants of the configuration {written}; the branch that its cfx names was used"
                ),
                "the source's numbers stay as they are; a controller that checks them goes to the same branch, or stops there",
            ),
            Self::BranchChange => (
                format!(
                    "the target cannot be reached on the branch the arm comes along; the configuration {written} was used"
                ),
                "a straight line cannot change branch: check that the move runs at all",
            ),
            Self::HintElsewhere => (
                "the hinted joints are on another branch than the one that a straight line from the motion before ends in"
                    .to_owned(),
                "the hint was believed; a straight line changes branch only through a singularity: check that the move runs",
            ),
            Self::Unset => (
                format!("the configuration {written} looks like one that was never set"),
                "it was believed, as nothing else says where the arm comes from; export with configurations, or with a joint move \
                 first",
            ),
            Self::Unchecked => (
                format!(
                    "where the arm comes from is not known, and under ConfL\\Off it stays on its branch whatever the \
                     configuration {written} says"
                ),
                "the configuration was believed; --start-joints or --home says where the arm stands at the entry",
            ),
        };
        Diagnostic::warning(self.code(), format!("line {line}: {text}")).help(help).at(span_of(motion))
    }
}
