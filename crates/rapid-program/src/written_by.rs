//! Which of its arguments an instruction or a function of the controller writes: positions count those
//! without a backslash from 0, as ABB's reference manual orders them.

use super::expressions::value_of;
use super::index::{Ctx, Index};
use super::move_instructions::move_form;
use super::names::lower_case;
use super::other_instructions::harmless;
use rapid_syntax::tree::{Arg, ArgKind, Expr};

/// The arguments that an instruction writes, or may write.
pub(super) fn written_by_instruction<'a>(
    index: &Index<'_>,
    ctx: Ctx,
    name: &str,
    args: &'a [Arg],
) -> Vec<&'a Expr> {
    let positions = written_arguments(name);
    // What the controller's own do is known, what a routine that is not given does is a matter of its own. A move of a family that
    // hands back what it has read writes no more than other moves.
    let own = harmless(name) && move_form(name).is_none();
    let all = own && hands_back(name);
    let option_is = |option: &str| if own { !is_read_option(option) } else { is_written_option(option) };
    written(index, ctx, args, |position| all || positions.contains(&position), option_is)
}

/// The arguments that a function of the controller writes.
pub(super) fn written_by_function<'a>(
    index: &Index<'_>,
    ctx: Ctx,
    name: &str,
    args: &'a [Arg],
) -> Vec<&'a Expr> {
    let positions: &[usize] = match name {
        "strtoval" | "readdir" => &[1],
        "getnextsym" | "getnextmechunit" | "getnextcyclicbool" => &[0, 1],
        "testandset" => &[0],
        "paridposvalid" => &[2],
        "calcrotaxframez" | "calcrotaxisframe" | "defaccframe" => &[3, 4],
        _ => &[],
    };
    written(index, ctx, args, |position| positions.contains(&position), is_written_option)
}

fn written<'a>(
    index: &Index<'_>,
    ctx: Ctx,
    args: &'a [Arg],
    position_is: impl Fn(usize) -> bool,
    option_is: impl Fn(&str) -> bool,
) -> Vec<&'a Expr> {
    let mut position = 0;
    let is_written = |arg: &&Arg| match &arg.kind {
        ArgKind::Positional(_) => {
            position += 1;
            position_is(position - 1)
        }
        ArgKind::Named { name, .. } => option_is(&lower_case(index.text(ctx.file, *name))),
        ArgKind::Conditional { .. } => false,
    };
    args.iter().filter(is_written).filter_map(value_of).collect()
}

fn written_arguments(name: &str) -> &'static [usize] {
    match name {
        "incr" | "decr" | "add" | "clear" | "bitset" | "bitclear" | "fricidevaluate" => &[0],
        "searchl" | "searchc" | "searchextj" | "sigetcyclic" => &[1],
        "packrawbytes" | "packdnheader" => &[1],
        "sortdata" => &[0, 1],
        "copyrawbytes" | "ivarvalue" | "loadid" => &[2],
        "stoolrotcalib" => &[3],
        "mtoolrotcalib" => &[2, 3, 4],
        "mtooltcpcalib" | "stooltcpcalib" => &[4, 5, 6],
        "fitcircle" | "matrixsolve" | "matrixsolveqr" | "matrixsvd" => &[1, 2, 3],
        _ => &[],
    }
}

/// Whether it belongs to a family that hands back what it has read: any of its arguments may be written.
fn hands_back(name: &str) -> bool {
    const FAMILIES: [&str; 10] = [
        "cam",
        "egmgetid",
        "get",
        "read",
        "rmqget",
        "rmqread",
        "rmqsendwait",
        "socketreceive",
        "tpread",
        "unpack",
    ];
    FAMILIES.iter().any(|family| name.starts_with(family))
}

/// Options of instructions whose values are read; any other may be written, as `\NumVar`, `\ValueAtTimeout` are.
fn is_read_option(name: &str) -> bool {
    const READ: &[&str] = &[
        "block",
        "bool",
        "btnarray",
        "buttons",
        "defaultbtn",
        "defaultindex",
        "dnum",
        "equiplag",
        "exep",
        "file",
        "header",
        "icon",
        "image",
        "initvalue",
        "maxtime",
        "maxvalue",
        "mechunit",
        "message",
        "minvalue",
        "msgarray",
        "num",
        "object",
        "orient",
        "plength",
        "pollrate",
        "pos",
        "ramp",
        "reldist",
        "sdelay",
        "start",
        "time",
        "timeout",
        "tload",
        "tool",
        "toolref",
        "type",
        "v",
        "visualizetime",
        "wobj",
        "xpos",
    ];
    READ.binary_search(&name).is_ok()
}

/// Options of moves and functions that are written.
fn is_written_option(name: &str) -> bool {
    matches!(
        name,
        "breakflag"
            | "breaklist"
            | "data"
            | "errornumber"
            | "getdata"
            | "maxerr"
            | "norecbytes"
            | "rawdata"
            | "result"
            | "retthickness"
            | "rms"
            | "searchpoint"
            | "str"
            | "timeflag"
            | "valueattimeout"
    )
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn options_are_sorted() {
        for name in ["block", "exep", "maxtime", "wobj", "xpos"] {
            assert!(is_read_option(name), "{name}");
        }
        for name in ["valueattimeout", "numvar", "timeflag"] {
            assert!(!is_read_option(name), "{name}");
        }
    }
}
