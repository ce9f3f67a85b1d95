//! How fast the virtual controller executes: what a second of processor time carries out of loops, conditions, assignments of numbers,
//! components of records and calls.

#![allow(missing_docs, reason = "criterion's macros make functions without docs")]

use criterion::{Criterion, Throughput, criterion_group, criterion_main};
use std::hint::black_box;
use virtual_controller::{Controller, Outcome};

const PASSES: u64 = 100_000;

/// Name, body of the loop, and how many statements one pass of it is, FOR's own condition included.
const LOOPS: [(&str, &str, u64); 3] = [
    ("numbers", "b:=i*2+a; a:=b-i*2; IF b>1E9 THEN a:=0; ENDIF", 4),
    ("components", "p.trans.x:=p.trans.y+r{3}; r{2}:=p.trans.x*0.5; IF r{2}<0 THEN a:=1; ENDIF", 4),
    ("calls", "a:=plus(a,1); work;", 5),
];

fn program(body: &str) -> String {
    format!(
        "MODULE Bench\n\
         PERS robtarget p:=[[450,0,500],[0,0,1,0],[0,0,0,0],[9E9,9E9,9E9,9E9,9E9,9E9]];\n\
         VAR num a; VAR num b; VAR num r{{3}}:=[1,2,3];\n\
         FUNC num plus(num x,num y) RETURN x+y; ENDFUNC\n\
         PROC work() b:=1; ENDPROC\n\
         PROC main() FOR i FROM 1 TO {PASSES} DO {body} ENDFOR ENDPROC\n\
         ENDMODULE\n"
    )
}

fn execute(c: &mut Criterion) {
    let mut group = c.benchmark_group("interpreter");
    for (name, body, statements) in LOOPS {
        let mut controller = Controller::new();
        if let Err(error) = controller.load("bench.mod", program(body).as_bytes()) {
            panic!("{name}: {error}");
        }
        group.throughput(Throughput::Elements(PASSES * statements));
        group.bench_function(name, |b| {
            b.iter(|| {
                let outcome = controller.call(black_box("main"), 1);
                assert_eq!(outcome, Ok(Outcome::Finished), "{name}");
            });
        });
    }
    group.finish();
}

criterion_group!(benches, execute);
criterion_main!(benches);
