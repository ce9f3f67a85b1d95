//! What `restore` says of values that were changed by hand, exchanged, or written anew by a controller, and of names that were put in.

use super::{Bench, driftpost, err};

pub(super) const REST: &str = "[0.0871557,0,0.9961947,0],[0,-1,0,0],[9E9,9E9,9E9,9E9,9E9,9E9]]";
pub(super) const HOME: &str = "MoveAbsJ [[5,10,20,5,50,5],[9E9,9E9,9E9,9E9,9E9,9E9]],v500,fine,tGun;";

/// A module of data and motions; `@` stands for all of a robtarget behind its position.
pub(super) fn module(data: &str, motions: &str) -> String {
    let text = format!(
        "MODULE A\nRECORD spot\nrobtarget at;\nrobtarget next;\nnum k;\nENDRECORD\n\
         PERS tooldata tGun:=[TRUE,[[0,0,120],[1,0,0,0]],[1,[0,0,50],[1,0,0,0],0,0,0]];\n\
         PERS num nPos:=1;\n{data}\nPROC main()\n{HOME}\n{motions}\nENDPROC\nENDMODULE\n"
    );
    text.replace('@', REST)
}

/// The module in a form, which gives it back byte for byte.
pub(super) fn compensated(bench: &Bench, source: &str, form: &str) -> String {
    let (from, to) = (bench.file("a.mod", source), bench.path("o.mod").display().to_string());
    let made = driftpost(&["compensate", &from, "-o", &to, "--form", form, "--diff", "none", "--force"]);
    assert_eq!(made.status.code(), Some(0), "{form}: {}", err(&made));
    let text = bench.text("o.mod");
    let (message, back) = restored(bench, &text, 0);
    assert!(back == source && is_silent(&message), "{form}: {message}");
    text
}

/// What is said of a changed module, and the original that is got back; it ends with `code`.
pub(super) fn restored(bench: &Bench, changed: &str, code: i32) -> (String, String) {
    let (from, to) = (bench.file("changed.mod", changed), bench.path("back.mod").display().to_string());
    let output = driftpost(&["restore", &from, "-o", &to, "--force"]);
    assert_eq!(output.status.code(), Some(code), "{}\n{changed}", err(&output));
    (err(&output), if code == 2 { String::new() } else { bench.text("back.mod") })
}

fn is_silent(message: &str) -> bool {
    ["touched up", "changed where", "warning", "error"].iter().all(|word| !message.contains(word))
}

/// The text with `from` in place of `by`, and the other way.
fn exchanged(text: &str, from: &str, by: &str) -> String {
    assert_eq!((text.matches(from).count(), text.matches(by).count()), (1, 1), "{from} {by}");
    text.replace(from, "\u{1}").replace(by, from).replace('\u{1}', by)
}

pub(super) fn once(text: &str, from: &str, by: &str) -> String {
    assert_eq!(text.matches(from).count(), 1, "{from}");
    text.replace(from, by)
}

#[test]
fn values_that_were_exchanged_are_told() {
    let bench = Bench::default();
    let source = module(
        "CONST robtarget p20:=[[430,60,300],@;\nCONST robtarget p30:=[[460,80,330],@;\n\
         CONST spot sp:=[[[435,60,300],@,[[438,70,300],@,1];\n\
         CONST robtarget g{2,2}:=[[[[440,60,310],@,[[441,30,310],@],[[[442,62,350],@,[[443,63,270],@]];",
        "MoveL p20,v100,fine,tGun;\nMoveL p30,v100,fine,tGun;\nMoveL Offs(p20,0,0,5),v100,fine,tGun;\n\
         MoveL g{nPos,2},v100,fine,tGun;\nMoveL sp.at,v100,fine,tGun;\nMoveL sp.next,v100,fine,tGun;\n\
         MoveL [[444,50,300],@,v100,fine,tGun;\nMoveL [[444,50,340],@,v100,fine,tGun;",
    );
    for form in ["ramp", "live", "auto"] {
        let text = compensated(&bench, &source, form);
        for (a, b, named) in [
            ("p20:=[[430,60,300]", "p30:=[[460,80,330]", ["p20 was", "p30 was"]),
            ("[[441,30,310]", "[[443,63,270]", ["g{1,2} was", "g{2,2} was"]),
            ("[[435,60,300]", "[[438,70,300]", ["sp was", "by 10.4403 mm"]),
        ] {
            let (a, b) = (a.trim_start_matches("p20:="), b.trim_start_matches("p30:="));
            let (message, back) = restored(&bench, &exchanged(&text, a, b), 1);
            assert!(named.iter().all(|name| message.contains(name)), "{form}: {message}");
            assert_eq!(message.matches("touched up on the controller by").count(), 2, "{form}: {message}");
            assert_eq!(back, exchanged(&source, a, b), "{form}");
        }
        // The model corrects a target wherever it is asked; a correction is that of one place.
        let inline = exchanged(&text, "[[444,50,300]", "[[444,50,340]");
        let (message, _) = restored(&bench, &inline, if form == "live" { 0 } else { 1 });
        assert!(form == "live" || message.matches("by 40.0000 mm").count() == 2, "{form}: {message}");
        // Motions that were exchanged are no touched-up points.
        let line = |what: &str| text.lines().find(|line| line.starts_with("MoveL") && line.contains(what));
        for (a, b) in [("(p20,", "(p30,"), ("[[444,50,300]", "[[444,50,340]"), ("sp.at", "sp.next")] {
            let moved = exchanged(&text, line(a).unwrap(), line(b).unwrap());
            let (message, _) = restored(&bench, &moved, 0);
            assert!(is_silent(&message), "{form}: {message}");
        }
    }
}

