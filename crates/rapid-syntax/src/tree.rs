//! The tree of a RAPID file: what was written and where, in byte ranges of the source.
//!
//! The tree says nothing of what a name means or what a number is worth: that starts in `program`.
//! Ranges of children lie inside their parent's, in source order, without overlap; what lies between
//! them is white space, comments and punctuation.

use crate::diagnostic::TextRange;

/// A whole file.
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
    /// Its name.
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
            ModuleItem::Routine(routine) => Some(routine),
            _ => None,
        })
    }
}

/// What a module holds.
#[derive(Clone, Debug, PartialEq)]
pub enum ModuleItem {
    /// CONST, VAR, PERS.
    Data(DataDecl),
    /// `RECORD name type component; ... ENDRECORD`
    Record(RecordDecl),
    /// `ALIAS type name;`
    Alias(AliasDecl),
    /// PROC, FUNC, TRAP.
    Routine(Routine),
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
    /// `LOCAL`: the module.
    Local,
    /// `TASK`: the task.
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
    /// The type's name.
    pub type_name: TextRange,
    /// The data's name.
    pub name: TextRange,
    /// Array dimensions; empty where it is no array.
    pub dims: Vec<Expr>,
    /// The initial value.
    pub init: Option<Expr>,
}

/// `[LOCAL] RECORD name ... ENDRECORD`
#[derive(Clone, Debug, PartialEq)]
pub struct RecordDecl {
    /// From the first word to the end of `ENDRECORD`.
    pub range: TextRange,
    /// LOCAL or not.
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
    /// LOCAL or not.
    pub scope: Scope,
    /// The type that is given a second name.
    pub type_name: TextRange,
    /// The second name.
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
    /// LOCAL or not.
    pub scope: Scope,
    /// PROC, FUNC or TRAP.
    pub kind: RoutineKind,
    /// Its name.
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
    /// A value.
    #[default]
    In,
    /// `VAR`
    Var,
    /// `PERS`
    Pers,
    /// `INOUT`
    InOut,
}

/// One parameter.
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
    /// The parameter's name.
    pub name: TextRange,
    /// Number of dimensions (`{*,*}` is 2); 0 where it is no array.
    pub dims: u8,
}

/// Which handler.
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
    /// Which.
    pub kind: HandlerKind,
    /// Its statements.
    pub body: Vec<Stmt>,
}

/// A statement.
#[derive(Clone, Debug, PartialEq)]
pub struct Stmt {
    /// From its first byte to its semicolon or END word.
    pub range: TextRange,
    /// What it is.
    pub kind: StmtKind,
}

/// What a statement is.
#[derive(Clone, Debug, PartialEq)]
pub enum StmtKind {
    /// A declaration in a routine.
    Data(Box<DataDecl>),
    /// `target := value;`
    Assign {
        /// A name, a component or an element.
        target: Expr,
        /// What it becomes.
        value: Expr,
    },
    /// A procedure call or an instruction: `MoveL p10,v100,z5,tool0;`
    Call(Box<CallStmt>),
    /// `IF cond THEN ... ELSEIF ... ELSE ... ENDIF`
    If {
        /// Conditions with their statements.
        arms: Vec<(Expr, Vec<Stmt>)>,
        /// After ELSE.
        otherwise: Option<Vec<Stmt>>,
    },
    /// `IF cond statement;`
    CompactIf {
        /// The condition.
        cond: Expr,
        /// The statement; its range lies inside.
        then: Box<Stmt>,
    },
    /// `FOR i FROM a TO b [STEP c] DO ... ENDFOR`
    For {
        /// The loop variable.
        var: TextRange,
        /// FROM.
        from: Box<Expr>,
        /// TO.
        to: Box<Expr>,
        /// STEP.
        step: Option<Box<Expr>>,
        /// The statements.
        body: Vec<Stmt>,
    },
    /// `WHILE cond DO ... ENDWHILE`
    While {
        /// The condition.
        cond: Expr,
        /// The statements.
        body: Vec<Stmt>,
    },
    /// `TEST value CASE a,b: ... DEFAULT: ... ENDTEST`
    Test {
        /// What is tested.
        value: Expr,
        /// Values and statements of each CASE.
        cases: Vec<(Vec<Expr>, Vec<Stmt>)>,
        /// After DEFAULT.
        default: Option<Vec<Stmt>>,
    },
    /// `name:`
    Label(TextRange),
    /// `GOTO name;`
    Goto(TextRange),
    /// `RETURN [value];`
    Return(Option<Expr>),
    /// `RAISE [number];`
    Raise(Option<Expr>),
    /// `RETRY;`
    Retry,
    /// `TRYNEXT;`
    TryNext,
    /// `EXIT;`
    Exit,
    /// `CONNECT interrupt WITH trap;`
    Connect {
        /// The interrupt.
        interrupt: Expr,
        /// The trap's name.
        trap: TextRange,
    },
    /// `;` alone.
    Empty,
    /// `<SMT>` and the like.
    Placeholder,
    /// A comment, without its line end.
    Comment,
    /// Text that was not understood.
    Opaque,
}

