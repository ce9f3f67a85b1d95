//! Expressions of names, numbers and operators alone are worked out on a short way: the same expressions with a function called for each
//! name go the general way, and both must come to the same bits, errors and counts.

use virtual_controller::{Controller, Outcome, Value};

/// Numbers that matter: whole ones, fractions, none, beyond a whole number's single precision, near the ends of it.
const VALUES: [&str; 9] = ["0", "1", "-3", "0.1", "7", "16777217", "-2.5E-7", "3E38", "4.2E-38"];

/// What stands for each name: itself, or a function that gives its value. `$[3$]` is an element.
const NAMES: [(&str, &str, &str); 11] = [
    ("$x", "x", "fx()"),
    ("$y", "y", "fy()"),
    ("$z", "z", "fz()"),
    ("$l", "l", "2.5*one()"),
    ("$b", "b", "fb()"),
    ("$t", "t", "ft()"),
    ("$r", "r.trans.x", "rx()"),
    ("$q", "r.rot.q1", "one()"),
    ("$m", "m{2,1}", "fz()"),
    ("$[", "a{", "el("),
    ("$]", "}", ")"),
];

const NUMBERS: [&str; 18] = [
    "$x+$y",
    "$x-$y*$z",
    "-$x",
    "+$x-(-$y)",
    "$x/$y",
    "$x*$y*$z",
    "$x DIV $y",
    "$x MOD $y",
    "($x+$y)*($x-$z)/3",
    "$x+1E38",
    "$r+$x",
    "$r*$q-$y",
    "$[1$]+$[2$]*$x",
    "$[$x$]",
    "$[$z-$x$]",
    "$m-$x",
    "$l+$x",
    "1/3+$x-16777217",
];

const CONDITIONS: [&str; 12] = [
    "$x<$y",
    "$x<=$y AND $y>$z",
    "$x>$y OR $[$x$]=1",
    "$x<>0 AND 1/$x>$y",
    "NOT ($x=$y)",
    "$b",
    "NOT $b AND $x>=$y",
    "$x=$y XOR $y=$z",
    "$r=$x",
    "0.1=$x",
    "16777217=$x",
    "$t",
];

/// A module whose `short` and `long` give the same; in `long` each name is a function's result.
fn module(expression: &str, is_condition: bool, [x, y, z]: [&str; 3]) -> String {
    let [short, long] = [0, 1].map(|way| {
        NAMES
            .iter()
            .fold(expression.to_owned(), |text, (token, name, call)| text.replace(token, [name, call][way]))
    });
    let ty = if is_condition { "bool" } else { "num" };
    let statement = |e: &str| match is_condition {
        true => format!("IF {e} THEN out:=TRUE; ELSE out:=FALSE; ENDIF"),
        false => format!("r.trans.y:={e}; m{{1,2}}:={e}; out:=m{{1,2}}+0*r.trans.y; out:=r.trans.y;"),
    };
    format!(
        "PERS {ty} out; VAR num errs:=0;\n\
         VAR num x:={x}; PERS num y:={y}; CONST num z:={z}; VAR bool b:=TRUE;\n\
         VAR robtarget r:=[[{x},0,500],[1,0,0,0],[0,0,0,0],[9E9,9E9,9E9,9E9,9E9,9E9]];\n\
         VAR num a{{3}}:=[1,2,{y}]; VAR num m{{2,2}}:=[[1,2],[{z},4]];\n\
         FUNC num fx() RETURN x; ENDFUNC FUNC num fy() RETURN y; ENDFUNC FUNC num fz() RETURN z; ENDFUNC\n\
         FUNC num one() RETURN 1; ENDFUNC FUNC bool fb() RETURN b; ENDFUNC FUNC bool ft() RETURN TRUE; ENDFUNC\n\
         FUNC num rx() RETURN r.trans.x; ENDFUNC FUNC num el(num i) RETURN a{{i}}; ENDFUNC\n\
         PROC short() VAR num l:=2.5; CONST bool t:=TRUE; {} ERROR errs:=ERRNO; RETURN; ENDPROC\n\
         PROC long() {} ERROR errs:=ERRNO; RETURN; ENDPROC\n",
        statement(&short),
        statement(&long),
    )
}

/// What a routine leaves: how it ended without its place, the result, and the error number it met.
fn left(c: &mut Controller, routine: &str) -> (String, Option<Value>, Option<Value>) {
    let outcome = match c.call(routine, 1).expect("a routine of the module") {
        Outcome::Finished => "finished".to_owned(),
        // An index may be outside in both, said with another place.
        other => format!("{other:?}").split_once('{').map_or_else(String::new, |(kind, _)| kind.to_owned()),
    };
    (outcome, c.value("out").ok(), c.value("errs").ok())
}

#[test]
fn the_short_way_comes_to_the_same() {
    let mut finished = 0;
    let mut raised = 0;
    for (expressions, is_condition) in [(&NUMBERS[..], false), (&CONDITIONS[..], true)] {
        for expression in expressions {
            for (i, x) in VALUES.iter().enumerate() {
                for (j, y) in VALUES.iter().enumerate() {
                    let z = VALUES[(i + 2 * j) % VALUES.len()];
                    let text = module(expression, is_condition, [x, y, z]);
                    let [short, long] = ["short", "long"].map(|routine| {
                        let mut c = Controller::new();
                        c.load("pure.mod", format!("MODULE Pure\n{text}ENDMODULE\n").as_bytes()).unwrap();
                        left(&mut c, routine)
                    });
                    assert_eq!(short, long, "{expression} with x = {x}, y = {y}, z = {z}");
                    finished += u32::from(short.0 == "finished");
                    raised += u32::from(short.2.is_some_and(|n| n != Value::Num(0.0)));
                }
            }
        }
    }
    // Both kinds of end are there: what is computed, and divisions by nothing and numbers too large.
    assert!(finished > 1500 && raised > 50, "{finished} {raised}");
}
