//! Routines that call each other in circles, as where each ends in a call whose name is worked out.

use super::{at, codes, module, tool, tools_mm};
use std::fmt::Write as _;

/// So many routines, each of which may call every one of them at its end; `sets`: what stands before the call in one of them.
fn jobs(count: usize, sets: &str) -> String {
    let mut text = format!(
        "PERS tooldata t:={};\nPERS tooldata tB:={};\nCONST robtarget p:={};\nVAR num n;\n",
        tool(1),
        tool(2),
        at(5, 5, 5)
    );
    for job in 0..count {
        let own = if job == 1 { sets } else { "" };
        let _ = write!(
            text,
            "PROC j{job}()\nMoveL p,v100,fine,t;\n{own}n:=GInput(g1);\n%\"j\"+NumToStr(n,0)%;\nENDPROC\n"
        );
    }
    text + "PROC main()\n%\"j\"+NumToStr(n,0)%;\nMoveL p,v100,fine,t;\nENDPROC\n"
}

/// Each of sixty calls each: walked anew for every path, it does not end in a lifetime.
#[test]
fn sixty_routines_that_may_all_call_each_other_are_read() {
    let read = module(&jobs(60, ""));
    assert_eq!((codes(&read), tools_mm(&read)), (vec!["-"; 61], vec![Some(1); 61]));
}

/// What one of them sets, holds in each that is called behind it, and behind it may be any.
#[test]
fn what_one_of_a_circle_sets_counts_in_all_of_it() {
    for count in [2, 3, 7, 40] {
        let read = module(&jobs(count, "t:=tB;\n"));
        assert_eq!(tools_mm(&read), vec![None; count + 1], "{count}");
        let same = module(&jobs(count, "PDispSet [[0,0,1],[1,0,0,0]];\n"));
        assert_eq!(codes(&same), vec!["keep::displacement"; count + 1], "{count}");
        // It is set back before another is called: only the motions behind PDispOff see none of it.
        let back = module(&jobs(count, "PDispSet [[0,0,1],[1,0,0,0]];\nMoveL p,v100,fine,t;\nPDispOff;\n"));
        let kept = codes(&back).into_iter().enumerate().filter(|(_, code)| *code == "keep::displacement");
        assert_eq!(kept.map(|(at, _)| at).collect::<Vec<_>>(), [2], "{count}");
    }
}
