//! The tree of a RAPID file: what was written and where, in byte ranges of the source.
//!
//! The tree says nothing of what a name means or what a number is worth: that starts in `program`.
//! Ranges of children lie inside their parent's, in source order, without overlap; what lies between
//! them is white space, comments and punctuation.
//!
//! Programs of a million moves are held whole, so nodes are small and few pieces of the heap: an [`Expr`] takes 24
//! bytes and a [`Stmt`] 48, a call among them, whose arguments are one piece; what is larger stands in a box of its own.

mod expression;
mod statement;

pub use expression::{
    Arg, ArgKind, BinaryExpr, BinaryOp, CallExpr, Expr, ExprKind, FieldExpr, IndexExpr, UnaryOp,
};
pub use statement::{
    AssignStmt, CallStmt, Callee, CompactIfStmt, ConnectStmt, ForStmt, IfStmt, Stmt, StmtKind, TestStmt,
    WhileStmt,
};

use crate::diagnostic::TextRange;

/// The tree of a whole file.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Tree {
    /// The `%%% ... %%%` header, where the file begins with one.
    pub header: Option<TextRange>,
    /// Modules and what stands between them, in order.
    pub items: Vec<FileItem>,
}

/// What a file holds at its outermost level.
#[derive(Clone, Debug, PartialEq)]
pub enum FileItem {
    /// A module; a file usually has one.
    Module(Module),
    /// A comment, without its line end.
    Comment(TextRange),
    /// Text that is none of RAPID's.
    Opaque(TextRange),
}

/// `MODULE name [(attributes)] ... ENDMODULE`
#[derive(Clone, Debug, PartialEq)]
pub struct Module {
    /// From `MODULE` to the end of `ENDMODULE`.
    pub range: TextRange,
    /// From `MODULE` to the end of the name or of the attributes.
    pub head: TextRange,
    /// The name as it is declared.
    pub name: TextRange,
    /// `SYSMODULE`, `NOSTEPIN` ... without commas and parentheses.
    pub attributes: Vec<TextRange>,
    /// What it declares, in order.
    pub items: Vec<ModuleItem>,
    /// The `ENDMODULE`; `None` where the file ends before it.
    pub end: Option<TextRange>,
}

impl Module {
    /// Its routines, in order.
    pub fn routines(&self) -> impl Iterator<Item = &Routine> {
        self.items.iter().filter_map(|item| match item {
            ModuleItem::Routine(routine) => Some(&**routine),
            _ => None,
        })
    }
}

/// What a module holds.
#[derive(Clone, Debug, PartialEq)]
pub enum ModuleItem {
    /// A declaration of CONST, VAR or PERS.
    Data(DataDecl),
    /// `RECORD name type component; ... ENDRECORD`
    Record(RecordDecl),
    /// `ALIAS type name;`
    Alias(AliasDecl),
    /// A PROC, FUNC or TRAP with its body.
    Routine(Box<Routine>),
    /// A comment, without its line end.
    Comment(TextRange),
    /// Text that was not understood.
    Opaque(TextRange),
}

impl ModuleItem {
    /// The bytes of the whole item.
    #[must_use]
    pub fn range(&self) -> TextRange {
        match self {
            Self::Data(d) => d.range,
            Self::Record(r) => r.range,
            Self::Alias(a) => a.range,
            Self::Routine(r) => r.range,
            Self::Comment(r) | Self::Opaque(r) => *r,
        }
    }
}

/// From where a name is seen.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Scope {
    /// Without a word: the whole task (or, in a routine, the routine).
    #[default]
    Global,
    /// `LOCAL`: seen in its module alone.
    Local,
    /// `TASK`: seen in all modules of its task.
    Task,
}

/// The word a data declaration begins with.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum DataKind {
    /// `CONST`
    Const,
    /// `VAR`
    Var,
    /// `PERS`
    Pers,
}

