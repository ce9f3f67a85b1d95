//! One target of a motion: how it is written and what it is worth, in little room.

use super::data::{ConfData, ExtJoint, JointTarget, RobTarget};
use nalgebra::{Isometry3, Quaternion, Translation3, Unit};
use rapid_syntax::diagnostic::{FileId, Span, TextRange};

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
    /// An element of an array, Offs, RelTool, CalcRobT and so on: a constant expression.
    Expression,
}

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
    one_of: bool,
}

impl Target {
    /// A target as it is written; its value is not known.
    #[must_use]
    pub fn new(range: TextRange, origin: Origin) -> Self {
        let inline = origin == Origin::Inline;
        let details = match origin {
            Origin::Inline | Origin::Expression => None,
            Origin::Named { .. } => {
                Some(Box::new(Details { origin, literal: None, elements: Box::default(), one_of: false }))
            }
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

    /// One of the elements of a constant array of one dimension; only run time tells which.
    #[must_use]
    pub fn with_elements(mut self, elements: Vec<TargetValue>) -> Self {
        if !elements.is_empty() {
            let origin = self.origin().clone();
            let literal = self.details.as_ref().and_then(|details| details.literal);
            self.details =
                Some(Box::new(Details { origin, literal, elements: elements.into(), one_of: false }));
        }
        self
    }

    /// One of a few values, none of which an index names; only run time tells which.
    #[must_use]
    pub fn with_one_of(self, values: Vec<TargetValue>) -> Self {
        let mut target = self.with_elements(values);
        if let Some(details) = &mut target.details {
            details.one_of = true;
        }
        target
    }

    /// Whether its [`elements`](Self::elements) are values among which no index chooses.
    #[must_use]
    pub fn is_one_of(&self) -> bool {
        self.details.as_ref().is_some_and(|details| details.one_of)
    }

    /// How it is written.
    #[must_use]
    pub fn origin(&self) -> &Origin {
        match &self.details {
            Some(details) => &details.origin,
            None if self.inline => &Origin::Inline,
            None => &Origin::Expression,
        }
    }

    /// What it is worth; `None` where the motion's reason to be kept says why that is not known, and where there are
    /// [`elements`](Self::elements).
    #[must_use]
    pub fn value(&self) -> Option<TargetValue> {
        self.value.as_ref().map(Compact::value)
    }

    /// Where it is an element of a constant array of one dimension, or one of a few known values, and only run time tells
    /// which: all of them, in order.
    #[must_use]
    pub fn elements(&self) -> &[TargetValue] {
        self.details.as_ref().map_or(&[], |details| &details.elements)
    }

    /// Everything that it may be worth: its value, or all elements of the array that it is one of.
    pub fn values(&self) -> impl Iterator<Item = TargetValue> + '_ {
        let elements = if self.value.is_some() { &[] } else { self.elements() };
        self.value().into_iter().chain(elements.iter().copied())
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
        let one_of = Target::new(TextRange::new(0, 5), Origin::Expression).with_elements(vec![joints; 3]);
        assert_eq!(
            (one_of.value(), one_of.values().count(), one_of.origin()),
            (None, 3, &Origin::Expression)
        );
        let known = target().with_value(&joints);
        assert_eq!((known.values().count(), known.elements().len()), (1, 0));
        assert_eq!((target().values().count(), target().literal(FileId(2))), (0, None));
        let own = Span { file: FileId(2), range: TextRange::new(3, 9) };
        assert_eq!(target().with_literal(own).literal(FileId(2)), Some(own));
    }
}
