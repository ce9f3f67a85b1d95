//! The productions of statements that hold others, and of the blocks they hold.
//!
//! One file, because a block holds statements and statements hold blocks.

use super::block_head::{condition_up_to, end_word, head, last_word, opaque_expr};
use super::data::{data_declaration, is_task_declaration};
use super::expression::expression;
use super::input::{MAX_BLOCKS, NoMatch, Read, Text, failure_at};
use super::lexical::{FirstWord, any_word, blank, comment, name, sign, white, word};
use super::plain_statement::{plain_declaration, plain_statement};
use super::recover::{line_end, matching_end, resync};
use super::simple_statement::simple_statement;
use super::tree::{CompactIfStmt, Expr, ForStmt, IfStmt, Stmt, StmtKind, TestStmt, WhileStmt};
use super::word::Word;
use nom::Parser;
use nom::combinator::opt;
use nom::sequence::preceded;

/// `block = { statement | comment } ;`
///
/// Ends before a word that ends or divides one of the blocks that are open, and before what can stand in
/// no routine. Never fails: what is no statement becomes an opaque one.
pub(super) fn block<'a>(mut i: Text<'a>) -> (Text<'a>, Vec<Stmt>) {
    let mut stmts = Vec::new();
    loop {
        let next = white(i);
        if next.is_empty() {
            stmts.shrink_to_fit();
            return (i, stmts);
        }
        if let Ok((rest, range)) = comment(next) {
            stmts.push(Stmt { range, kind: StmtKind::Comment });
            i = rest;
            continue;
        }
        if let Some((rest, stmt)) = plain_statement(next) {
            stmts.push(stmt);
            i = rest;
            continue;
        }
        let first = any_word(next);
        if ends_block(next, first) {
            stmts.shrink_to_fit();
            return (i, stmts);
        }
        let (rest, stmt) =
            statement(next, first).unwrap_or_else(|failure| opaque(next, failure_at(&failure)));
        stmts.push(stmt);
        i = rest;
    }
}

fn ends_block(i: Text<'_>, first: FirstWord<'_>) -> bool {
    match first {
        Some((_, w)) if w.ends_statements() => true,
        Some((_, w)) => w.block_slot().is_some_and(|slot| i.state.awaited.get()[slot] > 0),
        None => is_task_declaration(i),
    }
}

/// `statement = simple_statement | if_statement | for_statement | while_statement | test_statement | data_declaration ;`
fn statement<'a>(i: Text<'a>, first: FirstWord<'a>) -> Read<'a, Stmt> {
    match first {
        Some((_, Word::If)) => if_statement(i),
        Some((_, Word::For)) => for_statement(i),
        Some((_, Word::While)) => while_statement(i),
        Some((_, Word::Test)) => test_statement(i),
        Some((_, Word::Var | Word::Const | Word::Pers)) => {
            let (rest, data) = plain_declaration(i).map_or_else(|| data_declaration(i), Ok)?;
            Ok((rest, Stmt { range: data.range, kind: StmtKind::Data(Box::new(data)) }))
        }
        _ => simple_statement(i, first),
    }
}

fn opaque<'a>(start: Text<'a>, reached: u32) -> (Text<'a>, Stmt) {
    let end = resync(start, reached);
    let range = start.until(end);
    start.state.warn(range, "syntax::statement", "this is no RAPID statement; it is kept as it is");
    (end, Stmt { range, kind: StmtKind::Opaque })
}

/// Runs a production one block deeper; beyond the limit all up to the construct's end is one opaque node.
fn in_block<'a>(i: Text<'a>, production: impl FnOnce(Text<'a>) -> Read<'a, Stmt>) -> Read<'a, Stmt> {
    i.state.in_block(|| production(i)).unwrap_or_else(|| {
        let end = matching_end(i);
        let range = i.until(end);
        let message = format!("blocks nest more than {MAX_BLOCKS} deep; this one is kept unread");
        i.state.warn(range, "syntax::deep", message);
        Ok((end, Stmt { range, kind: StmtKind::Opaque }))
    })
}

/// `if_statement = "IF" expression ( simple_statement | "THEN" block { elseif_arm } [ else_arm ] "ENDIF" ) ;`
pub(super) fn if_statement<'a>(i: Text<'a>) -> Read<'a, Stmt> {
    in_block(i, |i| {
        let (rest, _) = word(Word::If)(i)?;
        let (rest, cond) = expression(rest).or_else(|failure| {
            let (rest, cond) = condition_up_to(rest, Word::Then).ok_or(failure)?;
            Ok::<_, nom::Err<NoMatch>>((rest, cond))
        })?;
        match word(Word::Then)(rest) {
            Ok((rest, _)) => Ok(arms(i, rest, cond)),
            Err(_) => compact_if(i, rest, cond),
        }
    })
}

fn compact_if<'a>(start: Text<'a>, rest: Text<'a>, cond: Expr) -> Read<'a, Stmt> {
    let rest = blank(rest);
    let (rest, then) = match any_word(rest) {
        Some((_, Word::If)) => if_statement(rest)?,
        first => simple_statement(rest, first)?,
    };
    let kind = StmtKind::CompactIf(Box::new(CompactIfStmt { cond, then }));
    Ok((rest, Stmt { range: start.until(rest), kind }))
}

