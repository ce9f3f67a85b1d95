//! One target of a motion: how it is written and what it is worth, in little room.

use super::data::{ConfData, ExtJoint, JointTarget, RobTarget};
use nalgebra::{Isometry3, Quaternion, Translation3, Unit};
use rapid_syntax::diagnostic::{FileId, Span, TextRange};
use std::collections::BTreeSet;
use std::sync::LazyLock;

/// How a target is written in its motion.
#[derive(Clone, Debug, PartialEq, Eq, Hash)]
pub enum Origin {
    /// An aggregate in the motion itself.
    Inline,
    /// A name, in the spelling of the motion; the declaration's range tells two data of one name apart.
    Named {
        /// As written in the motion.
        name: String,
        /// The whole declaration of the data.
        declaration: Span,
    },
    /// An element of an array, Offs, RelTool, CalcRobT and so on: an expression, with the names of the targets that it is made of; of an
    /// array's element also as it is written, without blanks.
    Expression(Box<[String]>),
}

/// An expression that names no target.
static NAMELESS: LazyLock<Origin> = LazyLock::new(|| Origin::Expression(Box::default()));

/// What a target is worth.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum TargetValue {
    /// A pose of the TCP in the work object.
    Rob(RobTarget),
    /// Joint values of the arm.
    Joint(JointTarget),
    /// A pose given by the joints that reach it with the motion's own tool and work object (`CalcRobT`).
    FromJoints(JointTarget),
}

/// One target of a motion.
#[derive(Clone, Debug)]
pub struct Target {
    /// The argument as it stands in the motion; this is what a corrected target replaces.
    pub range: TextRange,
    value: Option<Compact>,
    /// An aggregate in the motion that is made of literals alone.
    literal_inline: bool,
    inline: bool,
    details: Option<Box<Details>>,
}

/// What targets have that are no plain aggregate in their motion.
#[derive(Clone, Debug)]
struct Details {
    origin: Origin,
    literal: Option<Span>,
    elements: Box<[TargetValue]>,
    chosen_by: ChosenBy,
}

/// What tells at run time which of its elements a target is.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
enum ChosenBy {
    /// Nothing in the motion: its pose must.
    #[default]
    Pose,
    /// How warm the arm is: the target of a corrected program.
    Warmth,
    /// Indices of a constant array.
    Indices(Indices),
}

/// Indices of a constant array in the text of a target.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Indices {
    /// Where they stand, without braces: `i,j` of `Offs(pRaster{i,j},0,0,10)`.
    pub range: TextRange,
    /// How many elements the array has in each dimension.
    pub dims: Box<[usize]>,
    /// The target is the array's element itself, and no expression with it.
    pub is_element: bool,
    /// Positions of the elements that the ways through the program lead to, in order; `None`: all of them.
    pub occurring: Option<Box<[usize]>>,
}

impl Indices {
    /// For each of the array's elements what `of_occurring` holds for it; `None` for those that never occur.
    pub fn spread<T>(&self, of_occurring: impl IntoIterator<Item = T>) -> Vec<Option<T>> {
        let mut all = of_occurring.into_iter();
        let count = self.dims.iter().product();
        match &self.occurring {
            None => all.map(Some).collect(),
            Some(occurring) => (0..count)
                .map(|at| occurring.binary_search(&at).is_ok().then(|| all.next()).flatten())
                .collect(),
        }
    }
}

/// The indices of an array's element, counted from one, by its position from nought, the last dimension fastest.
#[must_use]
pub fn indices_of(dims: &[usize], mut at: usize) -> Vec<usize> {
    let mut indices = vec![1; dims.len()];
    for (index, size) in indices.iter_mut().zip(dims).rev() {
        *index += at % size;
        at /= size;
    }
    indices
}

