//! Statements and declarations of the forms that nearly every line of a large program has, past in one scan:
//! `MoveL p10,v100,z5,tGrip\WObj:=wTable;`, `n:=5;`, `CONST num n:=5;`.
//!
//! What is found is what the productions find: they take over wherever anything else stands, comments among it.

use super::input::Text;
use super::lexical::{in_name, is_space, string};
use super::plain_list::{PlainList, past_number};
use super::tree::{
    Arg, ArgKind, AssignStmt, CallStmt, Callee, DataDecl, DataKind, Expr, ExprKind, Scope, Stmt, StmtKind,
};
use super::word::Word;
use crate::diagnostic::TextRange;

/// More arguments than these are left to the productions.
const MOST_ARGUMENTS: usize = 8;

/// A call or an assignment of plain values that begins here, at its first letter.
pub(super) fn plain_statement<'a>(i: Text<'a>) -> Option<(Text<'a>, Stmt)> {
    let mut scan = Scan::new(i)?;
    let (name, None) = scan.name()? else { return None };
    let kind = match scan.next()? {
        b':' => {
            scan.becomes()?;
            let value = scan.value()?.expr();
            let target = Expr { range: name, kind: ExprKind::Name };
            scan.semicolon()?;
            StmtKind::Assign(Box::new(AssignStmt { target, value }))
        }
        b';' => {
            scan.semicolon()?;
            call(name, Box::default())
        }
        _ => call(name, scan.arguments()?),
    };
    let rest = i.skip(scan.at);
    Some((rest, Stmt { range: i.until(rest), kind }))
}

fn call(name: TextRange, args: Box<[Arg]>) -> StmtKind {
    StmtKind::Call(CallStmt { callee: Callee::Name(name), args, parenthesised: false, terminated: true })
}

/// A declaration of one datum, no array, with a plain value or none, that begins here, at its first letter.
pub(super) fn plain_declaration<'a>(i: Text<'a>) -> Option<(Text<'a>, DataDecl)> {
    let mut scan = Scan::new(i)?;
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
            Some(scan.value()?.expr())
        }
        _ => None,
    };
    scan.semicolon()?;
    let rest = i.skip(scan.at);
    let range = i.until(rest);
    Some((rest, DataDecl { range, scope, kind, type_name, name, dims: Box::default(), init }))
}

/// A value of one piece: a number without sign, a list of numbers, a name, a string, TRUE or FALSE.
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
}

impl PlainValue {
    #[inline(always)]
    fn expr(self) -> Expr {
        let kind = match self.kind {
            PlainKind::Number => ExprKind::Number,
            PlainKind::Numbers => ExprKind::Numbers,
            PlainKind::Name => ExprKind::Name,
            PlainKind::String => ExprKind::String,
            PlainKind::Bool(value) => ExprKind::Bool(value),
        };
        Expr { range: self.range, kind }
    }
}

/// An argument, before the room for all of them is taken at once.
#[derive(Clone, Copy)]
enum PlainArg {
    Positional(PlainValue),
    Option { range: TextRange, name: TextRange, value: Option<PlainValue> },
}

impl PlainArg {
    #[inline(always)]
    fn arg(&self) -> Arg {
        match *self {
            Self::Positional(value) => Arg { range: value.range, kind: ArgKind::Positional(value.expr()) },
            Self::Option { range, name, value } => {
                Arg { range, kind: ArgKind::Named { name, value: value.map(PlainValue::expr) } }
            }
        }
    }
}

/// How far a text has been scanned.
struct Scan<'a> {
    whole: Text<'a>,
    text: &'a [u8],
    at: usize,
    /// Where the text begins in the source.
    start: u32,
}

impl<'a> Scan<'a> {
    #[inline(always)]
    fn new(i: Text<'a>) -> Option<Self> {
        i.state.plain_forms.then(|| Self { whole: i, text: i.rest, at: 0, start: i.at() })
    }

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
        loop {
            let byte = self.peek()?;
            if !is_space(byte) {
                return Some(byte);
            }
            self.at += 1;
        }
    }

    #[inline(always)]
    fn semicolon(&mut self) -> Option<()> {
        (self.next()? == b';').then(|| self.at += 1)
    }

    /// `:=`, its colon being here.
    #[inline(always)]
    fn becomes(&mut self) -> Option<()> {
        (self.text.get(self.at + 1) == Some(&b'=')).then(|| self.at += 2)
    }

    /// The bytes of a name that begins here with a letter of ASCII.
    #[inline(always)]
    fn identifier(&mut self) -> Option<TextRange> {
        let from = self.at;
        if !self.peek()?.is_ascii_alphabetic() {
            return None;
        }
        self.at += 1;
        while self.peek().is_some_and(in_name) {
            self.at += 1;
        }
        Some(self.since(from))
    }

    /// A name that begins here, and which reserved word it is, if one.
    #[inline(always)]
    fn name(&mut self) -> Option<(TextRange, Option<Word>)> {
        let from = self.at;
        let range = self.identifier()?;
        Some((range, Word::of(self.text.get(from..self.at)?)))
    }

    #[inline(always)]
    fn next_name(&mut self) -> Option<(TextRange, Option<Word>)> {
        self.next()?;
        self.name()
    }

    /// A value after white space.
    #[inline(always)]
    fn value(&mut self) -> Option<PlainValue> {
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
            b'"' => {
                let (_, range) = string(self.whole.skip(from)).ok()?;
                self.at += range.len() as usize;
                PlainKind::String
            }
            _ => match self.name()?.1 {
                None => PlainKind::Name,
                Some(Word::True) => PlainKind::Bool(true),
                Some(Word::False) => PlainKind::Bool(false),
                Some(_) => return None,
            },
        };
        Some(PlainValue { range: self.since(from), kind })
    }

    /// An option that begins here with its backslash.
    #[inline(always)]
    fn option(&mut self) -> Option<PlainArg> {
        let from = self.at;
        self.at += 1;
        let name = self.identifier()?;
        let mut range = self.since(from);
        let mut value = None;
        if self.next()? == b':' {
            self.becomes()?;
            value = Some(self.value()?);
            range = self.since(from);
        }
        Some(PlainArg::Option { range, name, value })
    }

    /// Arguments, the first after white space, up to and with the semicolon.
    #[inline(always)]
    fn arguments(&mut self) -> Option<Box<[Arg]>> {
        const NONE: PlainArg =
            PlainArg::Positional(PlainValue { range: TextRange { start: 0, end: 0 }, kind: PlainKind::Name });
        let mut args = [NONE; MOST_ARGUMENTS];
        let mut count = 0;
        loop {
            let arg = args.get_mut(count)?;
            *arg = match self.next()? {
                b'\\' => self.option()?,
                _ => PlainArg::Positional(self.value()?),
            };
            count += 1;
            match self.next()? {
                b',' => self.at += 1,
                b'\\' => {}
                b';' => break,
                _ => return None,
            }
        }
        self.at += 1;
        Some(args.get(..count)?.iter().map(PlainArg::arg).collect())
    }
}

#[cfg(test)]
mod tests;
