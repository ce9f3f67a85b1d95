//! Statements and declarations of the forms that nearly every line of a large program has, past in one scan:
//! `MoveL Offs(p10,0,0,50),v100,z5,tGrip\WObj:=wTable;`, `n:=5;`, `CONST num n:=5;`.
//!
//! What is found is what the productions find: they take over wherever anything else stands, comments among it.

use super::input::Text;
use super::lexical::{in_name, is_space, string};
use super::plain_list::{PlainList, past_number};
use super::tree::{
    Arg, ArgKind, AssignStmt, CallExpr, CallStmt, Callee, DataDecl, DataKind, Expr, ExprKind, FieldExpr,
    Scope, Stmt, StmtKind, UnaryOp,
};
use super::word::Word;
use crate::diagnostic::TextRange;

/// More arguments than these are left to the productions.
const MOST_ARGUMENTS: usize = 8;
/// Calls within calls, and components of components, are left to the productions where there are more.
const DEEPEST: usize = 4;

/// A call or an assignment of plain values that begins here, at its first letter.
pub(super) fn plain_statement<'a>(i: Text<'a>) -> Option<(Text<'a>, Stmt)> {
    scanned(i, |scan| {
        let name = scan.free_name()?;
        Some(match scan.next()? {
            b':' => scan.assignment(Expr { range: name, kind: ExprKind::Name })?,
            b'.' => {
                let target = scan.components(0, name)?;
                scan.next()?;
                scan.assignment(target)?
            }
            b';' => call(name, Box::default()),
            _ => call(name, scan.arguments(DEEPEST)?),
        })
    })
    .map(|(rest, kind)| (rest, Stmt { range: i.until(rest), kind }))
}

fn call(name: TextRange, args: Box<[Arg]>) -> StmtKind {
    StmtKind::Call(CallStmt { callee: Callee::Name(name), args, parenthesised: false, terminated: true })
}

/// A declaration of one datum, no array, with a plain value or none, that begins here, at its first letter.
pub(super) fn plain_declaration<'a>(i: Text<'a>) -> Option<(Text<'a>, DataDecl)> {
    let (rest, mut data) = scanned(i, |scan| {
        let (scope, first) = match scan.name()?.1? {
            Word::Local => (Scope::Local, scan.next_name()?.1?),
            first => (Scope::Global, first),
        };
        let kind = match first {
            Word::Const => DataKind::Const,
            Word::Var => DataKind::Var,
            Word::Pers => DataKind::Pers,
            _ => return None,
        };
        let (type_name, None) = scan.next_name()? else { return None };
        let (name, None) = scan.next_name()? else { return None };
        let init = match scan.next()? {
            b':' => {
                scan.becomes()?;
                Some(scan.whole_value()?)
            }
            _ => None,
        };
        Some(DataDecl { range: name, scope, kind, type_name, name, dims: Box::default(), init })
    })?;
    data.range = i.until(rest);
    Some((rest, data))
}

/// What `form` finds from here on, and the rest behind the semicolon that must follow.
#[inline(always)]
fn scanned<'a, T>(i: Text<'a>, form: impl FnOnce(&mut Scan<'a, '_>) -> Option<T>) -> Option<(Text<'a>, T)> {
    if !i.state.plain_forms {
        return None;
    }
    let mut composed = i.state.composed.borrow_mut();
    composed.clear();
    let mut scan = Scan { whole: i, text: i.rest, at: 0, start: i.at(), composed: &mut composed };
    let found = form(&mut scan)?;
    let semicolon = scan.next()? == b';';
    semicolon.then(|| (i.skip(scan.at + 1), found))
}

/// A value as it is scanned, in a few words: the tree's nodes are made when all arguments of a call are known, each in its place.
#[derive(Clone, Copy)]
struct PlainValue {
    range: TextRange,
    kind: PlainKind,
}

#[derive(Clone, Copy)]
enum PlainKind {
    Number,
    Numbers,
    Name,
    String,
    Bool(bool),
    /// The next of [`Scan::composed`].
    Composed,
}

