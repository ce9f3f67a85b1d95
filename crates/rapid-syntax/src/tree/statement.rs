//! Statements of the tree. Each is 48 bytes: its range, and a call, which most of them are, or what else it holds in a box.

use super::{Arg, DataDecl, Expr};
use crate::diagnostic::TextRange;

/// A statement and where it stands.
#[derive(Clone, Debug, PartialEq)]
pub struct Stmt {
    /// From its first byte to its semicolon or END word.
    pub range: TextRange,
    /// What kind of statement it is.
    pub kind: StmtKind,
}

/// What a statement is.
#[derive(Clone, Debug, PartialEq)]
pub enum StmtKind {
    /// A declaration in a routine.
    Data(Box<DataDecl>),
    /// `target := value;`
    Assign(Box<AssignStmt>),
    /// A procedure call or an instruction: `MoveL p10,v100,z5,tool0;`
    Call(CallStmt),
    /// `IF cond THEN ... ELSEIF ... ELSE ... ENDIF`
    If(Box<IfStmt>),
    /// `IF cond statement;`
    CompactIf(Box<CompactIfStmt>),
    /// `FOR i FROM a TO b [STEP c] DO ... ENDFOR`
    For(Box<ForStmt>),
    /// `WHILE cond DO ... ENDWHILE`
    While(Box<WhileStmt>),
    /// `TEST value CASE a,b: ... DEFAULT: ... ENDTEST`
    Test(Box<TestStmt>),
    /// `name:`
    Label(TextRange),
    /// `GOTO name;`
    Goto(TextRange),
    /// `RETURN [value];`
    Return(Option<Box<Expr>>),
    /// `RAISE [number];`
    Raise(Option<Box<Expr>>),
    /// `RETRY;`
    Retry,
    /// `TRYNEXT;`
    TryNext,
    /// `EXIT;`
    Exit,
    /// `CONNECT interrupt WITH trap;`
    Connect(Box<ConnectStmt>),
    /// A `;` that ends no statement.
    Empty,
    /// `<SMT>` and the like.
    Placeholder,
    /// A comment, without its line end.
    Comment,
    /// Text that was not understood.
    Opaque,
}

/// `target := value;`
#[derive(Clone, Debug, PartialEq)]
pub struct AssignStmt {
    /// A name, a component or an element.
    pub target: Expr,
    /// The expression that it becomes.
    pub value: Expr,
}

/// A call of a procedure or an instruction.
#[derive(Clone, Debug, PartialEq)]
pub struct CallStmt {
    /// The procedure or instruction that is called.
    pub callee: Callee,
    /// Its arguments in order.
    pub args: Box<[Arg]>,
    /// Written with parentheses round the arguments, as RoboDK's Main page does; no controller takes it.
    pub parenthesised: bool,
    /// Ends in a semicolon.
    pub terminated: bool,
}

/// Which procedure is called.
#[derive(Clone, Debug, PartialEq)]
pub enum Callee {
    /// By the name that stands here.
    Name(TextRange),
    /// `%expr%`: late binding, the name computed at run time; the expression between the percent signs.
    Late(Box<Expr>),
}

/// `IF cond THEN ... ELSEIF ... ELSE ... ENDIF`
#[derive(Clone, Debug, PartialEq)]
pub struct IfStmt {
    /// Conditions with their statements.
    pub arms: Vec<(Expr, Vec<Stmt>)>,
    /// The statements after ELSE.
    pub otherwise: Option<Vec<Stmt>>,
}

/// `IF cond statement;`
#[derive(Clone, Debug, PartialEq)]
pub struct CompactIfStmt {
    /// The condition between the words.
    pub cond: Expr,
    /// The one statement; its range lies inside.
    pub then: Stmt,
}

/// `FOR i FROM a TO b [STEP c] DO ... ENDFOR`
#[derive(Clone, Debug, PartialEq)]
pub struct ForStmt {
    /// The name of the loop variable.
    pub var: TextRange,
    /// The expression after FROM.
    pub from: Expr,
    /// The expression after TO.
    pub to: Expr,
    /// The expression after STEP.
    pub step: Option<Expr>,
    /// The statements in the loop.
    pub body: Vec<Stmt>,
}

/// `WHILE cond DO ... ENDWHILE`
#[derive(Clone, Debug, PartialEq)]
pub struct WhileStmt {
    /// The condition between the words.
    pub cond: Expr,
    /// The statements in the loop.
    pub body: Vec<Stmt>,
}

/// `TEST value CASE a,b: ... DEFAULT: ... ENDTEST`
#[derive(Clone, Debug, PartialEq)]
pub struct TestStmt {
    /// The value that is tested.
    pub value: Expr,
    /// Values and statements of each CASE.
    pub cases: Vec<(Vec<Expr>, Vec<Stmt>)>,
    /// The statements after DEFAULT.
    pub default: Option<Vec<Stmt>>,
}

/// `CONNECT interrupt WITH trap;`
#[derive(Clone, Debug, PartialEq)]
pub struct ConnectStmt {
    /// The interrupt number's variable.
    pub interrupt: Expr,
    /// The name of the trap.
    pub trap: TextRange,
}
