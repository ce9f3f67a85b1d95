//! Typed parameters of built-in functions and instructions, and the entries of their tables.

use crate::code::{Expr, Name};
use crate::frame;
use crate::interpreter::{Args, Interpreter};
use crate::machine::DataRef;
use crate::outcome::Fault;
use crate::value::{Type, Value};
use nalgebra::{Isometry3, UnitQuaternion, Vector3};
use robot_model::units::m_from_mm;
use std::fmt;

/// What a function counts as in the effort of a motion's argument.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Cost {
    Nothing,
    Arithmetic,
    Trigonometric,
}

/// How a function or instruction that every controller has is called, options left out.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Signature {
    /// Its name in lower case.
    pub name: &'static str,
    /// Name and RAPID type of each argument by position.
    pub parameters: &'static [(&'static str, &'static str)],
}

impl fmt::Display for Signature {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let parameters: Vec<String> =
            self.parameters.iter().map(|(name, ty)| format!("{ty} {name}")).collect();
        write!(f, "{}({})", self.name, parameters.join(", "))
    }
}

/// A function of the controller.
pub(crate) struct Function {
    pub signature: Signature,
    pub cost: Cost,
    pub call: fn(&mut Interpreter<'_>, &Args<'_>) -> Result<Value, Fault>,
}

/// An instruction of the controller.
pub(crate) struct Instruction {
    pub signature: Signature,
    pub call: fn(&mut Interpreter<'_>, &Args<'_>) -> Result<(), Fault>,
}

/// What an argument by position can be read as.
pub(super) trait Parameter: Sized {
    /// The type's name in RAPID.
    const TYPE: &'static str;

    /// The argument at a position, from 0.
    fn read(vm: &mut Interpreter<'_>, args: &Args<'_>, at: usize) -> Result<Self, Fault>;
}

/// The body of an entry: reads each parameter in order, then runs what stands behind them.
macro_rules! typed_call {
    (($($p:ident: $ty:ty),*), |$vm:ident, $args:ident| $body:expr) => {
        |$vm: &mut Interpreter<'_>, $args: &Args<'_>| {
            let mut _at = 0;
            $(
                let $p = <$ty as Parameter>::read($vm, $args, _at)?;
                _at += 1;
            )*
            let _ = (&$vm, &$args, $(&$p),*); // few entries need them all
            $body
        }
    };
}

/// `function!("strlen", Nothing, (text: Chars), |vm, args| value)`: an entry of a table of functions.
macro_rules! function {
    ($name:literal, $cost:ident, ($($p:ident: $ty:ty),*), |$vm:ident, $args:ident| $body:expr) => {
        $crate::builtin::parameter::Function {
            signature: $crate::builtin::parameter::Signature {
                name: $name,
                parameters: &[$((stringify!($p), <$ty as Parameter>::TYPE)),*],
            },
            cost: $crate::builtin::parameter::Cost::$cost,
            call: $crate::builtin::parameter::typed_call!(($($p: $ty),*), |$vm, $args| $body),
        }
    };
}

/// `instruction!("set", (signal: Name), |vm, args| result)`: an entry of a table of instructions.
macro_rules! instruction {
    ($name:literal, ($($p:ident: $ty:ty),*), |$vm:ident, $args:ident| $body:expr) => {
        $crate::builtin::parameter::Instruction {
            signature: $crate::builtin::parameter::Signature {
                name: $name,
                parameters: &[$((stringify!($p), <$ty as Parameter>::TYPE)),*],
            },
            call: $crate::builtin::parameter::typed_call!(($($p: $ty),*), |$vm, $args| $body),
        }
    };
}

pub(super) use {function, instruction, typed_call};

/// An argument that is given and not evaluated before the call: the function does so itself.
pub(super) struct Unevaluated;

impl Parameter for Unevaluated {
    const TYPE: &'static str = "any";

    fn read(_: &mut Interpreter<'_>, args: &Args<'_>, at: usize) -> Result<Self, Fault> {
        args.at(at).map(|_| Self)
    }
}

/// A value of any type.
impl Parameter for Value {
    const TYPE: &'static str = "any";

    fn read(vm: &mut Interpreter<'_>, args: &Args<'_>, at: usize) -> Result<Self, Fault> {
        vm.eval(args.at(at)?, None)
    }
}

/// Data that can be written, with their type; `None` where the argument is none.
pub(super) type Data = Option<(DataRef, Type)>;

impl Parameter for Data {
    const TYPE: &'static str = "data";

    fn read(vm: &mut Interpreter<'_>, args: &Args<'_>, at: usize) -> Result<Self, Fault> {
        vm.data_ref(args.at(at)?)
    }
}