impl PlainValue {
    #[inline(always)]
    fn expr(self, composed: &mut impl Iterator<Item = Expr>) -> Expr {
        let range = self.range;
        let kind = match self.kind {
            PlainKind::Number => ExprKind::Number,
            PlainKind::Numbers => ExprKind::Numbers,
            PlainKind::Name => ExprKind::Name,
            PlainKind::String => ExprKind::String,
            PlainKind::Bool(value) => ExprKind::Bool(value),
            PlainKind::Composed => return composed.next().unwrap_or(Expr { range, kind: ExprKind::Opaque }),
        };
        Expr { range, kind }
    }
}

#[derive(Clone, Copy)]
enum PlainArg {
    Positional(PlainValue),
    Named { range: TextRange, name: TextRange, value: Option<PlainValue> },
}

impl PlainArg {
    #[inline(always)]
    fn arg(self, composed: &mut impl Iterator<Item = Expr>) -> Arg {
        match self {
            Self::Positional(value) => {
                Arg { range: value.range, kind: ArgKind::Positional(value.expr(composed)) }
            }
            Self::Named { range, name, value } => {
                let value = value.map(|value| value.expr(composed));
                Arg { range, kind: ArgKind::Named { name, value } }
            }
        }
    }
}

/// How far a text has been scanned.
struct Scan<'a, 's> {
    whole: Text<'a>,
    text: &'a [u8],
    at: usize,
    /// Where the text begins in the source.
    start: u32,
    /// Values of several parts, in order, of the calls that are scanned.
    composed: &'s mut Vec<Expr>,
}

impl Scan<'_, '_> {
    /// From byte `from` to here.
    #[inline(always)]
    fn since(&self, from: usize) -> TextRange {
        TextRange { start: self.start + from as u32, end: self.start + self.at as u32 }
    }

    #[inline(always)]
    fn peek(&self) -> Option<u8> {
        self.text.get(self.at).copied()
    }

    /// The byte after white space.
    #[inline(always)]
    fn next(&mut self) -> Option<u8> {
        let tail = self.text.get(self.at..)?;
        let spaces = tail.iter().position(|&byte| !is_space(byte))?;
        self.at += spaces;
        tail.get(spaces).copied()
    }

    /// `:=`
    #[inline(always)]
    fn becomes(&mut self) -> Option<()> {
        let both = self.text.get(self.at..)?.starts_with(b":=");
        both.then(|| self.at += 2)
    }

    /// The bytes of a name that begins here with a letter of ASCII.
    #[inline(always)]
    fn identifier(&mut self) -> Option<TextRange> {
        let (from, tail) = (self.at, self.text.get(self.at..)?);
        if !tail.first()?.is_ascii_alphabetic() {
            return None;
        }
        self.at += tail.iter().position(|&byte| !in_name(byte)).unwrap_or(tail.len());
        Some(self.since(from))
    }

    /// A name that begins here, and which reserved word it is, if one.
    #[inline(always)]
    fn name(&mut self) -> Option<(TextRange, Option<Word>)> {
        let from = self.at;
        let range = self.identifier()?;
        Some((range, Word::of(self.text.get(from..self.at)?)))
    }

    /// A name that is no reserved word.
    #[inline(always)]
    fn free_name(&mut self) -> Option<TextRange> {
        let (range, None) = self.name()? else { return None };
        Some(range)
    }

    #[inline(always)]
    fn next_name(&mut self) -> Option<(TextRange, Option<Word>)> {
        self.next()?;
        self.name()
    }

    /// From its `:=` on.
    fn assignment(&mut self, target: Expr) -> Option<StmtKind> {
        self.becomes()?;
        let value = self.whole_value()?;
        Some(StmtKind::Assign(Box::new(AssignStmt { target, value })))
    }

    /// A value that is no argument.
    #[inline(always)]
    fn whole_value(&mut self) -> Option<Expr> {
        let value = self.value(DEEPEST)?;
        Some(value.expr(&mut self.composed.drain(..)))
    }

