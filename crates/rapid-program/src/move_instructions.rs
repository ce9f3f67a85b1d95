//! The controller's own move instructions: which argument of each is which. Of instructions that are no moves, it knows nothing.
//!
//! Names are in lower case; positions count the arguments without a backslash, from 0, as ABB's
//! reference manual orders them.

use super::motion::Path;
use Path::{AbsJoint, Circular, Joint, Linear};
use Special::Search;

/// Which argument of a move instruction is which.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct MoveForm {
    /// In its usual spelling.
    pub(super) name: &'static str,
    pub(super) path: Path,
    /// Positions of the targets: circle point, end point.
    pub(super) targets: &'static [usize],
    pub(super) speed: usize,
    pub(super) zone: Option<usize>,
    pub(super) tool: Option<usize>,
    pub(super) special: Special,
}

/// What sets a move instruction apart.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Special {
    /// Nothing sets it apart.
    Plain,
    /// It searches: where it stops is what the program wants to know.
    Search,
    /// It moves external axes only.
    External,
    /// It is known to move the arm, not how its targets are used.
    Unsupported,
    /// A sensor says where it moves the arm.
    Sensor,
    /// It is not among the given files; what it is handed or its name says that it moves the arm.
    NotGiven,
}

impl MoveForm {
    /// Whether seam and weld data stand between speed and zone.
    pub(super) fn has_seam(&self) -> bool {
        self.zone.is_some_and(|zone| zone == self.speed + 3)
    }
}

/// The move instruction of a name in lower case.
pub(super) fn move_form(name: &str) -> Option<&'static MoveForm> {
    MOVES.binary_search_by(|(n, _)| (*n).cmp(name)).ok().map(|at| &MOVES[at].1)
}

const fn form(
    name: &'static str,
    path: Path,
    targets: &'static [usize],
    speed: usize,
    zone: Option<usize>,
    tool: usize,
) -> MoveForm {
    MoveForm { name, path, targets, speed, zone, tool: Some(tool), special: Special::Plain }
}

/// ToPoint, Speed, Zone, Tool.
const fn simple(name: &'static str, path: Path) -> MoveForm {
    form(name, path, &[0], 1, Some(2), 3)
}

/// CirPoint, ToPoint, Speed, Zone, Tool.
const fn circle(name: &'static str) -> MoveForm {
    form(name, Circular, &[0, 1], 2, Some(3), 4)
}

/// ToPoint, Speed, Seam, Weld, Zone, Tool.
const fn arc_line(name: &'static str) -> MoveForm {
    form(name, Linear, &[0], 1, Some(4), 5)
}

/// CirPoint, ToPoint, Speed, Seam, Weld, Zone, Tool.
const fn arc_circle(name: &'static str) -> MoveForm {
    form(name, Circular, &[0, 1], 2, Some(5), 6)
}

const fn special(form: MoveForm, special: Special) -> MoveForm {
    MoveForm { special, ..form }
}

const fn external(name: &'static str, target: &'static [usize], speed: usize) -> MoveForm {
    let (path, special) = (AbsJoint, Special::External);
    MoveForm { name, path, targets: target, speed, zone: None, tool: None, special }
}

const fn unsupported(name: &'static str, path: Path) -> MoveForm {
    let special = Special::Unsupported;
    MoveForm { name, path, targets: &[], speed: 1, zone: None, tool: None, special }
}

/// What follows a sensor has no target of its own.
const fn sensor(name: &'static str) -> MoveForm {
    special(unsupported(name, Joint), Special::Sensor)
}

/// The form of whatever is not among the given files and seems to move the arm; its call has its name.
pub(super) static NOT_GIVEN: MoveForm = special(unsupported("call", Joint), Special::NotGiven);

