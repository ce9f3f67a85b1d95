//! A program's targets put to the controller's own kinematics: nothing moves, it calculates.

use super::loading::link_message;
use crate::report::notes;
use nalgebra::{Isometry3, Quaternion, UnitQuaternion};
use rapid_compensation::compensate::CompensateError;
use rapid_compensation::compensate::commanded::{Commanded, CommandedTargets, commanded};
use rapid_program::Program;
use rapid_syntax::diagnostic::{Diagnostic, FileId, counted, first_few};
use robot_link::{Configuration, Frame, Identity, LinkError, Session, Unit};
use robot_model::robot::Robot;
use robot_model::units::{deg_from_rad, mm_from_m, rad_from_deg};
use std::collections::BTreeMap;
use std::f64::consts::{FRAC_PI_2, TAU};

/// How far the controller may stand from its own display before anything is concluded, mm.
const DISPLAY_MM: f64 = 0.1;
/// Joints nearer to the border of a quadrant may be told on either side of it, degrees.
const BORDER_DEG: f64 = 1e-3;
/// Motions out of reach that are listed at most.
const LISTED: usize = 12;

/// What is asked, and how near the answers have to be.
#[derive(Clone, Debug)]
pub struct LinkCheck {
    /// The arm's mechanical unit.
    pub unit: Unit,
    /// Every element of a scheduled target; else the original, the middle and the last.
    pub all: bool,
    /// Largest distance of two poses that are the same, mm.
    pub tolerance_mm: f64,
    /// Largest angle, of poses and of joints, degrees.
    pub tolerance_deg: f64,
}

/// Why targets are not put to a controller.
#[derive(Clone, Debug, thiserror::Error)]
pub enum LinkCheckError {
    /// The robot has no closed form.
    #[error(transparent)]
    Robot(#[from] CompensateError),
    /// No or an incomplete answer.
    #[error(transparent)]
    Link(#[from] LinkError),
}

impl LinkCheckError {
    /// Stable code of the message, listed in `docs/MESSAGES.md`.
    #[must_use]
    pub fn code(&self) -> &'static str {
        match self {
            Self::Robot(error) => error.code(),
            Self::Link(error) => error.code(),
        }
    }
}

impl From<LinkCheckError> for Diagnostic {
    fn from(error: LinkCheckError) -> Self {
        match error {
            LinkCheckError::Robot(error) => error.into(),
            LinkCheckError::Link(error) => link_message(&error),
        }
    }
}

/// What was found at one target.
#[derive(Clone, Debug, PartialEq)]
pub struct TargetCheck {
    /// File and line of the motion.
    pub at: String,
    /// Element of a scheduled target, from 1, the original first.
    pub element: usize,
    /// Between our pose and the controller's for the same joints, mm and degrees.
    pub apart: (f64, f64),
    /// Largest difference of a joint for the same pose, degrees; `None` where the controller says that it cannot be reached.
    pub joints_deg: Option<f64>,
    /// Configurations, ours and the controller's, where they differ.
    pub configurations: Option<([i32; 4], [i32; 4])>,
    /// All joints that the controller finds for the pose; `None` where it does not look for all.
    pub all_solutions: Option<AllSolutions>,
    /// It is as it should be.
    pub agrees: bool,
}

/// All joints that a controller finds for a pose.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct AllSolutions {
    /// How many branches and turns of them it lists.
    pub count: usize,
    /// Ours are among them, whole turns of an axis apart.
    pub has_ours: bool,
}

