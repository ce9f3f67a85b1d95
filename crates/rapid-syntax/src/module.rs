//! The productions of a whole file: header, modules, and what stands round them.

use super::data::{data_declaration, scope};
use super::declaration::{alias_declaration, broken_record_end, record_declaration, routine};
use super::input::{Read, Text, failure_at};
use super::lexical::{
    any_word, blank, comment, identifier, is_space, line_len, name, past_name, sign, white, word,
};
use super::plain_statement::plain_declaration;
use super::recover::resync;
use super::tree::{FileItem, Module, ModuleItem, Tree};
use super::word::Word;
use crate::diagnostic::TextRange;
use nom::Parser;
use nom::multi::separated_list0;
use nom::sequence::delimited;

/// `file = [ header ] { module | comment } ;`
pub(super) fn file<'a>(i: Text<'a>) -> Tree {
    let mut tree = Tree::default();
    let mut i = i.skip(if i.rest.starts_with(BOM) { BOM.len() } else { 0 });
    if let Ok((rest, range)) = header(i) {
        tree.header = Some(range);
        i = rest;
    }
    loop {
        let next = white(i);
        if next.is_empty() {
            return tree;
        }
        i = if let Ok((rest, range)) = comment(next) {
            tree.items.push(FileItem::Comment(range));
            rest
        } else if let Ok((rest, module)) = module(next) {
            tree.items.push(FileItem::Module(module));
            rest
        } else {
            let end = foreign_end(next);
            let range = next.until(end);
            next.state.warn(range, "syntax::outside", "text outside of any module; it is kept as it is");
            tree.items.push(FileItem::Opaque(range));
            end
        };
    }
}

/// What an editor may put before the first byte of text in UTF-8.
pub(super) const BOM: &[u8] = b"\xEF\xBB\xBF";

/// Where text that begins at `start` and is no module ends: before a line with a module or a comment.
fn foreign_end(start: Text<'_>) -> Text<'_> {
    let mut end = start;
    loop {
        let line = end.skip(line_len(end.rest));
        let next = white(line);
        let last = without_trailing_space(start, line);
        if next.is_empty() || next.peek() == Some(b'!') || module_head(next).is_ok() {
            return last;
        }
        end = next;
    }
}

fn without_trailing_space<'a>(start: Text<'a>, end: Text<'a>) -> Text<'a> {
    let text = start.bytes_until(end);
    let len = text.iter().rposition(|&b| !is_space(b)).map_or(0, |p| p + 1);
    start.skip(len)
}

/// `header = "%%%" { ? any byte ? } "%%%" ;`
///
/// At the file's start only.
fn header<'a>(i: Text<'a>) -> Read<'a, TextRange> {
    let start = white(i);
    let Some(body) = start.rest.strip_prefix(b"%%%") else { return start.no_match() };
    match memchr::memmem::find(body, b"%%%") {
        Some(n) => {
            let end = start.skip(n + 6);
            Ok((end, start.until(end)))
        }
        None => start.no_match(),
    }
}

/// `module = module_head { data_declaration | record_declaration | alias_declaration | routine | comment | ";" } "ENDMODULE" ;`
fn module<'a>(i: Text<'a>) -> Read<'a, Module> {
    let start = white(i);
    let (mut i, (name, attributes)) = module_head(start)?;
    let head = start.until(i);
    if start.peek_at((name.start - start.at()) as usize).is_some_and(|b| b.is_ascii_digit()) {
        start.state.warn(name, "syntax::name", "a name begins with a letter; no controller loads this");
    }
    let mut items = Vec::new();
    let end = loop {
        let next = past_semicolons(i);
        if next.is_empty() {
            break None;
        }
        if let Ok((rest, range)) = comment(next) {
            items.push(ModuleItem::Comment(range));
            i = rest;
            continue;
        }
        if let Some((rest, data)) = plain_declaration(next) {
            items.push(ModuleItem::Data(data));
            i = rest;
            continue;
        }
        match any_word(next) {
            Some((rest, Word::EndModule)) => {
                i = rest;
                break Some(next.until(rest));
            }
            Some((_, Word::Module)) if module_head(next).is_ok() => break None,
            _ => {}
        }
        let (rest, item) = item(next).unwrap_or_else(|failure| opaque(next, failure_at(&failure)));
        items.push(item);
        i = rest;
    };
    items.shrink_to_fit();
    if end.is_none() {
        start.state.warn(head, "syntax::end", "the module that begins here has no ENDMODULE");
    }
    Ok((i, Module { range: start.until(i), head, name, attributes, items, end }))
}

/// `module_head = "MODULE" module_name [ "(" name { "," name } ")" ] ;`
fn module_head<'a>(i: Text<'a>) -> Read<'a, (TextRange, Vec<TextRange>)> {
    let (rest, (_, own_name)) = (word(Word::Module), module_name).parse(i)?;
    if blank(rest).peek() != Some(b'(') {
        return Ok((rest, (own_name, Vec::new())));
    }
    let list = separated_list0(sign(b','), identifier);
    let (rest, attributes) =
        delimited(sign(b'('), list, sign(b')')).parse(rest).unwrap_or((rest, Vec::new()));
    Ok((rest, (own_name, attributes)))
}

/// `module_name = name | digit { letter | digit | "_" } ;`
///
/// The second is what some files have and no controller takes.
fn module_name<'a>(i: Text<'a>) -> Read<'a, TextRange> {
    let start = blank(i);
    match start.peek() {
        Some(b'0'..=b'9') => {
            let end = past_name(start);
            Ok((end, start.until(end)))
        }
        _ => name(start),
    }
}

/// Past white space and the semicolons some put after ENDPROC.
fn past_semicolons(i: Text<'_>) -> Text<'_> {
    let mut next = white(i);
    while next.peek() == Some(b';') {
        next = white(next.skip(1));
    }
    next
}

fn item<'a>(i: Text<'a>) -> Read<'a, ModuleItem> {
    let Some((_, first)) = any_word(scope(i).0) else { return i.no_match() };
    match first {
        Word::Const | Word::Var | Word::Pers => data_declaration.map(ModuleItem::Data).parse(i),
        Word::Record => record_declaration.map(ModuleItem::Record).parse(i),
        Word::Alias => alias_declaration.map(ModuleItem::Alias).parse(i),
        Word::Proc | Word::Func | Word::Trap => {
            routine.map(|routine| ModuleItem::Routine(Box::new(routine))).parse(i)
        }
        _ => i.no_match(),
    }
}

/// What is no declaration: up to its end, and on over the lines that begin none.
fn opaque<'a>(start: Text<'a>, reached: u32) -> (Text<'a>, ModuleItem) {
    let mut end = broken_record_end(start).unwrap_or_else(|| resync(start, reached));
    loop {
        let next = white(end);
        if next.is_empty() || next.peek() == Some(b'!') || begins_item(next) {
            break;
        }
        end = resync(next, next.at());
    }
    let range = start.until(end);
    start.state.warn(range, "syntax::declaration", "this is no declaration; it is kept as it is");
    (end, ModuleItem::Opaque(range))
}

fn begins_item(i: Text<'_>) -> bool {
    use Word::*;
    let words = [Const, Var, Pers, Record, Alias, Proc, Func, Trap, Module, EndModule];
    any_word(scope(i).0).is_some_and(|(_, w)| words.contains(&w))
}