/// All move instructions, sorted by name.
const MOVES: &[(&str, MoveForm)] = &[
    ("arcadaptc", unsupported("ArcAdaptC", Circular)),
    ("arcadaptcend", unsupported("ArcAdaptCEnd", Circular)),
    ("arcadaptl", unsupported("ArcAdaptL", Linear)),
    ("arcadaptlend", unsupported("ArcAdaptLEnd", Linear)),
    ("arcadaptlstart", unsupported("ArcAdaptLStart", Linear)),
    ("arcc", arc_circle("ArcC")),
    ("arcc1", arc_circle("ArcC1")),
    ("arcc1end", arc_circle("ArcC1End")),
    ("arcc1start", arc_circle("ArcC1Start")),
    ("arcc2", arc_circle("ArcC2")),
    ("arcc2end", arc_circle("ArcC2End")),
    ("arcc2start", arc_circle("ArcC2Start")),
    ("arccalcc", unsupported("ArcCalcC", Circular)),
    ("arccalccend", unsupported("ArcCalcCEnd", Circular)),
    ("arccalcl", unsupported("ArcCalcL", Linear)),
    ("arccalclend", unsupported("ArcCalcLEnd", Linear)),
    ("arccalclstart", unsupported("ArcCalcLStart", Linear)),
    ("arccend", arc_circle("ArcCEnd")),
    ("arccstart", arc_circle("ArcCStart")),
    ("arcl", arc_line("ArcL")),
    ("arcl1", arc_line("ArcL1")),
    ("arcl1end", arc_line("ArcL1End")),
    ("arcl1start", arc_line("ArcL1Start")),
    ("arcl2", arc_line("ArcL2")),
    ("arcl2end", arc_line("ArcL2End")),
    ("arcl2start", arc_line("ArcL2Start")),
    ("arclend", arc_line("ArcLEnd")),
    ("arclstart", arc_line("ArcLStart")),
    ("arcmoveabsj", simple("ArcMoveAbsJ", AbsJoint)),
    ("arcmovec", circle("ArcMoveC")),
    ("arcmoveextj", external("ArcMoveExtJ", &[0], 1)),
    ("arcmovej", simple("ArcMoveJ", Joint)),
    ("arcmovel", simple("ArcMoveL", Linear)),
    ("arcrepl", unsupported("ArcRepL", Linear)),
    ("calibj", unsupported("CalibJ", Joint)),
    ("calibl", unsupported("CalibL", Linear)),
    ("capc", unsupported("CapC", Circular)),
    ("capl", unsupported("CapL", Linear)),
    ("contactl", unsupported("ContactL", Linear)),
    ("cssdeactmovel", unsupported("CSSDeactMoveL", Linear)),
    ("dispc", unsupported("DispC", Circular)),
    ("displ", unsupported("DispL", Linear)),
    ("egmmovec", unsupported("EGMMoveC", Circular)),
    ("egmmovel", unsupported("EGMMoveL", Linear)),
    ("egmrunjoint", sensor("EGMRunJoint")),
    ("egmrunpose", sensor("EGMRunPose")),
    ("fcpress1lstart", unsupported("FCPress1LStart", Linear)),
    ("fcpressc", unsupported("FCPressC", Circular)),
    ("fcpressend", unsupported("FCPressEnd", Linear)),
    ("fcpressl", unsupported("FCPressL", Linear)),
    ("measurewearl", unsupported("MeasureWearL", Linear)),
    ("moveabsj", simple("MoveAbsJ", AbsJoint)),
    ("movec", circle("MoveC")),
    ("movecao", circle("MoveCAO")),
    ("movecdo", circle("MoveCDO")),
    ("movecgo", circle("MoveCGO")),
    ("movecsync", circle("MoveCSync")),
    ("moveextj", external("MoveExtJ", &[0], 1)),
    ("movej", simple("MoveJ", Joint)),
    ("movejao", simple("MoveJAO", Joint)),
    ("movejdo", simple("MoveJDO", Joint)),
    ("movejgo", simple("MoveJGO", Joint)),
    ("movejsync", simple("MoveJSync", Joint)),
    ("movel", simple("MoveL", Linear)),
    ("movelao", simple("MoveLAO", Linear)),
    ("moveldo", simple("MoveLDO", Linear)),
    ("movelgo", simple("MoveLGO", Linear)),
    ("movelsync", simple("MoveLSync", Linear)),
    ("movepnp", unsupported("MovePnP", Joint)),
    ("nutj", unsupported("NutJ", Joint)),
    ("nutl", unsupported("NutL", Linear)),
    ("paintc", unsupported("PaintC", Circular)),
    ("paintl", unsupported("PaintL", Linear)),
    ("searchc", special(form("SearchC", Circular, &[2, 3], 4, None, 5), Search)),
    ("searchextj", external("SearchExtJ", &[2], 3)),
    ("searchl", special(form("SearchL", Linear, &[2], 3, None, 4), Search)),
    ("spotj", unsupported("SpotJ", Joint)),
    ("spotl", unsupported("SpotL", Linear)),
    ("spotmj", unsupported("SpotMJ", Joint)),
    ("spotml", unsupported("SpotML", Linear)),
    ("triggabsj", form("TriggAbsJ", AbsJoint, &[0], 1, Some(3), 4)),
    ("triggc", form("TriggC", Circular, &[0, 1], 2, Some(4), 5)),
    ("triggj", form("TriggJ", Joint, &[0], 1, Some(3), 4)),
    ("triggjios", simple("TriggJIOs", Joint)),
    ("triggl", form("TriggL", Linear, &[0], 1, Some(3), 4)),
    ("trigglios", simple("TriggLIOs", Linear)),
];

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn moves_are_sorted_and_named_as_they_are_looked_up() {
        assert!(MOVES.is_sorted_by(|a, b| a.0 < b.0));
        for (name, form) in MOVES {
            assert_eq!(*name, form.name.to_lowercase());
            assert_eq!(move_form(name), Some(form));
        }
        assert_eq!(move_form("move"), None);
    }

    /// Argument orders as ABB's reference manual gives them.
    #[test]
    fn arguments_stand_where_the_manual_says() {
        let at = |name| {
            let form = move_form(name).unwrap();
            (form.targets, form.speed, form.zone, form.tool)
        };
        assert_eq!(at("movel"), (&[0][..], 1, Some(2), Some(3)));
        assert_eq!(at("movec"), (&[0, 1][..], 2, Some(3), Some(4)));
        assert_eq!(at("triggl"), (&[0][..], 1, Some(3), Some(4)));
        assert_eq!(at("triggc"), (&[0, 1][..], 2, Some(4), Some(5)));
        assert_eq!(at("arcl"), (&[0][..], 1, Some(4), Some(5)));
        assert_eq!(at("arccend"), (&[0, 1][..], 2, Some(5), Some(6)));
        assert_eq!(at("searchl"), (&[2][..], 3, None, Some(4)));
        assert_eq!(at("searchc"), (&[2, 3][..], 4, None, Some(5)));
    }
}