impl Target {
    /// A target as it is written; its value is not known.
    #[must_use]
    pub fn new(range: TextRange, origin: Origin) -> Self {
        let inline = origin == Origin::Inline;
        let details = match &origin {
            Origin::Inline => None,
            Origin::Expression(names) if names.is_empty() => None,
            Origin::Named { .. } | Origin::Expression(_) => Some(Box::new(Details {
                origin,
                literal: None,
                elements: Box::default(),
                chosen_by: ChosenBy::Pose,
            })),
        };
        Self { range, value: None, literal_inline: false, inline, details }
    }

    /// The target with its value: numbers to the bit; quarter turns of confdata beyond 16 bits, which nobody can read from
    /// RAPID, are cut.
    #[must_use]
    pub fn with_value(self, value: &TargetValue) -> Self {
        Self { value: Some(Compact::new(value)), ..self }
    }

    /// The target with the place where its value is written as a literal aggregate: an inline one's is its own.
    #[must_use]
    pub fn with_literal(mut self, literal: Span) -> Self {
        match &mut self.details {
            Some(details) => details.literal = Some(literal),
            None => self.literal_inline = true,
        }
        self
    }

    /// Something that differs with an element of a constant array, and that only run time tells: its values in the order of the
    /// elements, the last dimension fastest.
    #[must_use]
    pub fn with_elements(self, values: Vec<TargetValue>, indices: Indices) -> Self {
        self.with_values(values, ChosenBy::Indices(indices))
    }

    /// One of a few values, none of which an index names; only run time tells which.
    #[must_use]
    pub fn with_one_of(self, values: Vec<TargetValue>) -> Self {
        self.with_values(values, ChosenBy::Pose)
    }

    /// The target of a corrected program: as it was written and, where that is told, as each of its corrections makes it.
    #[must_use]
    pub fn with_drift(self, values: Vec<TargetValue>) -> Self {
        self.with_values(values, ChosenBy::Warmth)
    }

    fn with_values(mut self, values: Vec<TargetValue>, chosen_by: ChosenBy) -> Self {
        if !values.is_empty() {
            let origin = self.origin().clone();
            let literal = self.details.as_ref().and_then(|details| details.literal);
            self.details = Some(Box::new(Details { origin, literal, elements: values.into(), chosen_by }));
        }
        self
    }

    /// Whether its [`elements`](Self::elements) are values among which no index chooses.
    #[must_use]
    pub fn is_one_of(&self) -> bool {
        let is_by_pose =
            |details: &Details| details.chosen_by == ChosenBy::Pose && !details.elements.is_empty();
        self.details.as_deref().is_some_and(is_by_pose)
    }

    /// What chooses among its [`elements`](Self::elements), where indices do.
    #[must_use]
    pub fn indices(&self) -> Option<&Indices> {
        match self.details.as_deref().map(|details| &details.chosen_by)? {
            ChosenBy::Indices(indices) => Some(indices),
            ChosenBy::Pose | ChosenBy::Warmth => None,
        }
    }

    /// How it is written.
    #[must_use]
    pub fn origin(&self) -> &Origin {
        match &self.details {
            Some(details) => &details.origin,
            None if self.inline => &Origin::Inline,
            None => &NAMELESS,
        }
    }

    /// What it is worth; `None` where the motion's reason to be kept says why that is not known, and where there are
    /// [`elements`](Self::elements).
    #[must_use]
    pub fn value(&self) -> Option<TargetValue> {
        self.value.as_ref().map(Compact::value)
    }

    /// Where it differs with an element of a constant array, or is one of a few known values, and only run time tells which:
    /// all of them, in order.
    #[must_use]
    pub fn elements(&self) -> &[TargetValue] {
        self.details.as_ref().map_or(&[], |details| &details.elements)
    }

