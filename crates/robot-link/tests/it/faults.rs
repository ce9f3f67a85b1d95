//! A thousand sequences of random faults: no right is held afterwards, no half file accepted, nothing called done that is not.

use crate::bench::{MODULE, double, hasty, open_with};
use rand::{Rng, RngExt, SeedableRng};
use rand_chacha::ChaCha8Rng;
use robot_link::LinkError;
use rws_double::{Double, Fault, Holder, Operator, Personality};

const SEQUENCES: u64 = 1000;
/// Sequences at one time.
const LINES: u64 = 16;
/// Requests of a sequence that may meet a fault; later ones end it in peace, as a line does that comes back.
const FAULTY: usize = 24;

fn fault(random: &mut impl Rng) -> Fault {
    match random.random_range(0..18) {
        0 => Fault::Unavailable,
        1 => Fault::DropBefore,
        2 => Fault::DropAfter,
        3 => Fault::CutBody,
        4 => Fault::Stall(120),
        5 => Fault::Delay(5),
        6 => Fault::Delay(120),
        7 => Fault::WrongCookies,
        8 => Fault::SessionLost,
        9 => Fault::ErrorInside,
        10 => Fault::BrokenText,
        11 => Fault::HalfFile,
        12 => Fault::WrongType,
        13 => Fault::ModeTurned(["AUTO", "MANR", "AUTO_CH"][random.random_range(0..3)]),
        14 => Fault::PendantTakes,
        15 => Fault::Started,
        16 => Fault::Restart,
        _ => Fault::UnknownExecution,
    }
}

/// What a sequence said was done.
#[derive(Default)]
struct Outcomes {
    opened: u32,
    done: u32,
    refused: u32,
    uncertain: u32,
}

impl Outcomes {
    fn count<T>(&mut self, ended: &Result<T, LinkError>) -> bool {
        match ended {
            Ok(_) => self.done += 1,
            Err(e)
                if ["link::uncertain", "link::different", "link::mode-changed", "link::right-remains"]
                    .contains(&e.code()) =>
            {
                self.uncertain += 1;
            }
            Err(_) => self.refused += 1,
        }
        ended.is_ok()
    }
}

/// One sequence: a login, a file, a module, a value, each asked for once; what is called done is looked for at the controller.
fn sequence(seed: u64, personality: Personality, outcomes: &mut Outcomes) {
    let mut random = ChaCha8Rng::seed_from_u64(seed);
    let double = double(personality);
    double.with(|c| {
        c.operator = if random.random_bool(0.8) { Operator::Grants } else { Operator::Silent };
        c.write_clears_right = random.random_bool(0.1);
        c.finds_errors = random.random_bool(0.05);
        c.refuses_logout = personality == Personality::Rw6 && random.random_bool(0.1);
        c.mode = if random.random_bool(0.2) { "MANR" } else { "AUTO" };
    });
    let share = [0.05, 0.15, 0.4][random.random_range(0..3)];
    let mut of_plan = ChaCha8Rng::seed_from_u64(seed ^ 0xfa17);
    double.plan(Box::new(move |seen, _| {
        (seen.number < FAULTY && of_plan.random_bool(share)).then(|| fault(&mut of_plan))
    }));
    let settings = robot_link::Settings {
        deadline: std::time::Duration::from_millis(60),
        long_deadline: std::time::Duration::from_millis(60),
        ..hasty()
    };
    let opened = open_with(&double, &settings);
    let Ok(mut session) = opened else {
        is_free(&double, seed, None);
        return;
    };
    outcomes.opened += 1;
    let text = MODULE.replace("64.7", &format!("{}", seed % 90));
    let written = session.write_file("Part.mod", text.as_bytes());
    if outcomes.count(&written) {
        let kept = double.with(|c| c.files.get("Part.mod").cloned());
        assert_eq!(
            kept.as_deref(),
            Some(text.as_bytes()),
            "seed {seed}: a file that is not whole was called written"
        );
        let loaded =
            session.with_right(&mut |_| {}, |s| s.exchange_module("T_ROB1", "Part", "Part.mod", true));
        if outcomes.count(&loaded) {
            let there = double.with(|c| c.module("Part").map(|m| m.text.clone()));
            assert_eq!(there.as_deref(), Some(text.as_str()), "seed {seed}: a module was called loaded");
        }
    }
    let value = format!("{}", seed % 21);
    let set = session.with_right(&mut |_| {}, |s| s.set_value("T_ROB1", "Part", "tcMode", &value));
    if outcomes.count(&set) {
        let kept = double.with(|c| c.value("Part", "tcMode"));
        assert_eq!(kept.as_deref(), Some(value.as_str()), "seed {seed}: a value was called written");
    }
    let ended = session.end();
    is_free(&double, seed, Some(&ended));
    let written = |what: &str| double.requests().iter().filter(|r| r.starts_with(what)).count();
    assert!(written("PUT") <= 1, "seed {seed}: a file was sent twice");
    let sets = double.requests().iter().filter(|r| r.starts_with("POST") && r.contains("/symbol/")).count();
    assert!(sets <= 1, "seed {seed}: a value was sent twice");
    let loads = double
        .requests()
        .iter()
        .filter(|r| r.starts_with("POST") && r.contains("loadmod") && !r.contains("unloadmod"))
        .count();
    assert!(loads <= 1, "seed {seed}: a module was loaded twice");
}

