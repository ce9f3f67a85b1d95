//! Routines in the form in which they are executed: a flat list of operations with jumps.
//!
//! Flat, so that GOTO, RETRY and TRYNEXT are a change of one number and hostile nesting cannot overflow
//! the stack.

use super::ids::ModuleId;
use rapid_syntax::diagnostic::TextRange;
use rapid_syntax::tree::{BinaryOp, UnaryOp};
use std::cell::Cell;
use std::rc::Rc;

/// A name in lower case.
pub(super) type Name = Rc<str>;

/// An expression, its names resolved to slots where they are the routine's own.
#[derive(Clone, Debug)]
pub(super) struct Expr {
    pub kind: ExprKind,
    /// Names, numbers and operators alone: to evaluate it changes nothing.
    pub is_pure: bool,
}

impl Expr {
    /// An expression out of its parts.
    pub(crate) fn new(kind: ExprKind) -> Self {
        let is_pure = match &kind {
            ExprKind::Number(_) | ExprKind::Bool(_) | ExprKind::Local(_) | ExprKind::Name(_) => true,
            ExprKind::Field(base, _) => base.is_pure,
            ExprKind::Index(base, indices) => base.is_pure && indices.iter().all(|index| index.is_pure),
            ExprKind::Unary(_, operand) => operand.is_pure,
            ExprKind::Binary(_, lhs, rhs) => lhs.is_pure && rhs.is_pure,
            ExprKind::Str(_) | ExprKind::Aggregate(_) | ExprKind::Call(_) | ExprKind::Opaque => false,
        };
        Self { kind, is_pure }
    }
}

/// A name that is none of the routine's own.
#[derive(Clone, Debug)]
pub(super) struct NameRef {
    /// Its name in lower case.
    pub name: Name,
    pub spelt: Rc<str>,
    /// The data it meant when it was looked up last.
    pub found: Cell<Option<Found>>,
}

/// The data that a name means in a module, for as long as no module comes or goes.
#[derive(Clone, Copy, Debug)]
pub(super) struct Found {
    pub module: Option<ModuleId>,
    pub changes: u64,
    pub datum: Option<usize>,
}

#[derive(Clone, Debug)]
pub(super) enum ExprKind {
    Number(f64),
    Str(Rc<str>),
    Bool(bool),
    /// A parameter, local or loop variable of the routine, by its position.
    Local(usize),
    /// Anything else with a name.
    Name(NameRef),
    Field(Box<Expr>, Name),
    Index(Box<Expr>, Vec<Expr>),
    Aggregate(Vec<Expr>),
    Call(Rc<Call>),
    Unary(UnaryOp, Box<Expr>),
    Binary(BinaryOp, Box<Expr>, Box<Expr>),
    /// Text that is no expression.
    Opaque,
}

/// A call of a procedure, function or instruction.
#[derive(Clone, Debug)]
pub(super) struct Call {
    pub callee: Callee,
    pub args: Vec<Arg>,
}

#[derive(Clone, Debug)]
pub(super) enum Callee {
    /// In lower case, and as spelt.
    Name(Name, Rc<str>),
    /// Late binding: the name is a string that is computed at run time.
    Late(Expr),
}

/// One argument of a call.
#[derive(Clone, Debug)]
pub(super) enum Arg {
    Positional(Expr),
    Switch(Name),
    Named(Name, Expr),
    /// `\Name?param`
    Conditional(Name, Expr),
}

/// What one instruction does.
#[derive(Clone, Debug)]
pub(super) enum Op {
    Assign(Expr, Expr),
    Call(Rc<Call>),
    Jump(usize),
    /// The beginning of a loop that only what stands in its body may end: how it does.
    LoopEnter(Rc<CompiledExits>),
    /// The end of an endless loop's body: jump back and count a pass.
    LoopBack(usize),
    JumpUnless(Expr, usize),
    /// Start a FOR: variable, end value and step in hidden locals.
    ForInit {
        var: usize,
        end: usize,
        step: usize,
        from: Expr,
        to: Expr,
        by: Option<Expr>,
    },
    ForTest {
        var: usize,
        end: usize,
        step: usize,
        exit: usize,
    },
    ForStep {
        var: usize,
        step: usize,
        top: usize,
    },
    /// Store a value in a hidden local.
    Store(usize, Expr),
    /// Jump where the hidden local equals one of the values.
    JumpIfIn(usize, Vec<Expr>, usize),
    Return(Option<Expr>),
    Raise(Option<Expr>),
    Retry,
    TryNext,
    Exit,
    Connect(Expr, Name),
    /// A statement that was not understood, or a GOTO to a label that is not there.
    Unknown(Rc<str>),
    /// The end of an ERROR handler or of the routine.
    End,
}

/// How a loop's body leaves the loop, or a routine what calls it.
#[derive(Debug)]
pub(super) struct CompiledExits {
    /// It does on some way.
    pub leaves: bool,
    /// What decides on the ways there.
    pub exit_conditions: Vec<Expr>,
    /// Procedures that are called and may leave in turn.
    pub calls: Vec<CompiledCall>,
}

/// A call of a procedure that may leave the loop or routine it stands in.
#[derive(Debug)]
pub(super) struct CompiledCall {
    /// The procedure's name in lower case.
    pub name: Name,
    /// What decides on the way there, and what is handed over.
    pub exit_conditions: Vec<Expr>,
}

/// An operation and where it stands in the source.
#[derive(Clone, Debug)]
pub(super) struct Instruction {
    pub op: Op,
    pub range: TextRange,
    /// Where TRYNEXT goes on after an error in this operation.
    pub next: usize,
    /// Counts as an executed statement; the jumps between statements do not.
    pub counts: bool,
}

/// A parameter of a routine.
#[derive(Clone, Debug)]
pub(super) struct Param {
    pub name: Name,
    pub optional: bool,
    pub mode: rapid_syntax::tree::ParamMode,
    pub type_name: Name,
    pub dims: usize,
}

/// A declaration inside a routine.
#[derive(Clone, Debug)]
pub(super) struct LocalDecl {
    pub slot: usize,
    pub kind: rapid_syntax::tree::DataKind,
    pub type_name: Name,
    pub dims: Vec<Expr>,
    pub init: Option<Expr>,
}

/// A routine as it is executed.
#[derive(Debug)]
pub(super) struct Code {
    pub params: Vec<Param>,
    pub decls: Vec<LocalDecl>,
    pub slots: usize,
    pub instructions: Vec<Instruction>,
    /// ERROR handlers: the numbers they are for (empty = all) and where they begin.
    pub handlers: Vec<(Vec<Expr>, usize)>,
    /// How its statements leave what calls it.
    pub exits: CompiledExits,
    /// Where the BACKWARD section begins.
    pub backward: Option<usize>,
}