    /// Everything that it may be worth: its value, or those of the elements that it is one of which occur.
    pub fn values(&self) -> impl Iterator<Item = TargetValue> + '_ {
        self.value().into_iter().chain(self.numbered_elements().map(|(_, value)| value))
    }

    /// Those of its elements that occur, with their positions; none where its value is known.
    pub fn numbered_elements(&self) -> impl Iterator<Item = (usize, TargetValue)> + '_ {
        let elements = if self.value.is_some() { &[] } else { self.elements() };
        let occurring = self.indices().and_then(|indices| indices.occurring.as_deref());
        let occurs = move |at: &usize| occurring.is_none_or(|occurring| occurring.binary_search(at).is_ok());
        elements.iter().copied().enumerate().filter(move |(at, _)| occurs(at))
    }

    /// Elements of an array at these positions occur no longer.
    pub fn leave_out(&mut self, positions: &BTreeSet<usize>) {
        let left: Box<[usize]> =
            self.numbered_elements().map(|(at, _)| at).filter(|at| !positions.contains(at)).collect();
        if let Some(ChosenBy::Indices(indices)) = self.details.as_mut().map(|details| &mut details.chosen_by)
        {
            indices.occurring = Some(left);
        }
    }

    /// The text of the value as the source spells it: the aggregate of an inline target, or the initial value of a named
    /// one, where that is a literal aggregate. `file` is the file of its motion. Element 1 of a schedule copies it.
    #[must_use]
    pub fn literal(&self, file: FileId) -> Option<Span> {
        match &self.details {
            Some(details) => details.literal,
            None => self.literal_inline.then_some(Span { file, range: self.range }),
        }
    }
}

/// A value as its numbers: a pose's position and quaternion (i, j, k, w), or six joints.
#[derive(Clone, Debug)]
struct Compact {
    numbers: [f64; 7],
    /// External axes, where one is used.
    ext: Option<Box<ExtJoint>>,
    conf: [i16; 4],
    kind: Kind,
    /// A bit for each robot axis that is written `9E9`.
    unused: u8,
}

#[derive(Clone, Copy, Debug)]
enum Kind {
    Rob,
    Joint,
    FromJoints,
}

impl Compact {
    fn new(value: &TargetValue) -> Self {
        let used = |ext: &ExtJoint| ext.iter().any(Option::is_some).then(|| Box::new(*ext));
        let of_joints = |kind, joints: &JointTarget| {
            let mut numbers = [0.0; 7];
            let mut unused = 0;
            for (axis, (number, q_rad)) in numbers.iter_mut().zip(joints.q_rad).enumerate() {
                *number = q_rad.unwrap_or_default();
                unused |= u8::from(q_rad.is_none()) << axis;
            }
            Self { numbers, ext: used(&joints.ext), conf: [0; 4], kind, unused }
        };
        match value {
            TargetValue::Rob(target) => {
                let at = &target.object_from_tcp;
                let (t, q) = (&at.translation.vector, &at.rotation.coords);
                let ConfData { cf1, cf4, cf6, cfx } = target.conf;
                let cut = |turns: i32| turns.clamp(i16::MIN.into(), i16::MAX.into()) as i16;
                Self {
                    numbers: [t.x, t.y, t.z, q.x, q.y, q.z, q.w],
                    ext: used(&target.ext),
                    conf: [cf1, cf4, cf6, cfx].map(cut),
                    kind: Kind::Rob,
                    unused: 0,
                }
            }
            TargetValue::Joint(joints) => of_joints(Kind::Joint, joints),
            TargetValue::FromJoints(joints) => of_joints(Kind::FromJoints, joints),
        }
    }

