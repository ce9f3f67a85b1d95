//! The outline of RAPID files, as a tool that is built on this crate would read it: whether all text was understood, every routine,
//! every call of an instruction that moves.
//!
//! `cargo run -p rapid-syntax --example outline -- FILE...` prints lines of `file`, `opaque`, `routine` and `move` with tabs between
//! their cells.

use rapid_syntax::diagnostic::FileId;
use rapid_syntax::tree::FileItem;
use rapid_syntax::{SourceFile, walk};
use std::io::Write;

const MOVES: [&str; 4] = ["movel", "movej", "movec", "moveabsj"];

fn main() -> std::io::Result<()> {
    let mut out = std::io::stdout().lock();
    for path in std::env::args().skip(1) {
        let file = SourceFile::read(FileId(0), path.clone(), std::fs::read(&path)?);
        writeln!(out, "file\t{path}")?;
        let nodes = walk::nodes(&file.tree);
        for node in nodes.iter().filter(|node| node.what == "opaque") {
            writeln!(out, "opaque\t{}", file.line(node.range))?;
        }
        for item in &file.tree.items {
            let FileItem::Module(module) = item else { continue };
            for routine in module.routines() {
                let name = String::from_utf8_lossy(file.text(routine.name));
                writeln!(out, "routine\t{}\t{name}", file.line(routine.name))?;
            }
        }
        // A call is followed by the name that it begins with.
        for pair in nodes.windows(2).filter(|pair| pair[0].what == "call") {
            let name = String::from_utf8_lossy(file.text(pair[1].range)).to_ascii_lowercase();
            if pair[0].range.start == pair[1].range.start && MOVES.contains(&name.as_str()) {
                writeln!(out, "move\t{}\t{name}", file.line(pair[1].range))?;
            }
        }
    }
    Ok(())
}