/// `[LOCAL|TASK] CONST|VAR|PERS type name[{n,m,k}] [:= value];`
#[derive(Clone, Debug, PartialEq)]
pub struct DataDecl {
    /// From the first word to the semicolon.
    pub range: TextRange,
    /// LOCAL, TASK or neither.
    pub scope: Scope,
    /// CONST, VAR or PERS.
    pub kind: DataKind,
    /// The name of the type.
    pub type_name: TextRange,
    /// The name of the data.
    pub name: TextRange,
    /// Array dimensions; empty where it is no array.
    pub dims: Box<[Expr]>,
    /// The initial value, where one is given.
    pub init: Option<Expr>,
}

/// `[LOCAL] RECORD name ... ENDRECORD`
#[derive(Clone, Debug, PartialEq)]
pub struct RecordDecl {
    /// From the first word to the end of `ENDRECORD`.
    pub range: TextRange,
    /// LOCAL, or the whole task.
    pub scope: Scope,
    /// The new type's name.
    pub name: TextRange,
    /// Type and name of each component.
    pub components: Vec<(TextRange, TextRange)>,
}

/// `[LOCAL] ALIAS type name;`
#[derive(Clone, Debug, PartialEq)]
pub struct AliasDecl {
    /// From the first word to the semicolon.
    pub range: TextRange,
    /// LOCAL, or the whole task.
    pub scope: Scope,
    /// The type that is given a second name.
    pub type_name: TextRange,
    /// The type's second name.
    pub name: TextRange,
}

/// What kind of routine.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum RoutineKind {
    /// `PROC`
    Proc,
    /// `FUNC type`: the type's name.
    Func(TextRange),
    /// `TRAP`
    Trap,
}

/// A PROC, FUNC or TRAP.
#[derive(Clone, Debug, PartialEq)]
pub struct Routine {
    /// From the first word to the end of `ENDPROC`, `ENDFUNC` or `ENDTRAP`.
    pub range: TextRange,
    /// From the first word to the end of the parameter list.
    pub head: TextRange,
    /// LOCAL, or the whole task.
    pub scope: Scope,
    /// PROC, FUNC or TRAP.
    pub kind: RoutineKind,
    /// The name as it is declared.
    pub name: TextRange,
    /// Its parameters; alternatives of one group follow one another.
    pub params: Vec<Param>,
    /// Declarations, statements and comments in order.
    pub body: Vec<Stmt>,
    /// BACKWARD, ERROR and UNDO.
    pub handlers: Vec<Handler>,
    /// `ENDPROC` ...; `None` where the text ends before it.
    pub end: Option<TextRange>,
}

/// How an argument is handed over.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum ParamMode {
    /// A value, without a word before it.
    #[default]
    In,
    /// `VAR`
    Var,
    /// `PERS`
    Pers,
    /// `INOUT`
    InOut,
}

/// One parameter of a routine.
#[derive(Clone, Debug, PartialEq)]
pub struct Param {
    /// The whole parameter, its backslash included.
    pub range: TextRange,
    /// It begins with `\` and may be left out.
    pub optional: bool,
    /// It stands after a `|`: an alternative to the one before.
    pub alternative: bool,
    /// Value, VAR, PERS, INOUT.
    pub mode: ParamMode,
    /// The type's name; `switch` for a switch.
    pub type_name: TextRange,
    /// The name of the parameter.
    pub name: TextRange,
    /// Number of dimensions (`{*,*}` is 2); 0 where it is no array.
    pub dims: u8,
}

/// What a handler is for.
#[derive(Clone, Debug, PartialEq)]
pub enum HandlerKind {
    /// `BACKWARD`
    Backward,
    /// `ERROR [(numbers)]`
    Error(Vec<Expr>),
    /// `UNDO`
    Undo,
}

/// A handler at a routine's end.
#[derive(Clone, Debug, PartialEq)]
pub struct Handler {
    /// From its word to its last statement.
    pub range: TextRange,
    /// BACKWARD, ERROR or UNDO.
    pub kind: HandlerKind,
    /// The statements of the handler.
    pub body: Vec<Stmt>,
}
