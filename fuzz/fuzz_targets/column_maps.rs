#![no_main]
#[path = "../targets/column_maps.rs"]
mod target;

libfuzzer_sys::fuzz_target!(|data: &[u8]| target::column_maps(data));
