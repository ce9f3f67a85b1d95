#![no_main]
#[path = "../targets/execution.rs"]
mod target;

libfuzzer_sys::fuzz_target!(|data: &[u8]| target::execution(data));