/// The name of a signal.
impl Parameter for Name {
    const TYPE: &'static str = "signal";

    fn read(vm: &mut Interpreter<'_>, args: &Args<'_>, at: usize) -> Result<Self, Fault> {
        vm.signal_name(args.at(at)?)
    }
}

impl Parameter for f32 {
    const TYPE: &'static str = "num";

    fn read(vm: &mut Interpreter<'_>, args: &Args<'_>, at: usize) -> Result<Self, Fault> {
        vm.eval_num(args.at(at)?)
    }
}

impl Parameter for f64 {
    const TYPE: &'static str = "dnum";

    fn read(vm: &mut Interpreter<'_>, args: &Args<'_>, at: usize) -> Result<Self, Fault> {
        Ok(vm.eval_as(args.at(at)?, &Type::Dnum)?.number().unwrap_or(0.0))
    }
}

impl Parameter for String {
    const TYPE: &'static str = "string";

    fn read(vm: &mut Interpreter<'_>, args: &Args<'_>, at: usize) -> Result<Self, Fault> {
        string(vm, args.at(at)?)
    }
}

/// The value of an expression as text.
pub(super) fn string(vm: &mut Interpreter<'_>, expr: &Expr) -> Result<String, Fault> {
    Ok(vm.eval_as(expr, &Type::Str)?.string().unwrap_or_default().to_owned())
}

/// The characters of a `string`, to be counted.
pub(super) struct Chars(pub Vec<char>);

impl Parameter for Chars {
    const TYPE: &'static str = "string";

    fn read(vm: &mut Interpreter<'_>, args: &Args<'_>, at: usize) -> Result<Self, Fault> {
        String::read(vm, args, at).map(|text| Self(text.chars().collect()))
    }
}

/// The numbers of an argument that is a record of one type.
fn numbers(vm: &mut Interpreter<'_>, args: &Args<'_>, at: usize, ty: &Type) -> Result<Vec<f64>, Fault> {
    vm.eval_as(args.at(at)?, ty).map(|value| value.numbers())
}

/// A `pose` as a transform, metres.
impl Parameter for Isometry3<f64> {
    const TYPE: &'static str = "pose";

    fn read(vm: &mut Interpreter<'_>, args: &Args<'_>, at: usize) -> Result<Self, Fault> {
        let ty = vm.program.types.pose.clone();
        frame::isometry_of(&numbers(vm, args, at, &ty)?)
    }
}

/// A `pos` as a vector, metres.
impl Parameter for Vector3<f64> {
    const TYPE: &'static str = "pos";

    fn read(vm: &mut Interpreter<'_>, args: &Args<'_>, at: usize) -> Result<Self, Fault> {
        let ty = vm.program.types.pos.clone();
        let n = numbers(vm, args, at, &ty)?;
        Ok(Self::new(m_from_mm(n[0]), m_from_mm(n[1]), m_from_mm(n[2])))
    }
}

impl Parameter for UnitQuaternion<f64> {
    const TYPE: &'static str = "orient";

    fn read(vm: &mut Interpreter<'_>, args: &Args<'_>, at: usize) -> Result<Self, Fault> {
        let ty = vm.program.types.orient.clone();
        frame::quaternion(&numbers(vm, args, at, &ty)?)
    }
}

macro_rules! record_of_numbers {
    ($($(#[$doc:meta])* $name:ident = $field:ident;)+) => {$(
        $(#[$doc])*
        pub(super) struct $name(pub Vec<f64>);

        impl Parameter for $name {
            const TYPE: &'static str = stringify!($field);

            fn read(vm: &mut Interpreter<'_>, args: &Args<'_>, at: usize) -> Result<Self, Fault> {
                let ty = vm.program.types.$field.clone();
                numbers(vm, args, at, &ty).map(Self)
            }
        }
    )+};
}

record_of_numbers! {
    /// The numbers of a `robtarget`, mm.
    RobTarget = robtarget;
    /// The numbers of a `jointtarget`, degrees.
    JointTarget = jointtarget;
    /// The numbers of an `extjoint`, mm or degrees.
    ExtJoint = extjoint;
    /// The numbers of a `loaddata`.
    LoadData = loaddata;
}

/// An argument that may be left out.
impl Parameter for Option<Chars> {
    const TYPE: &'static str = "[string]";

    fn read(vm: &mut Interpreter<'_>, args: &Args<'_>, at: usize) -> Result<Self, Fault> {
        if at < args.positional.len() { Chars::read(vm, args, at).map(Some) } else { Ok(None) }
    }
}