/// Arrays hold what stands in an expression, and what is changed there moves no motion.
#[test]
fn what_an_expression_names_in_schedule_is_told_when_it_is_changed() {
    let bench = Bench::default();
    let source = module(
        "CONST num dz:=5;\nCONST robtarget p20:=[[430,60,300],@;\nCONST robtarget p30:=[[435,60,300],@;\n\
         PERS robtarget p40:=[[438,60,300],@;\nCONST spot sp:=[[[439,60,300],@,[[439,70,300],@,1];\n\
         CONST robtarget g{2,2}:=[[[[440,60,310],@,[[441,61,310],@],[[[442,62,310],@,[[443,63,310],@]];",
        "MoveL p20,v100,fine,tGun;\nMoveL Offs(p20,0,0,dz),v100,fine,tGun;\nMoveL Offs(p30,0,0,5),v100,fine,tGun;\n\
         MoveL RelTool(p40,0,0,-5),v100,fine,tGun;\nMoveL sp.at,v100,fine,tGun;\n\
         MoveL Offs(g{nPos,2},0,0,5),v100,fine,tGun;",
    );
    let text = compensated(&bench, &source, "schedule");
    for (from, by, name) in [
        ("p20:=[[430,", "p20:=[[431,", "p20"),
        ("p30:=[[435,", "p30:=[[436,", "p30"),
        ("p40:=[[438,", "p40:=[[439,", "p40"),
        ("sp:=[[[439,", "sp:=[[[440,", "sp"),
        ("[[443,63,310]", "[[444,63,310]", "g{2,2}"),
    ] {
        let (message, back) = restored(&bench, &once(&text, from, by), 1);
        let told = format!(
            "{name} was changed where it is declared by 1.0000 mm; the corrected motions went by its array"
        );
        assert_eq!(message.matches(&told).count(), 1, "{name}: {message}");
        assert_eq!(back, once(&source, from, by));
    }
    let (message, _) = restored(&bench, &once(&text, "dz:=5", "dz:=60"), 1);
    assert!(message.contains("restore::expression") && message.contains("Offs(p20,0,0,dz)"), "{message}");
}

#[test]
fn what_is_written_out_in_an_expression_is_told_when_it_is_changed() {
    let bench = Bench::default();
    let source = module(
        "CONST num dz:=5;\nCONST robtarget p20:=[[430,60,300],@;",
        "MoveL Offs([[430,50,300],@,0,0,5),v100,fine,tGun;\nMoveL Offs(p20,0,0,dz),v100,fine,tGun;\n\
         MoveL Offs(p20,0,0,7),v100,fine,tGun;",
    );
    for form in ["ramp", "live", "auto"] {
        let text = compensated(&bench, &source, form);
        let (message, back) = restored(&bench, &once(&text, "[[430,50,", "[[432,50,"), 1);
        assert!(message.contains("was touched up on the controller by 2.0000 mm"), "{form}: {message}");
        assert_eq!(back, once(&source, "[[430,50,", "[[432,50,"));
        for (from, by, expression) in
            [("dz:=5", "dz:=60", "Offs(p20,0,0,dz)"), ("(p20,0,0,7)", "(p20,0,0,70)", "Offs(p20,0,0,70)")]
        {
            let (message, back) = restored(&bench, &once(&text, from, by), 1);
            let told = format!("{expression} is not as it was made");
            assert!(
                message.contains("warning[restore::expression]") && message.contains(&told),
                "{form}: {message}"
            );
            assert_eq!((message.matches("touched up").count(), back), (0, once(&source, from, by)), "{form}");
        }
        // Laid out anew.
        let anew = text
            .replace("(p20,0,0,7)", "( P20, 0.0, 0, 7.00 )")
            .replace("[[430,50,300]", "[ [430.0, 50,300.00]");
        assert!(is_silent(&restored(&bench, &anew, 0).0), "{form}");
    }
}

