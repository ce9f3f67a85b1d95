//! What the virtual controller holds no more of: data, files, interrupts.

use super::controller;
use virtual_controller::{Controller, Outcome};

/// Where a run of `main` was stopped, and why.
fn stopped(c: &mut Controller) -> (u32, String) {
    match c.call("main", 1).unwrap() {
        Outcome::OverLimit { at, what } => (at.line, what),
        other => panic!("{other:?}"),
    }
}

fn of_data(declarations: &str, locals: &str, body: &str) -> Controller {
    controller(&format!(
        "MODULE M\n{declarations}\n  PROC main()\n{locals}\n    {body}\n  ENDPROC\nENDMODULE\n"
    ))
}

#[test]
fn arrays_of_all_data_together_hold_five_million_values() {
    let (line, what) = stopped(&mut of_data("  VAR num big{1000,1000,1000};", "", "big{1,1,1}:=2;"));
    assert_eq!(line, 5, "{what}");
    assert!(what.contains("with big the program's data are more than 5000000 single values"), "{what}");
    // Each fits, both together do not; a robtarget is 17 numbers in four records and itself.
    let two = "  VAR num a{3000000};\n  VAR num b{3000000};";
    assert_eq!(stopped(&mut of_data(two, "", "a{1}:=1;\n    b{1}:=1;")).0, 7);
    let one = of_data(two, "", "a{1}:=1;\n    a{2}:=2;").call("main", 1).unwrap();
    assert_eq!(one, Outcome::Finished);
    assert!(
        stopped(&mut of_data("  VAR robtarget p{300000};", "", "p{1}.trans.x:=1;")).1.contains("with p ")
    );
}

#[test]
fn locals_and_copies_of_calls_in_one_another_count() {
    let calling = "  PROC again(num n)\n    VAR num a{100000};\n    a{1}:=n;\n    again n+1;\n  ENDPROC";
    assert!(stopped(&mut of_data(calling, "", "again 1;")).1.contains("with a local "));
    let handing = "  VAR num a{100000};\n  PROC again(num x{*})\n    again x;\n  ENDPROC";
    assert!(stopped(&mut of_data(handing, "", "again a;")).1.contains("with what is handed over "));
    // What is left is given back.
    let often = "  PROC once()\n    VAR num a{1000000};\n    a{1}:=1;\n  ENDPROC";
    let ended = of_data(often, "", "FOR i FROM 1 TO 6 DO once; ENDFOR").call("main", 1).unwrap();
    assert_eq!(ended, Outcome::Finished);
}

/// Each record holds two of the one before: forty of them would be a million million numbers.
#[test]
fn records_that_double_are_no_way_round() {
    let mut records = "  RECORD r0\n    num a;\n    num b;\n  ENDRECORD\n".to_owned();
    for k in 1..40 {
        records.push_str(&format!("  RECORD r{k}\n    r{0} a;\n    r{0} b;\n  ENDRECORD\n", k - 1));
    }
    let mut c = of_data(&format!("{records}  VAR r39 huge;"), "    VAR r39 other;", "other:=huge;");
    assert!(stopped(&mut c).1.contains("single values"));
}

#[test]
fn files_that_are_written_hold_16_mb() {
    let body = "Open \"HOME:\"\\File:=\"log.txt\",d\\Write;\n    WHILE TRUE DO\n      Write d,\"01234567890123456789012345678901234567890123456789012345678901234567890123456789\";\n    ENDWHILE";
    let mut c = of_data("  VAR iodev d;", "", body);
    assert!(
        matches!(c.call("main", 10_000_000).unwrap(), Outcome::OverLimit { what, .. } if what.contains("16777216 bytes"))
    );
}

#[test]
fn the_interrupt_after_the_hundredth_is_an_error() {
    let text = "  VAR intnum i{200};\n  PERS num n:=0;\n  TRAP t\n  ENDTRAP";
    let body = "FOR k FROM 1 TO 200 DO\n      CONNECT i{k} WITH t;\n      n:=k;\n    ENDFOR";
    let mut c = of_data(text, "", body);
    let Outcome::Failed { error, .. } = c.call("main", 1).unwrap() else { panic!("it went on") };
    assert_eq!(error.map(str::to_lowercase).as_deref(), Some("err_inomax"));
    assert_eq!(c.number("n"), Ok(100.0));
}
