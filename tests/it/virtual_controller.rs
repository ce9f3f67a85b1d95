//! The virtual controller executes RAPID by the language's rules: expected values are worked out by hand.

mod endings;
mod limits;
mod lines;

use virtual_controller::{Controller, Outcome, Value};

fn controller(module: &str) -> Controller {
    let mut c = Controller::new();
    c.load("m.mod", module.as_bytes()).unwrap();
    c
}

fn ran(c: &mut Controller, routine: &str) {
    let outcome = c.call(routine, 1).unwrap();
    assert!(outcome.is_good(), "{routine}: {outcome:?}");
}

fn numbers(c: &mut Controller, name: &str) -> Vec<f64> {
    c.value(name).unwrap().numbers()
}

#[test]
fn numbers_are_single_precision_and_operators_bind_as_the_language_says() {
    let mut c = controller(
        r"MODULE M
  PERS num r{12}:=[0,0,0,0,0,0,0,0,0,0,0,0];
  VAR dnum d;
  VAR bool b;
  PROC main()
    VAR num a:=16777216;
    r{1}:=a+1;            ! 2^24 + 1 does not fit
    r{2}:=0.1;
    r{3}:=2+3*4-6/2;
    r{4}:=-7 DIV 2;
    r{5}:=-7 MOD 2;
    r{6}:=Round(2.71828\Dec:=1);
    r{7}:=Trunc(-3.99);
    r{8}:=Abs(-2)+Sqrt(16)+Pow(2,10)+Max(1,2)+Min(1,2);
    r{9}:=Sin(30)+Cos(60)+ATan2(1,1);
    r{10}:=1/3*3;
    d:=16777217;
    d:=d+1;
    b:=NOT FALSE AND 1>2 OR 5 MOD 0=1; ! NOT takes with it what AND joins
    r{11}:=7 MOD 4*2;
    r{12}:=Exp(1);
  ENDPROC
ENDMODULE",
    );
    ran(&mut c, "main");
    let r = numbers(&mut c, "r");
    assert_eq!(r[0], 16_777_216.0);
    assert_eq!(r[1], f64::from(0.1_f32));
    assert_eq!(r[2..8], [11.0, -3.0, -1.0, f64::from(2.7_f32), -3.0, 2.0 + 4.0 + 1024.0 + 2.0 + 1.0]);
    assert_eq!(r[8], f64::from(0.5_f32 + 0.5_f32 + 45.0));
    assert_eq!(r[9], f64::from(1.0_f32 / 3.0 * 3.0));
    assert_eq!(r[10..], [6.0, f64::from(std::f32::consts::E)]);
    assert_eq!(c.value("d").unwrap(), Value::Dnum(16_777_218.0));
    assert_eq!(c.value("b").unwrap(), Value::Bool(true));
}

#[test]
fn control_flow_goes_where_it_is_written() {
    let mut c = controller(
        r#"MODULE M
  VAR num n:=0;
  VAR num down{3};
  VAR string s:="";
  PROC main()
    VAR num i:=100;
    FOR i FROM 1 TO 10 DO
      IF i=3 GOTO out;
      n:=n+i;
    ENDFOR
  out:
    n:=n+i;                ! 1 + 2 + 100: the loop's variable hides the other one inside
    FOR k FROM 3 TO 1 DO
      down{4-k}:=k;
    ENDFOR
    FOR k FROM 1 TO 5 STEP 2 DO
      n:=n+k;              ! + 9
    ENDFOR
    WHILE n<120 DO
      Incr n;
    ENDWHILE
    TEST n
    CASE 1,2,119: s:="no";
    CASE 120: s:=s+"yes";
    DEFAULT: s:="default";
    ENDTEST
    IF n=1 THEN
      s:="wrong";
    ELSEIF n=120 THEN
      s:=s+"!";
    ELSE
      s:="wrong";
    ENDIF
    IF n<0 s:="wrong";
  again:
    n:=n-7;
    IF n>100 GOTO again;
    RETURN;
    n:=-1;
  ENDPROC
ENDMODULE"#,
    );
    ran(&mut c, "main");
    assert_eq!(c.number("n").unwrap(), 99.0);
    assert_eq!(numbers(&mut c, "down"), [3.0, 2.0, 1.0]);
    assert_eq!(c.value("s").unwrap(), Value::text("yes!"));
}