#[test]
fn numbers_in_six_digits_are_what_they_were_in_any_form() {
    let bench = Bench::default();
    let full = "[[430.12345,60.765432,300.555555],[0.0123456,0.123456789,0.991,0.05123456]";
    let short = "[[430.123,60.7654,300.556],[0.0123456,0.123457,0.991,0.0512346]";
    let source = module(
        "PERS robtarget p20:=[[430.12345,60.765432,300.555555],[0.0123456,0.123456789,0.991,0.05123456],[0,-1,0,0],\
         [9E9,9E9,9E9,9E9,9E9,9E9]];\nPERS spot sp:=[[[439,60,300],@,[[439,70,300],@,1];\n\
         PERS robtarget far:=[[1438.1264,60,300],@;",
        "MoveL p20,v100,fine,tGun;\nMoveL sp.at,v100,fine,tGun;\nMoveL Offs(p20,0,0,5),v100,fine,tGun;\n\
         MoveL Offs(far,-1000,0,5),v100,fine,tGun;",
    );
    for form in ["schedule", "ramp", "live", "auto"] {
        let text = compensated(&bench, &source, form);
        let is_data = |line: &&str| line.starts_with("PERS");
        let saved: String = text
            .lines()
            .map(|line| match is_data(&line) {
                true => line.replace(full, short).replace("0.9961947", "0.996195").replace("1438.1264", "1438.13"),
                false => line.to_owned(),
            } + "\n")
            .collect();
        // What a program counts in a PERS moves on.
        let saved = once(&saved, ",1];", ",4];");
        let (message, back) = restored(&bench, &saved, 0);
        assert!(is_silent(&message) && back.contains(short), "{form}: {message}");
        let (message, _) = restored(&bench, &once(&saved, "sp:=[[[439,60,300]", "sp:=[[[439,60.01,300]"), 1);
        assert!(message.contains("sp was") && message.contains("by 0.0100 mm"), "{form}: {message}");
    }
}

/// `text` with all its numbers as a controller saves them: six significant digits, exponents of two digits with their sign.
fn saved_by_controller(text: &str) -> String {
    let is_comment = |line: &str| line.trim_start().starts_with('!');
    let in_digits = |word: &str| {
        // In single precision, as it holds them.
        let number = word.parse::<f32>().ok().filter(|_| word.starts_with(|c: char| c.is_ascii_digit()));
        let Some(number) = number.filter(|number| *number != 0.0) else { return word.to_owned() };
        let rounded: f64 = format!("{number:.5e}").parse().unwrap();
        match rounded {
            small if small < 1e-4 => format!("{small:.5e}").replace("e-", "E-0"),
            large if large >= 1e6 => format!("{large:e}").replace('e', "E+0"),
            plain => plain.to_string(),
        }
    };
    let line = |line: &str| {
        let (mut out, mut word) = (String::new(), String::new());
        for c in line.chars().chain(['\n']) {
            let exponent = c == '-' && word.ends_with('E') && word.starts_with(|c: char| c.is_ascii_digit());
            if c.is_ascii_alphanumeric() || c == '.' || c == '_' || exponent {
                word.push(c);
                continue;
            }
            out += &in_digits(&std::mem::take(&mut word));
            out.push(c);
        }
        out
    };
    text.lines().map(|of| if is_comment(of) { format!("{of}\n") } else { line(of) }).collect()
}

