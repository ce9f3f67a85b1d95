#![no_main]
#[path = "../targets/lists.rs"]
mod target;

libfuzzer_sys::fuzz_target!(|data: &[u8]| target::lists(data));
