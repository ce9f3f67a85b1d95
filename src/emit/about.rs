//! The comment block's lines for people.

use super::common::Common;
use super::memory::{Memory, megabytes};
use super::options::{Clock, Core, EmitOptions, Form, Provenance, Sensor};
use super::{header, target};
use crate::compensate::plan::Totals;
use crate::units::{deg_from_rad, mm_from_m};

/// What the comment block tells people.
///
/// `common` may lack these lines and the buckets still.
pub fn about(common: &Common, options: &EmitOptions, form: Form, totals: &Totals) -> Vec<String> {
    let Common { names, core, schedule, temperature_c, .. } = common;
    let input =
        |what: &str, p: &Provenance| format!("{what} {}, SHA-256 {}", header::plain(&p.name), p.sha256);
    let (unit, zero) = temperature_c.map_or(("warm-up minute", 0.0), |[low_c, _]| ("degree", low_c));
    let memory = Memory::of_totals(totals, schedule.buckets.len());
    let edges: Vec<String> = schedule.buckets.iter().map(|b| target::spelled(zero + b.from_min)).collect();
    let clock = match &options.clock {
        Clock::Elapsed => format!("elapsed: minutes since {}", names.core("tcColdStart")),
        Clock::Warmth { growth, tau_cool_min, gap_min } => {
            let growth = growth.map_or_else(|| "as in the table".to_owned(), |g| g.to_string());
            let cool = tau_cool_min.map_or_else(|| "as warming".to_owned(), |t| format!("{t} min"));
            format!(
                "warmth: growth {growth}, time constant of cooling {cool}, pauses over {gap_min} min cool"
            )
        }
        Clock::Sensor { source, hold_min, stale_min } => {
            let source = match source {
                Sensor::Signal(name) => format!("signal:{name}"),
                Sensor::Pers(name) => format!("pers:{name} (a global PERS num of the task)"),
            };
            format!(
                "{source}, degrees Celsius; without a good reading the last one for {hold_min} min, then the \
                 originals; no good one is what has not changed for {stale_min} min"
            )
        }
    };
    let mut about = vec![
        input("Robot", &options.robot),
        input("Deformation", &options.deformation),
        format!(
            "Form {}, clock {clock}",
            match form {
                Form::Schedule => "schedule".to_owned(),
                Form::Modules => format!(
                    "modules: the files of HOME belong into the controller's HOME; one is loaded at a time, peak of \
                     program memory about {}",
                    megabytes(memory.peak_bytes(Form::Modules))
                ),
            }
        ),
        format!("Buckets from {} {}; the last holds on", unit, edges.join(", ")),
        format!(
            "Largest correction {:.4} mm, {:.5} deg",
            mm_from_m(totals.max_correction_m),
            deg_from_rad(totals.max_correction_rad)
        ),
        if options.absolute_accuracy {
            "Absolute Accuracy is declared to be on".to_owned()
        } else {
            "Absolute Accuracy must be off: the targets are made for nominal kinematics".to_owned()
        },
        if temperature_c.is_some() {
            "Nothing needs to be called; before the first good reading the original targets are used"
                .to_owned()
        } else {
            format!(
                "Call {} when the robot is cold, {} when it is fully warm; before that the original targets are \
                 used",
                names.core("tcColdStart"),
                names.core("tcWarmStart")
            )
        },
        format!(
            "{} -1 automatic, 0..{} that bucket, -2 the original targets; {} the bucket in use, -1 originals; \
             {} the {}",
            names.core("tcMode"),
            schedule.buckets.len() - 1,
            names.core("tcBucket"),
            names.core(if temperature_c.is_some() { "tcDegrees" } else { "tcMinute" }),
            if temperature_c.is_some() { "temperature" } else { "warm-up minute" }
        ),
        "To remove: load the original file, or get it back with `driftpost restore`".to_owned(),
    ];
    if *core == Core::Separate {
        about.push(format!(
            "Clock and index live in module {}, which must be loaded too",
            names.core("tcCore")
        ));
    } else {
        about.push(format!(
            "Clock and index live in this module under global names ({} and others): no other module with a clock of \
             its own loads beside it; compensate modules of one task in one run",
            names.core("tcTick")
        ));
    }
    about
}
