#![no_main]
#[path = "../targets/robots.rs"]
mod target;

libfuzzer_sys::fuzz_target!(|data: &[u8]| target::robots(data));
