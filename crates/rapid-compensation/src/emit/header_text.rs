//! The comment block's lines for people.

use super::clock::{Choice, CoreText};
use super::names::Names;
use super::options::{Clock, Core, DriftGrowth, EmitOptions, Sensor};
use super::touch::Touch;
use crate::compensate::plan::{Form, Plan, Totals};
use rapid_syntax::num;
use robot_model::deform::GrowthLaw;
use robot_model::units::{deg_from_rad, mm_from_m};

/// What the comment block tells people.
pub(super) fn header_text(
    (names, core, text): (&Names, Core, &CoreText<'_>),
    options: &EmitOptions,
    plan: &Plan,
    totals: &Totals,
) -> Vec<String> {
    let by_temperature = plan.temperature_c.is_some();
    let mut about = vec![
        format!("Form {}, clock {}", options.form.name(), clock(options, names.core("tcColdStart"))),
        what_scales(&text.choice, plan),
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
        what_to_call(names, &options.clock),
        modes(names, &text.choice, by_temperature),
        how_to_touch_up(names, totals),
        format!(
            "Motion that is not corrected does not ask: where the arm moves for long without, the program may call {}",
            names.core("tcUpdate")
        ),
    ];
    if let Some(touch) = &options.touch {
        about.extend(of_touch(names, touch));
    }
    about.push("To remove: load the original file, or get it back with `driftpost restore`".to_owned());
    about.push(where_the_clock_is(names, core));
    about
}

/// What corrections go by: the buckets with their edges, or functions of time.
fn what_scales(choice: &Choice<'_>, plan: &Plan) -> String {
    let (unit, zero) = plan.temperature_c.map_or(("warm-up minute", 0.0), |[low_c, _]| ("degree", low_c));
    match choice {
        Choice::Bucket(_) => {
            let edges: Vec<String> = plan.schedule.buckets.iter().map(|b| num(zero + b.from_min)).collect();
            format!("Buckets from {unit} {}; the last holds on", edges.join(", "))
        }
        Choice::Scale(scaled) => format!(
            "Corrections are scaled by {} of the {}",
            match scaled.functions.count() {
                1 => "one function".to_owned(),
                n => format!("{n} functions"),
            },
            if plan.temperature_c.is_some() { "temperature" } else { "warm-up" }
        ),
    }
}

/// Which routine has to be called, and when.
fn what_to_call(names: &Names, clock: &Clock) -> String {
    let when = match clock {
        Clock::Sensor { .. } => {
            return "Nothing needs to be called; before the first good reading the original targets are used"
                .to_owned();
        }
        _ if goes_on_standing(clock) => {
            "at each cold start: the minutes go on while the robot stands, over night too"
        }
        Clock::Warmth { .. } | Clock::Elapsed => {
            "once, on a cold robot, not each morning: the clock follows stops and nights itself"
        }
    };
    format!(
        "Call {} {when}. {} is for a robot \
         that is fully warm, {} for one that has worked so many minutes; before one of them was called the original \
         targets are used",
        names.core("tcColdStart"),
        names.core("tcWarmStart"),
        names.core("tcStartAt")
    )
}

/// What the mode can be set to, and where it is shown what is in force.
fn modes(names: &Names, choice: &Choice<'_>, by_temperature: bool) -> String {
    let mode = names.core("tcMode");
    let shown = names.core(if by_temperature { "tcDegrees" } else { "tcMinute" });
    let what = if by_temperature { "temperature" } else { "warm-up minute" };
    match choice {
        Choice::Bucket(schedule) => format!(
            "{mode} -1 automatic, 0..{} that bucket, -2 the original targets; {} the bucket in use, -1 originals; {shown} the \
             {what}",
            schedule.buckets.len().saturating_sub(1),
            names.core("tcBucket"),
        ),
        Choice::Scale(_) => format!(
            "{mode} -1 automatic, 0..100 per cent of the settled drift, -2 the original targets; {} the share of the drift, 0 \
             originals; {shown} the {what}",
            names.core("tcShare")
        ),
    }
}

/// How a target is touched up in the corrected program.
fn how_to_touch_up(names: &Names, totals: &Totals) -> String {
    let [schedules, ..] = totals.by_form;
    if schedules > 0 {
        "ModPos changes the one array element in force: `driftpost restore` turns it into the original that it means".to_owned()
    } else {
        format!(
            "ModPos cannot touch up a motion whose argument is a function: change the original target in Program Data, where \
             the cold robot is to stand{}",
            if totals.by_form[Form::Live as usize] > 0 {
                format!(", or let {} store where the warm arm stands", names.core("tcTeach"))
            } else {
                String::new()
            }
        )
    }
}

/// What a touch measures and keeps.
fn of_touch(names: &Names, touch: &Touch) -> Vec<String> {
    let measures = format!(
        "{} measures at {} ({}) how warm the arm is; {} the minutes since, {} one standard deviation in mm where the \
         drift is largest, {} what came of it",
        names.core("tcTouch"),
        touch.name,
        touch.point.join(", "),
        names.core("tcTouchAge"),
        names.core("tcTouchSigma"),
        names.core("tcTouchSaid"),
    );
    let log = touch.log.then(|| {
        format!(
            "Each touch is a line of the file in HOME that {} names, for driftpost state; {} begins a new one",
            names.core("tcLogFile"),
            names.core("tcColdStart"),
        )
    });
    std::iter::once(measures).chain(log).collect()
}

/// Which module has the clock and its functions.
fn where_the_clock_is(names: &Names, core: Core) -> String {
    match core {
        Core::Separate => {
            format!("Clock and functions live in module {}, which must be loaded too", names.core("tcCore"))
        }
        Core::Embedded => format!(
            "Clock and functions live in this module under global names ({} and others): no other module with a clock \
             of its own loads beside it; compensate modules of one task in one run",
            names.core("tcUpdate")
        ),
    }
}

/// Whether the minutes run while the robot stands.
fn goes_on_standing(clock: &Clock) -> bool {
    matches!(clock, Clock::Elapsed | Clock::Warmth { growth: DriftGrowth::Law(GrowthLaw::None), .. })
}

fn clock(options: &EmitOptions, cold_start: &str) -> String {
    match &options.clock {
        Clock::Elapsed => format!("elapsed: minutes since {cold_start}"),
        clock @ Clock::Warmth { .. } if goes_on_standing(clock) => {
            format!(
                "minutes since {cold_start}, standing or not: nothing that grows falls back while the robot stands"
            )
        }
        Clock::Warmth { growth, tau_cool_min, gap_min } => {
            let growth = match growth {
                DriftGrowth::Law(law) => law.to_string(),
                DriftGrowth::Table(None) => "as in the table".to_owned(),
                DriftGrowth::Table(Some(law)) => format!("as in the table, nearest {law}"),
            };
            let cool = tau_cool_min.map_or_else(|| "as warming".to_owned(), |t| format!("{t} min"));
            format!(
                "warmth: growth {growth}, time constant of cooling {cool}, pauses over {gap_min} min between motions cool"
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
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// What a person is told to call must be true of the clock: one that goes on over night is wrong the next morning.
    #[test]
    fn a_clock_that_goes_on_over_night_is_to_be_started_each_morning() {
        let warmth = |growth| Clock::Warmth { growth, tau_cool_min: None, gap_min: 5.0 };
        let said = |clock: &Clock| what_to_call(&Names::default(), clock);
        for goes_on in [Clock::Elapsed, warmth(DriftGrowth::Law(GrowthLaw::None))] {
            assert!(said(&goes_on).starts_with("Call tcColdStart at each cold start"), "{}", said(&goes_on));
        }
        for falls_back in [DriftGrowth::Law(GrowthLaw::Exp { tau_min: 46.0 }), DriftGrowth::Table(None)] {
            assert!(said(&warmth(falls_back)).contains("not each morning"), "{}", said(&warmth(falls_back)));
        }
    }
}
