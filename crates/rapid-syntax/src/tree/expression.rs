//! Expressions and arguments of the tree. An expression is 24 bytes, an argument 40: what is larger stands
//! in a box of its own.

use crate::diagnostic::TextRange;

/// An expression and where it stands.
#[derive(Clone, Debug, PartialEq)]
pub struct Expr {
    /// From its first byte to its last.
    pub range: TextRange,
    /// What kind of expression or argument it is.
    pub kind: ExprKind,
}

/// What an expression is.
#[derive(Clone, Debug, PartialEq)]
pub enum ExprKind {
    /// A number, as written, without sign.
    Number,
    /// A string with its quotes.
    String,
    /// The word TRUE or FALSE.
    Bool(bool),
    /// A name of data or of a signal.
    Name,
    /// `base.component`
    Field(Box<FieldExpr>),
    /// `base{i,j}`; `{*}` gives no index.
    Index(Box<IndexExpr>),
    /// `[a,b,c]`; boxed twice to be one pointer.
    Aggregate(Box<Box<[Expr]>>),
    /// `[1,[2,-3]]`, nothing but numbers and no comment: [`parts_of_numbers`](crate::parts_of_numbers)
    /// gives its parts.
    Numbers,
    /// `name(args)`: a function call.
    Call(Box<CallExpr>),
    /// `-a`, `+a`, `NOT a`
    Unary {
        /// The operator between or before the operands.
        op: UnaryOp,
        /// The operand behind the operator.
        operand: Box<Expr>,
    },
    /// `a + b` and so on.
    Binary(Box<BinaryExpr>),
    /// `(a)`
    Paren(Box<Expr>),
    /// `<EXP>` and the like.
    Placeholder,
    /// Text that was not understood, or is nested deeper than is read.
    Opaque,
}

/// `base.component`
#[derive(Clone, Debug, PartialEq)]
pub struct FieldExpr {
    /// The record that has the component.
    pub base: Expr,
    /// The name of the component.
    pub name: TextRange,
}

/// `base{i,j}`
#[derive(Clone, Debug, PartialEq)]
pub struct IndexExpr {
    /// The array that is indexed.
    pub base: Expr,
    /// One to three indices; none for `{*}`.
    pub indices: Box<[Expr]>,
}

/// `name(args)`
#[derive(Clone, Debug, PartialEq)]
pub struct CallExpr {
    /// The name of the function.
    pub name: TextRange,
    /// Its arguments in order.
    pub args: Box<[Arg]>,
}

/// `a + b` and so on.
#[derive(Clone, Debug, PartialEq)]
pub struct BinaryExpr {
    /// The operator between or before the operands.
    pub op: BinaryOp,
    /// The operand before the operator.
    pub lhs: Expr,
    /// The operand behind the operator.
    pub rhs: Expr,
}

/// One argument of a call of a procedure or function.
#[derive(Clone, Debug, PartialEq)]
pub struct Arg {
    /// The argument alone, without commas; the name of a required one (`Tool:=tGrip`) is part of it.
    pub range: TextRange,
    /// What kind of expression or argument it is.
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

#[cfg(test)]
mod tests {
    use super::*;
    use crate::tree::{CallStmt, DataDecl, ModuleItem, Stmt};

    #[test]
    fn nodes_are_small() {
        assert_eq!((size_of::<Expr>(), size_of::<Option<Expr>>()), (24, 24));
        assert_eq!((size_of::<Arg>(), size_of::<CallStmt>(), size_of::<Stmt>()), (40, 40, 48));
        assert_eq!((size_of::<DataDecl>(), size_of::<ModuleItem>()), (72, 72));
    }
}
