#![no_main]
#[path = "../targets.rs"]
mod targets;
#[path = "../../tests/it/tree_check.rs"]
mod tree_check;

libfuzzer_sys::fuzz_target!(|data: &[u8]| targets::page(data));
