//! How fast RAPID is read: long programs of linear moves with inline targets, as CAM writes them, with named targets, with targets
//! that Offs works out, and of conditions.

#![allow(missing_docs, reason = "criterion's macros make functions without docs")]

use criterion::{Criterion, Throughput, criterion_group, criterion_main};
use rapid_syntax::parse;
use std::fmt::Write as _;
use std::hint::black_box;

const MOVES: u32 = 20_000;

fn program(line: impl Fn(u32) -> String) -> Vec<u8> {
    let mut text = String::from("MODULE bench\n  PROC main()\n");
    for n in 0..MOVES {
        let _ = writeln!(text, "    {}", line(n)); // writing to a String does not fail
    }
    text.push_str("  ENDPROC\nENDMODULE\n");
    text.into_bytes()
}

fn inline(n: u32) -> String {
    let (x, y) = (n % 800, n % 600);
    format!(
        "MoveL [[-{x}.737, {y}.261, 15.471],[0.00000000, 0.00000000, 1.00000000, 0.00000000],[-1,0,-1,0],\
         [9E+09,9E+09,9E+09,9E+09,9E+09,9E+09]],rdkSpeed,z1,rdkTool,\\WObj:=rdkWObj;"
    )
}

fn parse_programs(c: &mut Criterion) {
    let programs = [
        ("inline targets", program(inline)),
        ("named targets", program(|n| format!("MoveL p{n},v100,z5,tGrip\\WObj:=wTable; ! {n}"))),
        ("offsets", program(|n| format!("MoveL Offs(p{n},0,0,50),v100,z5,tGrip\\WObj:=wTable; ! {n}"))),
        ("conditions", program(|n| format!("IF di{n}=1 THEN\n reg1:=reg1+{n};\n SetDO do1,1;\n ENDIF"))),
    ];
    let mut group = c.benchmark_group("parse");
    for (name, source) in &programs {
        group.throughput(Throughput::Bytes(source.len() as u64));
        group.bench_function(*name, |b| b.iter(|| parse(black_box(source))));
    }
    group.finish();
}

criterion_group!(benches, parse_programs);
criterion_main!(benches);