#[test]
fn parameters_of_every_mode_and_late_binding() {
    let mut c = controller(
        r#"MODULE M
  RECORD part
    num id;
    pos at;
  ENDRECORD
  ALIAS num level;
  PERS num kept:=5;
  VAR num out{4};
  VAR part p:=[7,[1,2,3]];
  VAR string which:="beta";
  FUNC num sum(num a{*},\switch twice,\num extra)
    VAR num total:=0;
    FOR i FROM 1 TO Dim(a,1) DO
      total:=total+a{i};
    ENDFOR
    IF Present(extra) total:=total+extra;
    IF Present(twice) RETURN 2*total;
    RETURN total;
  ENDFUNC
  FUNC num hand(num a{*},\switch twice,\num extra)
    RETURN sum(a\twice?twice\extra?extra);
  ENDFUNC
  PROC change(num copy,VAR num v,PERS num k,INOUT level io)
    copy:=99;
    v:=v+copy;
    k:=k*2;
    io:=io+1;
  ENDPROC
  PROC alpha()
    out{3}:=1;
  ENDPROC
  PROC beta()
    out{3}:=2;
  ENDPROC
  PROC main()
    VAR num mine:=1;
    VAR num v{3}:=[1,2,3];
    change mine,out{1},kept,p.at.y;
    out{2}:=mine;
    %which%;
    out{4}:=hand(v\twice,\extra:=4)+hand(v)*100;
    IF p.at=[1,3,3] p.id:=8;
  ENDPROC
ENDMODULE"#,
    );
    ran(&mut c, "main");
    assert_eq!(numbers(&mut c, "out"), [99.0, 1.0, 2.0, 620.0]);
    assert_eq!(c.number("kept").unwrap(), 10.0);
    assert_eq!(numbers(&mut c, "p"), [8.0, 1.0, 3.0, 3.0]);
}

#[test]
fn errors_go_to_handlers_and_on_from_there() {
    let mut c = controller(
        r#"MODULE M
  VAR num zero:=0;
  VAR num log{6};
  VAR errnum ERR_MINE:=-1;
  FUNC num quotient(num a,num b)
    RETURN a/b;
  ERROR (ERR_DIVZERO)
    log{1}:=log{1}+1;
    RETURN -1;
  ENDFUNC
  PROC deep()
    RAISE ERR_MINE;
  ENDPROC
  PROC passes_on()
    deep;
    log{6}:=1;
  ERROR
    log{2}:=log{2}+1;
    RAISE;
  ENDPROC
  PROC main()
    VAR num d:=0;
    BookErrNo ERR_MINE;
    log{3}:=quotient(4,zero)+quotient(4,2);
    log{4}:=8/d;
    log{5}:=1/zero;
    passes_on;
  ERROR
    IF ERRNO=ERR_DIVZERO THEN
      IF d=0 THEN
        d:=2;
        RETRY;
      ENDIF
      TRYNEXT;
    ELSEIF ERRNO=ERR_MINE THEN
      log{2}:=log{2}+10;
      TRYNEXT;
    ENDIF
  ENDPROC
  PROC unhandled()
    log{1}:=1/zero;
  ENDPROC
ENDMODULE"#,
    );
    ran(&mut c, "main");
    assert_eq!(numbers(&mut c, "log"), [1.0, 11.0, 1.0, 4.0, 0.0, 0.0]);
    match c.call("unhandled", 1).unwrap() {
        Outcome::Failed { error, at, .. } => assert_eq!((error, at.line), (Some("err_divzero"), 41)),
        other => panic!("{other:?}"),
    }
}