/// A controller writes all that it saves in six digits: arrays, corrections, functions and originals. A point that was touched up before
/// that is told by what the other elements say.
#[test]
fn a_module_that_a_controller_has_saved_is_what_it_was() {
    let bench = Bench::default();
    let source = module(
        "CONST robtarget p20:=[[430,60,300],@;\nCONST robtarget p30:=[[440.123,65,305.5],@;\nVAR num i:=1;",
        "MoveL p20,v100,fine,tGun;\nMoveL Offs(p30,0,0,20),v100,fine,tGun;\nMoveC p30,p20,v100,fine,tGun;\n\
         MoveL [[450,61,310],@,v100,fine,tGun;",
    );
    for form in ["schedule", "ramp", "live", "auto"] {
        let text = compensated(&bench, &source, form);
        let saved = saved_by_controller(&text);
        assert!(saved != text && !saved.contains("0.9961947"), "{form}");
        let (message, back) = restored(&bench, &saved, 0);
        assert!(is_silent(&message), "{form}: {message}");
        assert_eq!(back, saved_by_controller(&source), "{form}");
    }
    // The tenth of p20's elements by 2 mm in y.
    let saved = saved_by_controller(&compensated(&bench, &source, "schedule"));
    let begin = saved.find("tcp20{").unwrap();
    let element = begin + saved[begin..].match_indices("\n").nth(9).unwrap().0;
    let y = element + saved[element..].find(',').unwrap() + 1;
    let end = y + saved[y..].find(',').unwrap();
    let moved: f64 = saved[y..end].parse::<f64>().unwrap() + 2.0;
    let touched = format!("{}{moved:.4}{}", &saved[..y], &saved[end..]);
    let (message, back) = restored(&bench, &touched, 1);
    let by = message.split("touched up on the controller by ").nth(1).unwrap_or_else(|| panic!("{message}"));
    let by_mm: f64 = by.split(' ').next().unwrap().parse().unwrap();
    assert!((by_mm - 2.0).abs() < 0.003 && message.matches("touched up").count() == 1, "{message}");
    assert!(
        back.contains("p20:=[[430,62") || back.contains("p20:=[[430.00") || back.contains("p20:=[[429.99"),
        "{back}"
    );
}

/// Strings and comments name nothing.
#[test]
fn a_string_with_a_name_that_was_added_is_no_use_of_it() {
    let bench = Bench::default();
    let source = module("CONST robtarget p20:=[[430,60,300],@;", "MoveL p20,v100,fine,tGun;");
    let text = compensated(&bench, &source, "ramp");
    let line = "TPWrite \"at tcP20 \"\"tcAt\"\" ! tcK\"; ! \"tcMinute\nENDPROC\nENDMODULE";
    let written = |text: &str| text.replacen("ENDPROC", &line.replace("\nENDMODULE", ""), 1);
    let (message, back) = restored(&bench, &written(&text), 0);
    assert!(is_silent(&message) && back == written(&source), "{message}");
    let used = "TPWrite \"at\"\\Num:=tcP20.trans.x;\nENDPROC";
    let (message, _) = restored(&bench, &text.replacen("ENDPROC", used, 1), 2);
    assert!(message.contains("tcP20 is still named there"), "{message}");
}

#[test]
fn the_clocks_names_that_were_put_in_by_hand_are_told() {
    let bench = Bench::default();
    let motions = "MoveL p20,v100,fine,tGun;";
    let source = module("CONST robtarget p20:=[[430,60,300],@;", motions);
    let touched = |text: &str| once(text, "p20:=[[430,60,300]", "p20:=[[430,61,300]");
    for form in ["schedule", "ramp", "live"] {
        let text = compensated(&bench, &source, form);
        let put_in = |line: &str| text.replacen("ENDPROC", &format!("{line}\nENDPROC"), 1);
        // Nothing else has these names.
        let (message, _) = restored(&bench, &put_in("IF tcState=0 Stop;"), 2);
        assert!(
            message.contains("restore::damaged") && message.contains("tcState is still named"),
            "{message}"
        );
        let (message, back) = restored(&bench, &put_in("IF tcMinute>30 TPWrite \"warm\";"), 1);
        assert!(
            message.contains("warning[restore::named]") && message.contains("tcMinute"),
            "{form}: {message}"
        );
        assert!(back.contains("IF tcMinute>30"), "{form}");
        // A source may name what is called or shown, and then it is its own.
        let source = module("CONST robtarget p20:=[[430,60,300],@;", &format!("tcUpdate;\n{motions}"));
        let text = compensated(&bench, &source, form);
        let (message, _) = restored(&bench, &touched(&text).replace("p20,v100", "p20,v200"), 1);
        assert!(!message.contains("restore::named"), "{form}: {message}");
    }
}