fn is_free(double: &Double, seed: u64, ended: Option<&Result<(), LinkError>>) {
    // The connection of a client that has gone is seen as closed in a moment.
    let is_held = || double.with(|c| matches!(c.holder, Holder::Session(..)));
    for _ in 0..100 {
        if !is_held() {
            break;
        }
        std::thread::sleep(std::time::Duration::from_millis(5));
    }
    let requests = || double.requests().join("\n");
    assert!(!is_held(), "seed {seed}: a right is held; the client said {ended:?}\n{}", requests());
    assert_eq!(double.hits(), Vec::<String>::new(), "seed {seed}");
    let modules = double.with(|c| c.modules.iter().map(|m| m.text.contains("ENDMODULE")).collect::<Vec<_>>());
    assert!(modules.iter().all(|is_whole| *is_whole), "seed {seed}: half a module is loaded");
}

/// Those that take seconds: `cargo test --test it -- --ignored long::`.
mod long {
    use super::*;

    #[test]
    #[ignore = "long"]
    fn a_thousand_sequences_of_faults_leave_nothing_held_and_nothing_half() {
        // Most of the time is waiting for answers that do not come.
        let mut outcomes = Outcomes::default();
        let parts: Vec<Outcomes> = std::thread::scope(|scope| {
            let part = |n: u64| {
                scope.spawn(move || {
                    let mut outcomes = Outcomes::default();
                    for seed in (n..SEQUENCES).step_by(LINES as usize) {
                        sequence(seed, Personality::ALL[(seed % 3) as usize], &mut outcomes);
                    }
                    outcomes
                })
            };
            let running: Vec<_> = (0..LINES).map(part).collect();
            running
                .into_iter()
                .map(|part| part.join().unwrap_or_else(|cause| std::panic::resume_unwind(cause)))
                .collect()
        });
        for part in parts {
            outcomes.opened += part.opened;
            outcomes.done += part.done;
            outcomes.refused += part.refused;
            outcomes.uncertain += part.uncertain;
        }
        println!(
            "{} logins, {} done, {} refused, {} said to be uncertain",
            outcomes.opened, outcomes.done, outcomes.refused, outcomes.uncertain
        );
        // Enough of each, or the faults test nothing.
        assert!(
            outcomes.opened > 500 && outcomes.done > 300 && outcomes.refused > 300 && outcomes.uncertain > 30
        );
    }
}