#[test]
fn scopes_and_what_survives_pp_to_main() {
    let mut c = controller(
        "MODULE A\nLOCAL VAR num x:=1;\nPERS num kept:=1;\nVAR num seen;\n\
         PROC main()\nx:=x+1;\nkept:=kept+x;\nseen:=other();\nENDPROC\nENDMODULE",
    );
    c.load(
        "b.mod",
        b"MODULE B\nLOCAL CONST num x:=50;\nFUNC num other()\nRETURN x+kept;\nENDFUNC\nENDMODULE",
    )
    .unwrap();
    ran(&mut c, "main");
    ran(&mut c, "main");
    assert_eq!((c.number("kept").unwrap(), c.number("seen").unwrap()), (1.0 + 2.0 + 3.0, 56.0));
    let backup = c.backup();
    c.pp_to_main();
    assert_eq!(c.number("seen").unwrap(), 0.0);
    ran(&mut c, "main");
    assert_eq!(c.number("kept").unwrap(), 6.0 + 2.0);
    c.restore(&backup);
    assert_eq!(c.number("kept").unwrap(), 6.0);
    assert!(c.load("c.mod", b"MODULE C\nVAR num kept;\nENDMODULE").is_err(), "a global name twice");
}

#[test]
fn strings_and_conversions() {
    let mut c = controller(
        r#"MODULE M
  VAR string s{6};
  VAR num n{6};
  VAR bool ok{3};
  VAR pos at;
  PROC main()
    s{1}:=StrPart("2026-11-21",6,2);
    ok{1}:=StrToVal(s{1},n{1});
    ok{2}:=StrToVal("[1,2.5,-3]",at);
    ok{3}:=StrToVal("1x",n{2});
    n{3}:=StrLen("abc")+StrFind("robot 7",1,STR_DIGIT)*10+StrMatch("myTick",1,"Tick")*100;
    s{2}:=NumToStr(0.38521,3)+"/"+ValToStr(at);
    s{3}:=StrMap("abc","ab","AB");
    s{4}:="a ""quoted"" word";
    IF StrOrder("FIRST","SECOND",STR_UPPER) s{5}:="ordered";
  ENDPROC
ENDMODULE"#,
    );
    ran(&mut c, "main");
    assert_eq!(numbers(&mut c, "n")[..3], [11.0, 0.0, 3.0 + 70.0 + 300.0]);
    assert_eq!(numbers(&mut c, "at"), [1.0, 2.5, -3.0]);
    let texts: Vec<Value> = c.value("s").unwrap().parts().to_vec();
    let expected = ["11", "0.385/[1,2.5,-3]", "ABc", "a \"quoted\" word", "ordered", ""];
    assert_eq!(texts, expected.map(Value::text));
    assert_eq!(c.value("ok").unwrap().parts(), [true, true, false].map(Value::Bool));
}

#[test]
fn time_passes_by_waits_and_timers_interrupt() {
    let mut c = controller(
        r#"MODULE M
  VAR clock watch;
  VAR intnum timer;
  PERS num ticks:=0;
  PERS num seconds:=0;
  PERS string day:="";
  TRAP tick
    ticks:=ticks+1;
  ENDTRAP
  PROC main()
    CONNECT timer WITH tick;
    ITimer 10,timer;
    ClkReset watch;
    ClkStart watch;
    FOR i FROM 1 TO 7 DO
      WaitTime 5;
    ENDFOR
    ClkStop watch;
    IDelete timer;
    WaitTime 100;
    seconds:=ClkRead(watch);
    day:=CDate()+" "+CTime()+" "+NumToStr(GetTime(\WDay),0);
  ENDPROC
ENDMODULE"#,
    );
    c.calendar_mut().set((2026, 12, 31), (23, 58, 30.0));
    ran(&mut c, "main");
    assert_eq!((c.number("ticks").unwrap(), c.number("seconds").unwrap()), (3.0, 35.0));
    assert_eq!(c.value("day").unwrap(), Value::text("2027-01-01 00:00:45 5"));
}