/// How the check ended.
#[derive(Clone, Debug)]
pub enum LinkChecked {
    /// The controller does not calculate for others.
    NotOffered(String),
    /// Its calculation is not what it displays: no conclusion.
    NoConclusion {
        /// Between its own display and its own calculation for the joints that it shows, mm.
        apart_mm: f64,
    },
    /// Every target that there are joints for was asked for.
    Asked {
        /// One finding for each target and element asked for.
        found: Vec<TargetCheck>,
        /// File and line of motions whose targets the arm does not reach by nominal kinematics.
        unreached: Vec<String>,
        /// Elements that it does not reach of targets of which it reaches others, places of a pallet that are not in use, say: file
        /// and line, and which, from 1. They are no part of an agreement or a difference.
        unreached_elements: Vec<(String, usize)>,
        /// The arm that is meant.
        robot: String,
        /// Motions whose targets only run time knows.
        unknown: usize,
        /// Between its own display and its own calculation, mm.
        display_mm: f64,
    },
}

impl LinkCheck {
    /// Poses further apart do not agree unless told otherwise, mm.
    pub const TOLERANCE_MM: f64 = 0.005;
    /// Angles and joints further apart do not agree unless told otherwise, degrees.
    pub const TOLERANCE_DEG: f64 = 0.001;

    /// The originals, middles and lasts of scheduled targets, held to 0.005 mm and 0.001 degrees.
    #[must_use]
    pub fn new(unit: Unit) -> Self {
        let (tolerance_mm, tolerance_deg) = (Self::TOLERANCE_MM, Self::TOLERANCE_DEG);
        Self { unit, all: false, tolerance_mm, tolerance_deg }
    }

    /// Asks for every target of a program. `start_rad`: joints at its entry.
    ///
    /// # Errors
    /// [`LinkCheckError`]
    pub fn run(
        &self,
        session: &mut Session,
        program: &Program,
        robot: &Robot,
        start_rad: Option<[f64; 6]>,
    ) -> Result<LinkChecked, LinkCheckError> {
        let targets = commanded(program, robot, start_rad)?;
        Ok(self.ask(session, program, &targets, &robot.name)?)
    }

    fn ask(
        &self,
        session: &mut Session,
        program: &Program,
        targets: &CommandedTargets,
        robot: &str,
    ) -> Result<LinkChecked, LinkError> {
        // Before use: what it calculates must be what it displays.
        let display_mm = match self.display_mm(session) {
            Err(LinkError::NotOffered { dialect, request }) => {
                return Ok(LinkChecked::NotOffered(format!("{dialect} offers no {request}")));
            }
            other => other?,
        };
        if display_mm > DISPLAY_MM {
            return Ok(LinkChecked::NoConclusion { apart_mm: display_mm });
        }
        let place = |at: &(FileId, u32)| format!("{}:{}", program.file(at.0).path, at.1);
        let mut answered: BTreeMap<String, TargetCheck> = BTreeMap::new();
        let mut found = Vec::new();
        for target in targets.reached.iter().filter(|target| self.is_asked(target)) {
            // A pose that comes again is not asked for again.
            let key = format!("{:?} {:?} {:?}", target.base_from_tcp, target.flange_from_tcp, target.q_rad);
            let mut answer = match answered.get(&key) {
                Some(answer) => answer.clone(),
                None => self.one(session, target)?,
            };
            answered.entry(key).or_insert_with(|| answer.clone());
            (answer.at, answer.element) = (place(&target.at), target.element + 1);
            found.push(answer);
        }
        Ok(LinkChecked::Asked {
            found,
            unreached: targets.unreached.iter().map(place).collect(),
            unreached_elements: targets
                .unreached_elements
                .iter()
                .map(|(at, element)| (place(at), element + 1))
                .collect(),
            robot: robot.to_owned(),
            unknown: targets.unknown,
            display_mm,
        })
    }

    fn is_asked(&self, target: &Commanded) -> bool {
        self.all || [0, target.elements / 2, target.elements - 1].contains(&target.element)
    }

    /// Between the flange that the controller displays and the one that it calculates for the joints that it displays, mm.
    fn display_mm(&self, session: &mut Session) -> Result<f64, LinkError> {
        let q_rad = session.joints_now_deg(&self.unit)?.map(rad_from_deg);
        let (position_mm, _) = session.flange_now_mm(&self.unit)?;
        let calculated = session.forward(&self.unit, &q_rad, &Frame::IDENTITY)?;
        let squares =
            calculated.frame.position_m.iter().zip(position_mm).map(|(m, mm)| (mm_from_m(*m) - mm).powi(2));
        Ok(squares.sum::<f64>().sqrt())
    }

