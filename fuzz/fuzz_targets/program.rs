#![no_main]
#[path = "../targets/program.rs"]
mod target;
#[path = "../../tests/it/tree_check.rs"]
mod tree_check;

libfuzzer_sys::fuzz_target!(|data: &[u8]| target::program(data));
