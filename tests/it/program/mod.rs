//! What `program` makes of RAPID: one file for each subject, snippets written by hand, values worked out
//! by hand.

mod at_any_time;
mod called_by_text;
mod circles;
mod corpus;
mod errors;
mod named_on_reading;
mod names;
mod not_all_given;
mod of_pers;
mod option_instructions;
mod order;
mod pages;
mod pressing_and_arcs;
mod readings_in_order;
mod robodk;
mod searches;
mod state;
mod targets;
mod unknown_moves;
mod unread_blocks;

use rapid_program::motion::Motion;
use rapid_program::{Overrides, Program};
use rapid_syntax::SourceFile;
use rapid_syntax::diagnostic::FileId;

/// A program of files: path and text.
fn program(files: &[(&str, &str)]) -> Program {
    let read = |(id, (path, text)): (usize, &(&str, &str))| {
        SourceFile::read(FileId(id as u32), *path, text.as_bytes().to_vec())
    };
    Program::read(files.iter().enumerate().map(read).collect(), &Overrides::default())
}

/// A program of one module with the given text between MODULE and ENDMODULE.
fn module(text: &str) -> Program {
    program(&[("M.mod", &format!("MODULE M\n{text}\nENDMODULE\n"))])
}

/// A program of one module: data, and the statements of `main`.
fn main_of(data: &str, statements: &str) -> Program {
    module(&format!("{data}\nPROC main()\n{statements}\nENDPROC"))
}

/// The code of a motion's reason to be kept.
fn code(motion: &Motion) -> Option<&'static str> {
    motion.skip_reason.as_ref().map(|k| k.code)
}

/// The codes of all motions, `-` for those that can be compensated.
fn codes(program: &Program) -> Vec<&'static str> {
    program.motions.iter().map(|m| code(m).unwrap_or("-")).collect()
}

/// x of every motion's tool in mm, rounded; `None` where the tool is not known.
fn tools_mm(program: &Program) -> Vec<Option<i32>> {
    let x = |m: &Motion| m.setup.tool.as_ref().map(|t| (t.frame_from_tcp.translation.x * 1e3).round() as i32);
    program.motions.iter().map(x).collect()
}

/// The codes of the diagnostics.
fn warnings(program: &Program) -> Vec<&'static str> {
    program.diagnostics.iter().map(|d| d.code).collect()
}

/// The line (from 1) where a motion's reason is to be seen.
fn because_line(program: &Program, motion: usize) -> u32 {
    let span = program.motions[motion].skip_reason.as_ref().unwrap().because.unwrap();
    program.file(span.file).line(span.range)
}

/// A robtarget at x, y, z mm, upright, without external axes.
fn at(x: i32, y: i32, z: i32) -> String {
    format!("[[{x},{y},{z}],[1,0,0,0],[0,0,0,0],[9E9,9E9,9E9,9E9,9E9,9E9]]")
}

/// A tool with its TCP at x mm.
fn tool(x: i32) -> String {
    format!("[TRUE,[[{x},0,0],[1,0,0,0]],[1,[0,0,1],[1,0,0,0],0,0,0]]")
}