    fn one(&self, session: &mut Session, target: &Commanded) -> Result<TargetCheck, LinkError> {
        let tool = frame(&target.flange_from_tcp);
        let ours = configuration(&target.configuration);
        let pose = session.forward(&self.unit, &target.q_rad, &tool)?;
        let theirs = isometry(&pose.frame);
        let between = theirs.inv_mul(&target.base_from_tcp);
        let apart = (mm_from_m(between.translation.vector.norm()), deg_from_rad(between.rotation.angle()));
        let solved = session.inverse(
            &self.unit,
            &frame(&target.base_from_tcp),
            Configuration(ours),
            &target.q_rad,
            &tool,
        );
        let joints_deg = match solved {
            Ok(solution) => {
                let apart = solution.q_rad.iter().zip(target.q_rad).map(|(a, b)| (a - b).abs());
                Some(deg_from_rad(apart.fold(0.0, f64::max)))
            }
            Err(LinkError::Refused { refusal, .. }) if refusal.code() == "link::reach" => None,
            Err(error) => return Err(error),
        };
        let all_solutions = self.all_solutions(session, target, &tool)?;
        let is_same = same_configuration(ours, pose.configuration.0, &target.q_rad);
        let agrees = apart.0 <= self.tolerance_mm
            && apart.1 <= self.tolerance_deg
            && is_same
            && joints_deg.is_some_and(|deg| deg <= self.tolerance_deg)
            && all_solutions.is_none_or(|all| all.has_ours);
        let configurations = (!is_same).then_some((ours, pose.configuration.0));
        Ok(TargetCheck {
            at: String::new(),
            element: 0,
            apart,
            joints_deg,
            configurations,
            all_solutions,
            agrees,
        })
    }

    /// Every branch that the controller finds for a pose, and whether the joints that are meant are one of them.
    fn all_solutions(
        &self,
        session: &mut Session,
        target: &Commanded,
        tool: &Frame,
    ) -> Result<Option<AllSolutions>, LinkError> {
        let configuration = Configuration(configuration(&target.configuration));
        let all = match session.solutions(&self.unit, &frame(&target.base_from_tcp), configuration, tool) {
            Ok(all) => all,
            Err(LinkError::NotOffered { .. }) => return Ok(None),
            Err(LinkError::Refused { refusal, .. }) if refusal.code() == "link::reach" => Vec::new(),
            Err(error) => return Err(error),
        };
        let turned = |a: f64, b: f64| ((a - b) - TAU * ((a - b) / TAU).round()).abs();
        let is_ours = |q_rad: &[f64; 6]| {
            let apart = q_rad.iter().zip(target.q_rad).map(|(a, b)| turned(*a, b));
            deg_from_rad(apart.fold(0.0, f64::max)) <= self.tolerance_deg
        };
        let has_ours = all.iter().any(|solution| is_ours(&solution.q_rad));
        Ok(Some(AllSolutions { count: all.len(), has_ours }))
    }
}

/// Quadrants as both count them; on the border of one either is right.
fn same_configuration(ours: [i32; 4], theirs: [i32; 4], q_rad: &[f64; 6]) -> bool {
    let is_near_border = |q: f64| (q - FRAC_PI_2 * (q / FRAC_PI_2).round()).abs() < rad_from_deg(BORDER_DEG);
    let quadrants = [(0, 0), (1, 3), (2, 5)];
    let same = |(i, axis): (usize, usize)| {
        ours[i] == theirs[i] || (is_near_border(q_rad[axis]) && (ours[i] - theirs[i]).abs() == 1)
    };
    quadrants.into_iter().all(same) && ours[3] == theirs[3]
}