/// A module that comes and goes belongs to the program: no more motions are executed than it has.
#[test]
fn motions_of_modules_that_come_and_go_are_counted_once() {
    let mut c = controller(
        r#"MODULE M
  PROC main()
    MoveAbsJ [[0,0,0,0,30,0],[9E9,9E9,9E9,9E9,9E9,9E9]],v100,fine,tool0;
    FOR i FROM 1 TO 3 DO
      Load \Dynamic,"HOME:/PART.MOD";
      %"part"%;
      UnLoad "HOME:/PART.MOD";
    ENDFOR
  ENDPROC
ENDMODULE"#,
    );
    let to = "MoveAbsJ [[0,0,0,0,40,0],[9E9,9E9,9E9,9E9,9E9,9E9]],v100,fine,tool0;\n";
    c.put_file("PART.MOD", format!("MODULE PART\nPROC part()\n{to}{to}ENDPROC\nENDMODULE").as_bytes());
    assert_eq!(c.motion_count_except(&[]), 1);
    assert!(c.call("main", 1).unwrap().is_good());
    assert_eq!((c.motion_count_except(&[]), c.motion_count_except(&["PART"])), (3, 1));
}

#[test]
fn modules_are_loaded_and_vanish() {
    let mut c = controller(
        r#"MODULE M
  PERS num log{5}:=[0,0,0,0,0];
  VAR loadsession session;
  PROC main()
    Load \Dynamic,"HOME:/PART1.MOD";
    %"part"%;
    UnLoad "HOME:/PART1.MOD";
    StartLoad \Dynamic,"HOME:"\File:="PART2.MOD",session;
    WaitLoad session;
    %"part"%;
    Load \Dynamic,"HOME:/MISSING.MOD";
    Load \Dynamic,"HOME:/PART2.MOD";
    UnLoad "HOME:/PART1.MOD";
    log{5}:=1;
  ERROR
    IF ERRNO=ERR_FILNOTFND log{3}:=log{3}+1;
    IF ERRNO=ERR_LOADED log{3}:=log{3}+10;
    IF ERRNO=ERR_UNLOAD log{3}:=log{3}+100;
    TRYNEXT;
  ENDPROC
  PROC late()
    %"part"%;
  ERROR
    IF ERRNO=ERR_REFUNKPRC log{4}:=1;
    TRYNEXT;
  ENDPROC
ENDMODULE"#,
    );
    for n in 1..=2 {
        let text = format!("MODULE PART{n}\nPROC part()\nlog{{{n}}}:={n};\nENDPROC\nENDMODULE");
        c.put_file(&format!("PART{n}.MOD"), text.as_bytes());
    }
    ran(&mut c, "main");
    c.pp_to_main();
    ran(&mut c, "late");
    assert_eq!(numbers(&mut c, "log"), [1.0, 2.0, 111.0, 1.0, 1.0]);
}

#[test]
fn signals_are_waited_for_and_their_units_may_fail() {
    let mut c = controller(
        "MODULE M\nPERS num log:=0;\nVAR bool late;\nPROC main()\nWaitDI diOpen,1;\nlog:=log+1;\n\
         WaitDI diShut,1\\MaxTime:=2\\TimeFlag:=late;\nIF late log:=log+10;\nWaitDI diShut,1\\MaxTime:=2;\nlog:=log+5;\n\
         log:=log+AInput(aiTemp);\nlog:=log+1000;\nERROR\nIF ERRNO=ERR_WAIT_MAXTIME log:=log+100;\n\
         IF ERRNO=ERR_NORUNUNIT log:=log+10000;\nTRYNEXT;\nENDPROC\nENDMODULE",
    );
    c.set_signal("diShut", 0.0);
    c.set_unit_down("aiTemp", true);
    ran(&mut c, "main");
    assert_eq!(c.number("log").unwrap(), 1.0 + 10.0 + 100.0 + 5.0 + 10_000.0 + 1_000.0);
    assert_eq!(c.calendar().steady_s(), 4.0);
}

#[test]
fn what_is_not_known_is_listed_and_passed_over() {
    let mut c = controller(
        "MODULE M\nVAR num n:=0;\nPROC main()\nWeirdThing 1,2\\x;\nIF DI_1=1 n:=1;\nn:=n+Oracle(3);\nn:=n+5;\n\
         SetDO doGrip,1;\nTPWrite \"n \"\\Num:=n;\nENDPROC\nENDMODULE",
    );
    ran(&mut c, "main");
    assert_eq!(c.unknown_instructions(), ["Oracle", "WeirdThing"]);
    assert_eq!((c.number("n").unwrap(), c.signal("dogrip")), (5.0, Some(1.0)));
    assert_eq!(c.take_messages().iter().find(|m| m.source == "TPWrite").unwrap().text, "n 5");
}

