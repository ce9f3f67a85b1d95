#![no_main]
#[path = "../targets/scenarios.rs"]
mod target;

libfuzzer_sys::fuzz_target!(|data: &[u8]| target::scenarios(data));
