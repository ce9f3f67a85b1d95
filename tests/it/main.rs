//! The tests of the whole: one binary, one module for each thing that is promised.

#![allow(
    clippy::unwrap_used,
    clippy::print_stdout,
    reason = "a test stops where something is missing, and its figures are there to be read"
)]
#![allow(unreachable_pub, reason = "modules of a binary share their helpers")]

mod accuracy;
mod architecture;
mod arms;
mod bad_cells;
mod bad_columns;
mod bad_measurements;
mod bad_orientations;
mod branch_end;
mod calibration;
mod campaigns;
mod cli;
mod clock;
mod compensate_robodk;
mod controller;
mod corpus;
mod corpus_table;
mod deformed_inverse;
mod detection_limits;
mod diagnose;
mod docs_commands;
mod emit;
mod exam_page;
mod executed;
mod false_faults;
mod faults;
mod fit;
mod folders;
mod forms;
mod function_lengths;
mod fuzzed;
mod golden;
mod grammar;
mod growth;
mod hostile;
mod kinematics;
mod limits;
#[cfg(feature = "link")]
mod link;
mod live;
mod loads;
mod lossless;
mod measuring;
mod messages;
mod mixed_up_rows;
mod model;
mod next_poses;
mod nominal_cell;
mod oracle;
mod oracle_of_two;
mod outside_the_arm;
mod paper;
mod plan;
mod play;
mod program;
mod real;
mod real_cell;
mod recipe;
mod shop;
mod simulate;
mod slow_noise;
mod small_background;
#[cfg(target_os = "linux")]
mod sound_file;
mod springs;
mod stepped;
mod tabulate;
#[path = "../../fuzz/targets/mod.rs"]
mod targets;
mod touch;
mod traps;
mod tree_check;
mod unusual;
mod virtual_controller;
mod warm_up_laws;
