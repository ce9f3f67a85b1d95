//! What `restore` says of values that were changed by hand, exchanged, or written anew by a controller, and of names that were put in.

use super::{Bench, driftpost, err};

const REST: &str = "[0.0871557,0,0.9961947,0],[0,-1,0,0],[9E9,9E9,9E9,9E9,9E9,9E9]]";
const HOME: &str = "MoveAbsJ [[5,10,20,5,50,5],[9E9,9E9,9E9,9E9,9E9,9E9]],v500,fine,tGun;";

/// A module of data and motions; `@` stands for all of a robtarget behind its position.
fn module(data: &str, motions: &str) -> String {
    let text = format!(
        "MODULE A\nRECORD spot\nrobtarget at;\nrobtarget next;\nnum k;\nENDRECORD\n\
         PERS tooldata tGun:=[TRUE,[[0,0,120],[1,0,0,0]],[1,[0,0,50],[1,0,0,0],0,0,0]];\n\
         PERS num nPos:=1;\n{data}\nPROC main()\n{HOME}\n{motions}\nENDPROC\nENDMODULE\n"
    );
    text.replace('@', REST)
}

/// The module in a form, which gives it back byte for byte.
fn compensated(bench: &Bench, source: &str, form: &str) -> String {
    let (from, to) = (bench.file("a.mod", source), bench.path("o.mod").display().to_string());
    let made = driftpost(&["compensate", &from, "-o", &to, "--form", form, "--diff", "none", "--force"]);
    assert_eq!(made.status.code(), Some(0), "{form}: {}", err(&made));
    let text = bench.text("o.mod");
    let (message, back) = restored(bench, &text, 0);
    assert!(back == source && is_silent(&message), "{form}: {message}");
    text
}

/// What is said of a changed module, and the original that is got back; it ends with `code`.
fn restored(bench: &Bench, changed: &str, code: i32) -> (String, String) {
    let (from, to) = (bench.file("changed.mod", changed), bench.path("back.mod").display().to_string());
    let output = driftpost(&["restore", &from, "-o", &to]);
    assert_eq!(output.status.code(), Some(code), "{}\n{changed}", err(&output));
    (err(&output), if code == 2 { String::new() } else { bench.text("back.mod") })
}

fn is_silent(message: &str) -> bool {
    ["touched up", "changed where", "warning", "error"].iter().all(|word| !message.contains(word))
}

fn once(text: &str, from: &str, by: &str) -> String {
    assert_eq!(text.matches(from).count(), 1, "{from}");
    text.replace(from, by)
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