    /// A value after white space, with so many calls within each other: a number, a list of numbers, a string, TRUE or FALSE, a
    /// name, a component, a call. What follows it must be no operator and no index, for the caller to see.
    #[inline(always)]
    fn value(&mut self, depth: usize) -> Option<PlainValue> {
        let first = self.next()?;
        let from = self.at;
        let kind = match first {
            b'[' => {
                self.at += PlainList::begins(self.text.get(from..)?)?.len;
                PlainKind::Numbers
            }
            b'0'..=b'9' => {
                self.at = past_number(self.text, from)?;
                PlainKind::Number
            }
            b'-' => {
                self.negative()?;
                PlainKind::Composed
            }
            b'"' => {
                let (_, range) = string(self.whole.skip(from)).ok()?;
                self.at += range.len() as usize;
                PlainKind::String
            }
            _ => match self.name()? {
                (name, None) => match self.peek()? {
                    b'(' => {
                        self.call(name, depth)?;
                        PlainKind::Composed
                    }
                    b'.' => {
                        let components = self.components(from, name)?;
                        self.composed.push(components);
                        PlainKind::Composed
                    }
                    _ => PlainKind::Name,
                },
                (_, Some(Word::True)) => PlainKind::Bool(true),
                (_, Some(Word::False)) => PlainKind::Bool(false),
                (_, Some(_)) => return None,
            },
        };
        Some(PlainValue { range: self.since(from), kind })
    }

    /// A number with a minus sign.
    #[inline(never)]
    fn negative(&mut self) -> Option<()> {
        let from = self.at;
        self.at = past_number(self.text, from + 1)?;
        let number = Expr { range: self.since(from + 1), kind: ExprKind::Number };
        let kind = ExprKind::Unary { op: UnaryOp::Neg, operand: Box::new(number) };
        self.composed.push(Expr { range: self.since(from), kind });
        Some(())
    }

    /// A function's call, from its parenthesis on.
    #[inline(never)]
    fn call(&mut self, name: TextRange, depth: usize) -> Option<()> {
        let depth = depth.checked_sub(1)?;
        self.at += 1;
        let args = if self.next()? == b')' { Box::default() } else { self.arguments(depth)? };
        if self.next()? != b')' {
            return None;
        }
        self.at += 1;
        let range = TextRange { start: name.start, end: self.start + self.at as u32 };
        self.composed.push(Expr { range, kind: ExprKind::Call(Box::new(CallExpr { name, args })) });
        Some(())
    }

    /// Components of the datum `name`, which begins at byte `from`: from the point behind it on. Nodes are made only where what
    /// follows is no operator, which many components have.
    #[inline(never)]
    fn components(&mut self, from: usize, name: TextRange) -> Option<Expr> {
        let mut names = [name; DEEPEST];
        let mut count = 0;
        while self.peek()? == b'.' {
            self.at += 1;
            *names.get_mut(count)? = self.identifier()?;
            count += 1;
        }
        let end = self.at;
        let follows = self.next()?;
        self.at = end;
        if !matches!(follows, b':' | b',' | b';' | b')' | b'\\') {
            return None;
        }
        let start = self.start + from as u32;
        let datum = Expr { range: name, kind: ExprKind::Name };
        Some(names.get(..count)?.iter().fold(datum, |base, &name| {
            let field = Box::new(FieldExpr { base, name });
            Expr { range: TextRange { start, end: name.end }, kind: ExprKind::Field(field) }
        }))
    }

    /// An option that begins here with its backslash.
    #[inline(always)]
    fn option(&mut self, depth: usize) -> Option<PlainArg> {
        let from = self.at;
        self.at += 1;
        let name = self.identifier()?;
        let mut range = self.since(from);
        let mut value = None;
        if self.next()? == b':' {
            self.becomes()?;
            value = Some(self.value(depth)?);
            range = self.since(from);
        }
        Some(PlainArg::Named { range, name, value })
    }

    /// Arguments, the first after white space, up to the semicolon or parenthesis that ends them.
    #[inline(always)]
    fn arguments(&mut self, depth: usize) -> Option<Box<[Arg]>> {
        const NONE: PlainArg =
            PlainArg::Positional(PlainValue { range: TextRange { start: 0, end: 0 }, kind: PlainKind::Name });
        let mut args = [NONE; MOST_ARGUMENTS];
        let mut count = 0;
        let composed_before = self.composed.len();
        loop {
            *args.get_mut(count)? = match self.next()? {
                b'\\' => self.option(depth)?,
                _ => PlainArg::Positional(self.value(depth)?),
            };
            count += 1;
            match self.next()? {
                b',' => self.at += 1,
                b'\\' => {}
                b';' | b')' => break,
                _ => return None,
            }
        }
        let mut composed = self.composed.drain(composed_before..);
        Some(args.get(..count)?.iter().map(|arg| arg.arg(&mut composed)).collect())
    }
}

#[cfg(test)]
mod tests;