    fn value(&self) -> TargetValue {
        let ext = self.ext.as_deref().copied().unwrap_or_default();
        let joints = || JointTarget {
            q_rad: std::array::from_fn(|axis| (self.unused >> axis & 1 == 0).then_some(self.numbers[axis])),
            ext,
        };
        match self.kind {
            Kind::Rob => {
                let [x, y, z, i, j, k, w] = self.numbers;
                let rotation = Unit::new_unchecked(Quaternion::new(w, i, j, k));
                let [cf1, cf4, cf6, cfx] = self.conf.map(i32::from);
                TargetValue::Rob(RobTarget {
                    object_from_tcp: Isometry3::from_parts(Translation3::new(x, y, z), rotation),
                    conf: ConfData { cf1, cf4, cf6, cfx },
                    ext,
                })
            }
            Kind::Joint => TargetValue::Joint(joints()),
            Kind::FromJoints => TargetValue::FromJoints(joints()),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use nalgebra::UnitQuaternion;

    fn target() -> Target {
        Target::new(TextRange::new(3, 9), Origin::Inline)
    }

    #[test]
    fn a_value_comes_back_to_the_bit() {
        let rotation = UnitQuaternion::from_euler_angles(0.1, -2.3, 1.7);
        let conf = ConfData { cf1: -3, cf4: 2, cf6: -1, cfx: 7 };
        for ext in [[None; 6], [Some(0.1), None, Some(-7.0), None, None, Some(0.0)]] {
            let pose = Isometry3::from_parts(Translation3::new(0.1 + 0.2, -1e-17, 4.25), rotation);
            let rob = TargetValue::Rob(RobTarget { object_from_tcp: pose, conf, ext });
            assert_eq!(target().with_value(&rob).value(), Some(rob));
            let q_rad = [Some(0.3), None, Some(-0.0), Some(1e-9), None, Some(6.1)];
            for value in [JointTarget { q_rad, ext }]
                .into_iter()
                .flat_map(|joints| [TargetValue::Joint(joints), TargetValue::FromJoints(joints)])
            {
                assert_eq!(target().with_value(&value).value(), Some(value));
            }
        }
    }

    #[test]
    fn elements_stand_in_for_a_value_that_only_run_time_tells() {
        let joints = TargetValue::Joint(JointTarget { q_rad: [Some(0.5); 6], ext: [None; 6] });
        let written = || Target::new(TextRange::new(0, 5), Origin::Expression(Box::default()));
        let indices =
            Indices { range: TextRange::new(2, 4), dims: [3].into(), is_element: true, occurring: None };
        let some = Indices { occurring: Some([0, 2].into()), ..indices.clone() };
        assert_eq!(some.spread(["a", "c"]), [Some("a"), None, Some("c")]);
        assert_eq!(indices.spread([1, 2, 3]), [1, 2, 3].map(Some));
        assert_eq!(written().with_elements(vec![joints; 3], some).values().count(), 2);
        let mut reached = written().with_elements(vec![joints; 3], indices.clone());
        reached.leave_out(&BTreeSet::from([1]));
        assert_eq!(reached.numbered_elements().map(|(at, _)| at).collect::<Vec<_>>(), [0, 2]);
        reached.leave_out(&BTreeSet::from([0]));
        assert_eq!(reached.indices().and_then(|indices| indices.occurring.as_deref()), Some(&[2][..]));
        let element = written().with_elements(vec![joints; 3], indices.clone());
        assert_eq!(
            (element.value(), element.values().count(), element.origin()),
            (None, 3, &Origin::Expression(Box::default()))
        );
        assert_eq!((element.indices(), element.is_one_of()), (Some(&indices), false));
        let one_of = written().with_one_of(vec![joints; 3]);
        assert_eq!((one_of.indices(), one_of.is_one_of(), written().is_one_of()), (None, true, false));
        assert_eq!(indices_of(&[2, 3], 3), [2, 1]);
        assert_eq!((indices_of(&[7], 6), indices_of(&[], 0)), (vec![7], vec![]));
        let known = target().with_value(&joints);
        assert_eq!((known.values().count(), known.elements().len()), (1, 0));
        assert_eq!((target().values().count(), target().literal(FileId(2))), (0, None));
        let own = Span { file: FileId(2), range: TextRange::new(3, 9) };
        assert_eq!(target().with_literal(own).literal(FileId(2)), Some(own));
    }
}