fn arms<'a>(start: Text<'a>, rest: Text<'a>, cond: Expr) -> (Text<'a>, Stmt) {
    let state = start.state;
    let mut arms = Vec::new();
    let mut next = Some(cond);
    let mut i = rest;
    state.awaiting(&[Word::ElseIf, Word::Else, Word::EndIf], || {
        while let Some(cond) = next.take() {
            let (rest, body) = block(i);
            arms.push((cond, body));
            i = rest;
            if let Some((rest, cond)) = elseif_arm(i) {
                i = rest;
                next = Some(cond);
            }
        }
    });
    let mut otherwise = None;
    if let Some((rest, body)) = else_arm(i) {
        i = rest;
        otherwise = Some(body);
    }
    i = end_word(start, i, Word::EndIf, "ENDIF");
    let kind = StmtKind::If(Box::new(IfStmt { arms, otherwise }));
    (i, Stmt { range: start.until(i), kind })
}

/// `elseif_arm = "ELSEIF" expression "THEN" block ;`
///
/// Up to its THEN; what is no condition becomes an opaque one.
fn elseif_arm<'a>(i: Text<'a>) -> Option<(Text<'a>, Expr)> {
    let (after, _) = word(Word::ElseIf)(i).ok()?;
    Some(head(after, Word::Then, "THEN"))
}

/// `else_arm = "ELSE" block ;`
fn else_arm<'a>(i: Text<'a>) -> Option<(Text<'a>, Vec<Stmt>)> {
    let (rest, _) = word(Word::Else)(i).ok()?;
    Some(i.state.awaiting(&[Word::EndIf], || block(rest)))
}

/// `for_statement = "FOR" name "FROM" expression "TO" expression [ "STEP" expression ] "DO" block "ENDFOR" ;`
pub(super) fn for_statement<'a>(i: Text<'a>) -> Read<'a, Stmt> {
    in_block(i, |i| {
        let (rest, (_, var)) = (word(Word::For), name).parse(i)?;
        let (rest, from) = preceded(word(Word::From), expression).parse(rest)?;
        let (rest, to) = preceded(word(Word::To), expression).parse(rest)?;
        let (rest, step) = opt(preceded(word(Word::Step), expression)).parse(rest)?;
        let rest = last_word(i, rest, Word::Do, "DO")?;
        let (rest, body) = i.state.awaiting(&[Word::EndFor], || block(rest));
        let rest = end_word(i, rest, Word::EndFor, "ENDFOR");
        let kind = StmtKind::For(Box::new(ForStmt { var, from, to, step, body }));
        Ok((rest, Stmt { range: i.until(rest), kind }))
    })
}

/// `while_statement = "WHILE" expression "DO" block "ENDWHILE" ;`
pub(super) fn while_statement<'a>(i: Text<'a>) -> Read<'a, Stmt> {
    in_block(i, |i| {
        let (rest, _) = word(Word::While)(i)?;
        let (rest, cond) = head(rest, Word::Do, "DO");
        let (rest, body) = i.state.awaiting(&[Word::EndWhile], || block(rest));
        let rest = end_word(i, rest, Word::EndWhile, "ENDWHILE");
        let kind = StmtKind::While(Box::new(WhileStmt { cond, body }));
        Ok((rest, Stmt { range: i.until(rest), kind }))
    })
}

/// `test_statement = "TEST" expression { case_arm } [ default_arm ] "ENDTEST" ;`
pub(super) fn test_statement<'a>(i: Text<'a>) -> Read<'a, Stmt> {
    in_block(i, |i| {
        let (mut rest, (_, value)) = (word(Word::Test), expression).parse(i)?;
        if !matches!(any_word(rest), Some((_, Word::Case | Word::Default | Word::EndTest))) {
            return blank(rest).no_match();
        }
        let mut cases = Vec::new();
        let mut default = None;
        i.state.awaiting(&[Word::Case, Word::Default, Word::EndTest], || {
            while let Some((after, case)) = case_arm(rest) {
                cases.push(case);
                rest = after;
            }
        });
        if let Some((after, body)) = default_arm(rest) {
            default = Some(body);
            rest = after;
        }
        rest = end_word(i, rest, Word::EndTest, "ENDTEST");
        let kind = StmtKind::Test(Box::new(TestStmt { value, cases, default }));
        Ok((rest, Stmt { range: i.until(rest), kind }))
    })
}

/// The values of a CASE and its statements.
type Case = (Vec<Expr>, Vec<Stmt>);

/// `case_arm = "CASE" expression { "," expression } ":" block ;`
///
/// A list that cannot be read is an opaque expression.
fn case_arm<'a>(i: Text<'a>) -> Option<(Text<'a>, Case)> {
    let (after, _) = word(Word::Case)(i).ok()?;
    let mut values = Vec::new();
    let mut rest = after;
    loop {
        let Ok((next, value)) = expression(rest) else {
            values.clear();
            break;
        };
        values.push(value);
        if let Ok((next, ())) = sign(b',')(next) {
            rest = next;
            continue;
        }
        match sign(b':')(next) {
            Ok((next, ())) => rest = next,
            Err(_) => values.clear(),
        }
        break;
    }
    if values.is_empty() {
        let (next, value) = opaque_expr(after, line_end(after));
        values.push(value);
        rest = next;
    }
    let (rest, body) = block(rest);
    Some((rest, (values, body)))
}

/// `default_arm = "DEFAULT" ":" block ;`
fn default_arm<'a>(i: Text<'a>) -> Option<(Text<'a>, Vec<Stmt>)> {
    let (after, range) = word(Word::Default)(i).ok()?;
    let rest = match sign(b':')(after) {
        Ok((rest, ())) => rest,
        Err(_) => {
            i.state.warn(range, "syntax::word", "a colon is missing after this");
            after
        }
    };
    Some(i.state.awaiting(&[Word::EndTest], || block(rest)))
}