/// Where several modules share a clock, the one that has it is known when it is given with them.
#[test]
fn names_of_the_common_module_that_were_put_in_by_hand_are_told() {
    let bench = Bench::default();
    let source = module("CONST robtarget p20:=[[430,60,300],@;", "MoveL p20,v100,fine,tGun;");
    std::fs::create_dir(bench.path("cell")).unwrap();
    bench.file("cell/a.mod", &source);
    let (from, to) = (bench.path("cell").display().to_string(), bench.path("cell_tc").display().to_string());
    let separate = ["--form", "ramp", "--core", "separate", "--diff", "none"];
    let made = driftpost(&[&["compensate", &from, "-o", &to][..], &separate].concat());
    assert_eq!(made.status.code(), Some(0), "{}", err(&made));
    let emitted = bench.text("cell_tc/a.mod");
    for (line, code, told) in [
        ("", 0, "byte for byte"),
        ("IF tcState{1}=0 Stop;", 2, "tcState is still named there"),
        ("IF tcMinute>30 Stop;", 1, "warning[restore::named]"),
    ] {
        bench.file(
            "cell_tc/a.mod",
            emitted.replacen("ENDPROC", &format!("{line}\nENDPROC"), 1).replace("\n\nENDPROC", "\nENDPROC"),
        );
        let back = bench.path(&format!("back{code}")).display().to_string();
        let output = driftpost(&["restore", &to, "-o", &back]);
        assert_eq!(output.status.code(), Some(code), "{}", err(&output));
        assert!(err(&output).contains(told), "{}", err(&output));
    }
}

/// A motion that asks with another's correction, or with one that is written out, is told by `restore` and by `diff`; as a controller may
/// write it, it is not.
#[test]
fn a_correction_that_was_exchanged_in_a_motion_is_told() {
    let bench = Bench::default();
    let source = module(
        "CONST robtarget p20:=[[430,60,300],@;\nCONST robtarget p30:=[[460,80,330],@;",
        "MoveL p20,v100,fine,tGun;\nMoveL p30,v100,fine,tGun;",
    );
    let original = bench.file("source.mod", &source);
    for form in ["ramp", "auto"] {
        let text = compensated(&bench, &source, form);
        for by in ["tcP30", "[[80,0,0],[1,0,0,0]]"] {
            let changed = once(&text, "tcAt(p20,tcP20)", &format!("tcAt(p20,{by})"));
            let line = 1 + text[..text.find("tcAt(p20").unwrap()].matches('\n').count();
            let (message, back) = restored(&bench, &changed, 1);
            assert!(
                message.contains("restore::arguments") && message.contains(&format!(":{line}:")),
                "{message}"
            );
            assert_eq!(back, source);
            let compared = driftpost(&["diff", &original, &bench.path("changed.mod").display().to_string()]);
            assert_eq!(compared.status.code(), Some(1), "{by}");
        }
        let (message, _) = restored(&bench, &once(&text, "tcAt(p20,tcP20)", "TCAT( p20 , tcp20 )"), 0);
        assert!(!message.contains("warning"), "{message}");
    }
}

#[test]
fn a_module_that_is_cut_off_is_not_restored() {
    let bench = Bench::default();
    let source = module("CONST robtarget p20:=[[430,60,300],@;", "MoveL p20,v100,fine,tGun;");
    for form in ["schedule", "ramp", "live"] {
        let text = compensated(&bench, &source, form);
        let (message, _) = restored(&bench, &once(&text, "\nENDMODULE", "\n"), 2);
        assert!(message.contains("restore::damaged") && message.contains("cut off"), "{form}: {message}");
    }
}

#[test]
fn a_compensated_program_before_its_original_is_told() {
    let bench = Bench::default();
    let source = module("CONST robtarget p20:=[[430,60,300],@;", "MoveL p20,v100,fine,tGun;");
    compensated(&bench, &source, "ramp");
    let [original, made] = ["a.mod", "o.mod"].map(|name| bench.path(name).display().to_string());
    assert!(!err(&driftpost(&["diff", &original, &made])).contains("diff::order"));
    assert!(err(&driftpost(&["diff", &made, &original])).contains("diff::order"));
}