#[test]
fn displacements_show_in_the_system_data_and_move_what_is_asked() {
    let text = r"MODULE M
  CONST robtarget p:=[[500,10,700],[0.70710678,0,0.70710678,0],[0,0,0,0],[9E9,9E9,9E9,9E9,9E9,9E9]];
  VAR progdisp d;
  VAR robtarget here;
  PROC stand()
    MoveAbsJ [[0,0,0,0,0,0],[9E9,9E9,9E9,9E9,9E9,9E9]],v100,fine,tool0;
  ENDPROC
  PROC on()
    stand;
    PDispOn p,tool0;
    EOffsSet [1,2,3,4,5,6];
    show;
  ENDPROC
  PROC given()
    PDispOn\Rot\ExeP:=[[500,10,710],[0.5,0.5,0.5,0.5],[0,0,0,0],[9E9,9E9,9E9,9E9,9E9,9E9]],p,tool0\WObj:=wobj0;
    show;
  ENDPROC
  PROC off()
    PDispOff;
    EOffsOff;
    show;
  ENDPROC
  PROC show()
    d:=C_PROGDISP;
    d.eoffs.eax_f:=C_PROGDISP.eoffs.eax_f+C_PROGDISP.pdisp.trans.x;
    here:=CRobT(\Tool:=tool0);
  ENDPROC
ENDMODULE";
    let robot = robot_model::robot::Robot::built_in("irb140").unwrap();
    let mut c = Controller::with_robot(&robot).unwrap();
    c.load("m.mod", text.as_bytes()).unwrap();
    let near = |is: &[f64], expected: &[f64]| {
        assert!(is.iter().zip(expected).all(|(a, b)| (a - b).abs() < 1e-4), "{is:?}, not {expected:?}");
    };
    // The flange of the arm at rest stands at 515, 0, 712.
    ran(&mut c, "on");
    near(&numbers(&mut c, "d"), &[15.0, -10.0, 12.0, 1.0, 0.0, 0.0, 0.0, 1.0, 2.0, 3.0, 4.0, 5.0, 21.0]);
    near(&numbers(&mut c, "here")[..3], &[500.0, 10.0, 700.0]);
    // A turn of the target's y axis by 90 degrees to a turn by 120 about the diagonal: 90 degrees about the base's x.
    ran(&mut c, "given");
    let half = 0.5_f64.sqrt();
    near(&numbers(&mut c, "d")[3..7], &[half, half, 0.0, 0.0]);
    // That turn takes the point 500, 10, 700 to 500, -700, 10.
    near(&numbers(&mut c, "d")[..3], &[0.0, 710.0, 700.0]);
    ran(&mut c, "off");
    let none = [0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0];
    assert_eq!(numbers(&mut c, "d"), none);
    ran(&mut c, "on");
    c.pp_to_main();
    ran(&mut c, "show");
    assert_eq!(numbers(&mut c, "d"), none);
}

#[test]
fn the_controllers_own_tool_is_handed_on_as_pers() {
    let mut c = controller(
        r"MODULE M
  VAR num mass;
  VAR bool held;
  PROC main()
    mass:=massOf(tool0\WObj:=wobj0);
  ENDPROC
  FUNC num massOf(PERS tooldata tool\PERS wobjdata WObj)
    RETURN further(tool\WObj?WObj);
  ENDFUNC
  FUNC num further(PERS tooldata tool\PERS wobjdata WObj)
    held:=Present(WObj) AND tool.robhold AND NOT WObj.robhold;
    RETURN tool.tload.mass;
  ENDFUNC
ENDMODULE",
    );
    ran(&mut c, "main");
    assert_eq!(c.number("mass").unwrap(), f64::from(0.001_f32));
    assert_eq!(c.value("held").unwrap(), Value::Bool(true));
}
