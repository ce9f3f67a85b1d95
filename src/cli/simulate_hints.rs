//! What helps where `simulate` is asked for a name that is not there: a routine, data, a signal, a step of a scenario.

use super::suggest;
use driftpost::application::{DeclaredNames, ProgramFiles, SimulationError};
use rapid_syntax::diagnostic::Diagnostic;
use virtual_controller::SimulateError;
use virtual_controller::scenario::STEPS;

/// So many names are listed; more are no help.
const MOST_LISTED: usize = 8;

/// An error with what is to be done about it; a name that is near to one that is not there comes first.
///
/// `has_scenario`: what is set may come from a scenario.
pub fn diagnostic_of(error: &SimulationError, program: &ProgramFiles, has_scenario: bool) -> Diagnostic {
    let message = Diagnostic::from(error.clone());
    match error {
        SimulationError::Program(_) => message,
        SimulationError::NotMentioned { name, .. } => {
            let words = program.words();
            message.help(match suggest::nearest(name, words.iter().map(String::as_str)) {
                Some(near) => did_you_mean(near),
                None => "give the name of data or of a signal as the program has it".to_owned(),
            })
        }
        SimulationError::Controller(error) => {
            let general = match error {
                SimulateError::Value { .. } | SimulateError::NoData(_) if !has_scenario => {
                    "correct what --set gives, or give all files of the program"
                }
                _ => of_kind(error),
            };
            message.help(of_name(error, &program.names()).unwrap_or_else(|| general.to_owned()))
        }
    }
}

/// A scenario's error with what is to be done about it.
pub fn of_scenario(error: &SimulateError) -> Diagnostic {
    let text = error.to_string();
    let help = of_step(&text).unwrap_or_else(|| of_kind(error).to_owned());
    Diagnostic::error(error.code(), text).help(help)
}

/// The name that is nearest to one that is not there, or the routines that are.
fn of_name(error: &SimulateError, names: &DeclaredNames) -> Option<String> {
    let (wanted, known) = match error {
        SimulateError::NoRoutine(name) => (name, &names.routines),
        SimulateError::NoData(name) => (name, &names.data),
        _ => return None,
    };
    let near = suggest::nearest(wanted, known.iter().map(String::as_str)).map(did_you_mean);
    let few = || {
        let few = matches!(error, SimulateError::NoRoutine(_)) && (1..=MOST_LISTED).contains(&known.len());
        few.then(|| format!("the routines are {}", known.join(", ")))
    };
    near.or_else(few)
}

/// The step or the key that is nearest to one that no scenario has, by the message that quotes it.
fn of_step(message: &str) -> Option<String> {
    if message.contains("missing field `steps`") {
        return Some(
            "say what happens to the cell: steps = [\"call tcColdStart\", \"run 60\", \"stand 45\"]"
                .to_owned(),
        );
    }
    let mut quoted = message.split('`').skip(1).step_by(2);
    let step = quoted.next()?;
    let word = step.split_whitespace().next()?;
    let near = match message.contains("unknown field") {
        true => suggest::nearest(word, quoted),
        false => suggest::nearest(word, STEPS),
    };
    match near {
        Some(near) if near == word => None,
        Some(near) => Some(did_you_mean(near)),
        None if step == word => Some(format!("a routine is called by `call {word}`")),
        None => None,
    }
}

fn did_you_mean(near: &str) -> String {
    format!("did you mean {near}?")
}

/// What is generally to be done about an error.
fn of_kind(error: &SimulateError) -> &'static str {
    match error {
        SimulateError::NoEntry(_) | SimulateError::NoRoutine(_) => "name the routine with --entry",
        SimulateError::Load { .. } => "give each module once; a controller would not load this either",
        SimulateError::Scenario(_) | SimulateError::Value { .. } | SimulateError::NoData(_) => {
            "correct the scenario, or give all files of the program"
        }
        SimulateError::Endless { .. } | SimulateError::Idle(_) => {
            "say with --set NAME=VALUE what comes from outside"
        }
        SimulateError::OverLimit { .. } => "simulate a part of the program with --entry, or fewer --passes",
        SimulateError::Arm(_) => "use another robot",
    }
}