fn configuration(c: &robot_model::kinematics::Configuration) -> [i32; 4] {
    [c.cf1, c.cf4, c.cf6, c.cfx]
}

fn frame(pose: &Isometry3<f64>) -> Frame {
    let q = pose.rotation.quaternion();
    Frame { position_m: pose.translation.vector.into(), orientation: [q.w, q.i, q.j, q.k] }
}

fn isometry(frame: &Frame) -> Isometry3<f64> {
    let [w, i, j, k] = frame.orientation;
    let rotation = UnitQuaternion::from_quaternion(Quaternion::new(w, i, j, k));
    Isometry3::from_parts(frame.position_m.into(), rotation)
}

impl LinkChecked {
    /// Whether the controller agrees, and all targets that the text tells are in reach; `None` where nothing can be concluded.
    #[must_use]
    pub fn agrees(&self) -> Option<bool> {
        match self {
            Self::Asked { found, unreached, .. } if !found.is_empty() => {
                Some(unreached.is_empty() && found.iter().all(|found| found.agrees))
            }
            Self::Asked { .. } | Self::NotOffered(_) | Self::NoConclusion { .. } => None,
        }
    }

    /// For people: each target that does not agree (`all`: each), the worst, and the verdict.
    #[must_use]
    pub fn text(&self, all: bool) -> String {
        match self {
            Self::Asked { found, .. } => {
                let shown = found.iter().filter(|found| all || !found.agrees);
                shown.map(TargetCheck::line).collect::<String>() + &self.result_text()
            }
            Self::NotOffered(_) | Self::NoConclusion { .. } => self.result_text(),
        }
    }

    /// The worst, what was not asked for, and the verdict.
    fn result_text(&self) -> String {
        match self {
            Self::NotOffered(what) => format!("not offered: {what}\n"),
            Self::NoConclusion { apart_mm } => format!(
                "no conclusion: for the joints that it shows the controller calculates a flange {apart_mm:.4} mm from the one that it shows\n"
            ),
            Self::Asked { found, unreached, unreached_elements, robot, unknown, display_mm } => {
                let mut text = worst_line(found, *display_mm);
                if *unknown > 0 {
                    text += &format!(
                        "not asked for: {}, whose targets only the running program knows\n",
                        counted(*unknown, "motion")
                    );
                }
                if !unreached.is_empty() {
                    text += &format!(
                        "not asked for: {}, whose targets are out of reach of {robot} (--robot names another): {}\n",
                        counted(unreached.len(), "motion"),
                        first_few(unreached, LISTED)
                    );
                }
                if !unreached_elements.is_empty() {
                    let names: Vec<String> = unreached_elements
                        .iter()
                        .map(|(at, element)| format!("{at} element {element}"))
                        .collect();
                    text += &format!(
                        "not asked for: {} of targets of several, out of reach of {robot} (places that are not in use?): {}\n",
                        counted(names.len(), "element"),
                        first_few(&names, LISTED)
                    );
                }
                text + &verdict_line(found, unreached.len())
            }
        }
    }

    /// The same for programs.
    #[must_use]
    pub fn json(&self) -> serde_json::Value {
        match self {
            Self::NotOffered(what) => {
                serde_json::json!({"verdict": "not_offered", "why": what, "notes": notes(&self.result_text())})
            }
            Self::NoConclusion { apart_mm } => {
                serde_json::json!({"verdict": "no_conclusion", "display_mm": apart_mm, "notes": notes(&self.result_text())})
            }
            Self::Asked { found, unreached, unreached_elements, robot, unknown, display_mm } => {
                serde_json::json!({
                    "notes": notes(&self.result_text()),
                    "verdict": self.verdict(),
                    "display_mm": display_mm,
                    "robot": robot,
                    "not_known": unknown,
                    "out_of_reach": unreached,
                    "elements_out_of_reach": unreached_elements
                        .iter()
                        .map(|(at, element)| serde_json::json!({"at": at, "element": element}))
                        .collect::<Vec<_>>(),
                    "targets": found.iter().map(TargetCheck::json).collect::<Vec<_>>(),
                })
            }
        }
    }

