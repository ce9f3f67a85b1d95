//! A bounded run of what is fuzzed (`fuzz/targets`), on bytes made from the fixtures.

use crate::targets;
use rand::seq::IndexedRandom;
use rand::{RngExt, SeedableRng};
use rand_chacha::ChaCha8Rng;
use std::fs;
use std::path::{Path, PathBuf};

/// Files of the fixtures that end in one of `endings`, none larger than `most` bytes.
fn seeds(endings: &[&str], most: u64) -> Vec<Vec<u8>> {
    fn walk(folder: &Path, found: &mut Vec<PathBuf>) {
        let mut entries: Vec<PathBuf> = fs::read_dir(folder).unwrap().map(|e| e.unwrap().path()).collect();
        entries.sort();
        for path in entries {
            if path.is_dir() { walk(&path, found) } else { found.push(path) }
        }
    }
    let mut found = Vec::new();
    walk(&Path::new(env!("CARGO_MANIFEST_DIR")).join("fixtures"), &mut found);
    let wanted = |path: &PathBuf| {
        let ending = path.extension().unwrap_or_default().to_string_lossy().to_lowercase();
        endings.contains(&ending.as_str()) && fs::metadata(path).unwrap().len() <= most
    };
    let seeds: Vec<Vec<u8>> = found.into_iter().filter(wanted).map(|path| fs::read(path).unwrap()).collect();
    assert!(seeds.len() > 8, "{} seeds", seeds.len());
    seeds
}

/// Pieces that mean something to a reader of RAPID, CSV, TOML, JSON or HTML.
const PIECES: [&[u8]; 28] = [
    b"(",
    b")",
    b"[",
    b"]",
    b"{",
    b"}",
    b";",
    b",",
    b"\"",
    b"\\",
    b"!",
    b":=",
    b"\n",
    b"\r\n",
    b"\0",
    b"\xFF",
    b"9E9",
    b"-1",
    b"1E400",
    b"nan",
    b"MoveL ",
    b"ENDPROC",
    b"PROC tcK()",
    b"</script>",
    b"<!--",
    b"%%%",
    b"&#x27;",
    b"=",
];

/// A seed with a few bytes changed, pieces put in, parts taken out, doubled, or taken from another seed.
fn mutated(seeds: &[Vec<u8>], random: &mut ChaCha8Rng) -> Vec<u8> {
    let mut bytes = seeds.choose(random).unwrap().clone();
    for _ in 0..random.random_range(1..6) {
        if bytes.is_empty() {
            break;
        }
        let at = random.random_range(0..bytes.len());
        let to = (at + random.random_range(1..60)).min(bytes.len());
        match random.random_range(0..6) {
            0 => bytes[at] = random.random(),
            1 => drop(bytes.splice(at..at, PIECES.choose(random).unwrap().iter().copied())),
            2 => drop(bytes.drain(at..to)),
            3 => {
                let part = bytes[at..to].to_vec();
                drop(bytes.splice(at..at, part));
            }
            4 => bytes.truncate(at),
            _ => {
                let other = seeds.choose(random).unwrap();
                let from = random.random_range(0..other.len().max(1));
                let part: Vec<u8> = other[from..].iter().take(200).copied().collect();
                drop(bytes.splice(at..at, part));
            }
        }
    }
    bytes
}

/// So many times as many executions, where the environment asks for them: `FUZZ_TIMES=100 cargo test --test it fuzzed::any_list`.
fn times() -> usize {
    std::env::var("FUZZ_TIMES").ok().and_then(|times| times.parse().ok()).unwrap_or(1)
}

/// `count` executions of a target; what breaks it is said with its bytes.
fn run(target: fn(&[u8]), seeds: &[Vec<u8>], count: usize, prefix: bool) {
    let mut random = ChaCha8Rng::seed_from_u64(20_261_122);
    for execution in 0..count * times() {
        let mut bytes = mutated(seeds, &mut random);
        if prefix {
            bytes.insert(0, random.random());
        }
        let caught = std::panic::catch_unwind(|| target(&bytes));
        assert!(caught.is_ok(), "execution {execution}: {:?}", String::from_utf8_lossy(&bytes));
    }
}

const RAPID: [&str; 3] = ["mod", "sys", "prg"];

#[test]
fn any_text_is_read() {
    run(targets::text::text, &seeds(&RAPID, 30_000), 1500, false);
}

#[test]
fn any_program_is_compensated_and_restored_or_refused() {
    run(targets::program::program, &seeds(&RAPID, 6000), 150, true);
}

#[test]
fn any_program_is_executed_or_refused() {
    run(targets::execution::execution, &seeds(&RAPID, 6000), 150, false);
}

#[test]
fn any_table_is_read_or_refused() {
    run(targets::tables::tables, &seeds(&["csv", "toml"], 6000), 2000, false);
}

#[test]
fn no_text_breaks_out_of_a_page() {
    run(targets::page::page, &seeds(&["mod", "csv"], 6000), 60, false);
}

#[test]
fn any_result_makes_a_page_or_is_refused() {
    run(targets::json::json, &seeds(&["json"], 6000), 300, false);
}

#[test]
fn any_description_of_a_robot_is_read_or_refused() {
    run(targets::robots::robots, &seeds(&["urdf", "toml", "csv"], 8000), 1500, false);
}

/// Each column map with each table, a zero byte between them.
#[test]
fn any_file_under_any_column_map_is_read_or_refused() {
    let [maps, tables] = [&["toml"][..], &["csv", "txt"]].map(|endings| {
        let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("fixtures/measuring");
        let mut paths: Vec<PathBuf> = fs::read_dir(folder).unwrap().map(|e| e.unwrap().path()).collect();
        paths.sort();
        paths.retain(|path| path.extension().is_some_and(|e| endings.contains(&&*e.to_string_lossy())));
        paths.into_iter().map(|path| fs::read(path).unwrap()).collect::<Vec<_>>()
    });
    let both = |map: &[u8], table: &[u8]| [map, b"\0", &table[..table.len().min(3000)]].concat();
    let pairs: Vec<Vec<u8>> =
        maps.iter().flat_map(|map| tables.iter().map(|table| both(map, table)).collect::<Vec<_>>()).collect();
    assert!(pairs.len() > 8);
    run(targets::column_maps::column_maps, &pairs, 1500, false);
}

#[test]
fn any_scenario_is_read_or_refused() {
    run(targets::scenarios::scenarios, &seeds(&["toml"], 6000), 3000, false);
}

#[test]
fn any_list_of_targets_or_joints_is_read_or_refused() {
    run(targets::lists::lists, &seeds(&["csv"], 6000), 2000, false);
}

/// Those that take seconds: `cargo test --test it -- --ignored long::`.
mod long {
    use super::*;

    #[cfg(feature = "cli")]
    #[test]
    #[ignore = "long"]
    fn any_file_of_settings_is_taken_or_refused() {
        run(targets::settings::settings, &seeds(&["toml"], 6000), 300, false);
    }
}
