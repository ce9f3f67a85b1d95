#![no_main]
#[path = "../targets/tables.rs"]
mod target;

libfuzzer_sys::fuzz_target!(|data: &[u8]| target::tables(data));