    /// The same with the controller that was asked: its address and what it is.
    #[must_use]
    pub fn json_of(&self, host: &str, identity: &Identity) -> serde_json::Value {
        let mut data = self.json();
        data["host"] = host.into();
        data["controller"] = serde_json::json!({
            "robot": identity.robot, "dialect": identity.dialect.to_string(), "absolute_accuracy": identity.absolute_accuracy,
        });
        data
    }

    /// The verdict on what was asked for, in a word.
    fn verdict(&self) -> &'static str {
        match self {
            Self::Asked { found, .. } if found.iter().any(|found| !found.agrees) => "differs",
            _ => match self.agrees() {
                Some(true) => "agrees",
                Some(false) => "out_of_reach",
                None => "nothing_asked",
            },
        }
    }
}

/// How much was asked for, and the worst of it.
fn worst_line(found: &[TargetCheck], display_mm: f64) -> String {
    let asked = counted(found.len(), "target");
    let display = format!("display and calculation {display_mm:.4} mm apart");
    if found.is_empty() {
        return format!("{asked} asked for; {display}\n");
    }
    let worst = |value: fn(&TargetCheck) -> f64| found.iter().map(value).fold(0.0, f64::max);
    format!(
        "{asked} asked for; worst {:.4} mm, {:.4} deg, joints {:.4} deg; {display}\n",
        worst(|f| f.apart.0),
        worst(|f| f.apart.1),
        worst(|f| f.joints_deg.unwrap_or(0.0)),
    )
}

/// What the answers say, and of how many targets.
fn verdict_line(found: &[TargetCheck], unreached: usize) -> String {
    let wrong = found.iter().filter(|found| !found.agrees).count();
    match (found.len(), wrong, unreached) {
        (0, ..) => "NOTHING was asked: no motion has a target that can be put to the controller\n".to_owned(),
        (_, 0, 0) => "the controller's own kinematics agree: poses, branches and configurations\n".to_owned(),
        (asked, 0, _) => format!(
            "the controller's own kinematics agree at {} alone; {} OUT OF REACH\n",
            counted(asked, "target"),
            counted(unreached, "motion")
        ),
        (_, wrong, _) => {
            format!("the controller's own kinematics DO NOT AGREE at {}\n", counted(wrong, "target"))
        }
    }
}

impl TargetCheck {
    fn line(&self) -> String {
        let joints = match self.joints_deg {
            Some(deg) => format!("joints {deg:.4} deg apart"),
            None => "not reached in this configuration".to_owned(),
        };
        let configurations = self.configurations.map_or_else(String::new, |(ours, theirs)| {
            format!(", confdata {ours:?} here and {theirs:?} there")
        });
        let all = self.all_solutions.map_or_else(String::new, |all| {
            let among = if all.has_ours { "ours among them" } else { "ours NOT among them" };
            format!(", {}, {among}", counted(all.count, "solution"))
        });
        let verdict = if self.agrees { "" } else { "  <-" };
        let (mm, deg) = self.apart;
        format!(
            "{} element {}: {mm:.4} mm, {deg:.4} deg, {joints}{configurations}{all}{verdict}\n",
            self.at, self.element
        )
    }

    fn json(&self) -> serde_json::Value {
        serde_json::json!({
            "at": self.at,
            "element": self.element,
            "apart_mm": self.apart.0,
            "apart_deg": self.apart.1,
            "joints_deg": self.joints_deg,
            "configurations": self.configurations.map(|(ours, theirs)| serde_json::json!({"ours": ours, "controller": theirs})),
            "solutions": self.all_solutions.map(|all| serde_json::json!({"count": all.count, "ours": all.has_ours})),
            "agrees": self.agrees,
        })
    }
}