/// A procedure call.
#[derive(Clone, Debug, PartialEq)]
pub struct CallStmt {
    /// Which procedure.
    pub callee: Callee,
    /// Its arguments in order.
    pub args: Vec<Arg>,
    /// Written with parentheses round the arguments, as RoboDK's Main page does; no controller takes it.
    pub parenthesised: bool,
    /// Ends in a semicolon.
    pub terminated: bool,
}

/// Which procedure is called.
#[derive(Clone, Debug, PartialEq)]
pub enum Callee {
    /// By name.
    Name(TextRange),
    /// `%expr%`: late binding, the name computed at run time; the expression between the percent signs.
    Late(Expr),
}

/// One argument of a call of a procedure or function.
#[derive(Clone, Debug, PartialEq)]
pub struct Arg {
    /// The argument alone, without commas.
    pub range: TextRange,
    /// What it is.
    pub kind: ArgKind,
}

/// What an argument is.
#[derive(Clone, Debug, PartialEq)]
pub enum ArgKind {
    /// A value by position.
    Positional(Expr),
    /// `\Name` or `\Name:=value`.
    Named {
        /// The name without its backslash.
        name: TextRange,
        /// The value; `None` for a switch.
        value: Option<Expr>,
    },
    /// `\Name?param`: handed on if present.
    Conditional {
        /// The name without its backslash.
        name: TextRange,
        /// The parameter that is handed on.
        param: TextRange,
    },
}

/// An expression.
#[derive(Clone, Debug, PartialEq)]
pub struct Expr {
    /// Its bytes.
    pub range: TextRange,
    /// What it is.
    pub kind: ExprKind,
}

/// What an expression is.
#[derive(Clone, Debug, PartialEq)]
pub enum ExprKind {
    /// A number, as written, without sign.
    Number,
    /// A string with its quotes.
    String,
    /// TRUE or FALSE.
    Bool(bool),
    /// A name.
    Name,
    /// `base.component`
    Field {
        /// The record.
        base: Box<Expr>,
        /// The component's name.
        name: TextRange,
    },
    /// `base{i,j}`; `{*}` gives no index.
    Index {
        /// The array.
        base: Box<Expr>,
        /// One to three indices.
        indices: Vec<Expr>,
    },
    /// `[a,b,c]`
    Aggregate(Vec<Expr>),
    /// `[1,[2,-3]]`, nothing but numbers and no comment: [`parts_of_numbers`](super::parts_of_numbers) gives its parts.
    Numbers,
    /// `name(args)`: a function call.
    Call {
        /// The function's name.
        name: TextRange,
        /// Its arguments.
        args: Vec<Arg>,
    },
    /// `-a`, `+a`, `NOT a`
    Unary {
        /// Which.
        op: UnaryOp,
        /// The operand.
        operand: Box<Expr>,
    },
    /// `a + b` and so on.
    Binary {
        /// Which.
        op: BinaryOp,
        /// Left.
        lhs: Box<Expr>,
        /// Right.
        rhs: Box<Expr>,
    },
    /// `(a)`
    Paren(Box<Expr>),
    /// `<EXP>` and the like.
    Placeholder,
    /// Text that was not understood, or is nested deeper than is read.
    Opaque,
}

/// Operators with one operand.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum UnaryOp {
    /// `-`
    Neg,
    /// `+`
    Plus,
    /// `NOT`
    Not,
}

/// Operators with two operands.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[allow(missing_docs, reason = "each is the operator it is named for")]
pub enum BinaryOp {
    Or,
    Xor,
    And,
    Lt,
    Le,
    Eq,
    Ge,
    Gt,
    Ne,
    Add,
    Sub,
    Mul,
    Div,
    IntDiv,
    Mod,
}
