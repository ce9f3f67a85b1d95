//! What a program's tree takes of memory, counted by the allocator: programs of a million moves are held whole.

#![allow(unsafe_code, reason = "a global allocator is unsafe to implement; this one counts and hands on")]
#![allow(clippy::unwrap_used)]

use rapid_syntax::parse;
use std::alloc::{GlobalAlloc, Layout, System};
use std::cell::Cell;
use std::fmt::Write as _;

struct Counting;

thread_local! {
    /// Bytes that this thread has asked for and not given back.
    static LIVE: Cell<isize> = const { Cell::new(0) };
}

fn count(bytes: isize) {
    // `try_with`: a thread that ends frees after its counter is gone.
    let _ = LIVE.try_with(|live| live.set(live.get() + bytes));
}

// SAFETY: every call is handed on to the system's allocator unchanged.
unsafe impl GlobalAlloc for Counting {
    unsafe fn alloc(&self, layout: Layout) -> *mut u8 {
        count(layout.size() as isize);
        // SAFETY: the caller keeps to the contract of `alloc`.
        unsafe { System.alloc(layout) }
    }

    unsafe fn dealloc(&self, pointer: *mut u8, layout: Layout) {
        count(-(layout.size() as isize));
        // SAFETY: the caller keeps to the contract of `dealloc`.
        unsafe { System.dealloc(pointer, layout) }
    }
}

#[global_allocator]
static ALLOCATOR: Counting = Counting;

/// Bytes of heap that the tree of `moves` lines takes, divided by their number.
fn bytes_per_move(line: impl Fn(u32) -> String) -> f64 {
    const MOVES: u32 = 20_000;
    let mut text = String::from("MODULE m\n  PROC main()\n");
    for n in 0..MOVES {
        writeln!(text, "    {}", line(n)).unwrap();
    }
    text.push_str("  ENDPROC\nENDMODULE\n");
    let before = LIVE.get();
    let (tree, warnings) = parse(text.as_bytes());
    let taken = LIVE.get() - before;
    assert_eq!(warnings, []);
    let rapid_syntax::tree::FileItem::Module(module) = &tree.items[0] else { panic!("no module") };
    assert_eq!(module.routines().map(|r| r.body.len()).sum::<usize>(), MOVES as usize);
    taken as f64 / f64::from(MOVES)
}

#[test]
fn a_move_with_an_inline_target_takes_at_most_320_bytes() {
    let taken = bytes_per_move(|n| {
        format!(
            "MoveL [[-{n}.7,2.2,15.4],[0,0,1,0],[-1,0,-1,0],[9E+09,9E+09,9E+09,9E+09,9E+09,9E+09]],\
             v100,z1,tool\\WObj:=wobj;"
        )
    });
    assert!(taken <= 320.0, "{taken} bytes");
    assert!(taken > 32.0, "{taken} bytes: the allocator does not count");
}

#[test]
fn a_move_to_a_named_target_takes_no_more() {
    let taken = bytes_per_move(|n| format!("MoveL p{n},v100,z5,tool\\WObj:=wobj;"));
    assert!(taken <= 320.0, "{taken} bytes");
}
