//! Eight hours with breaks, a touch every half hour.

use super::{Cell, TABLE_TAU_MIN, Truth, emitted, search};
use rapid_compensation::compensate::FormChoice;
use robot_model::deform::GrowthLaw;

/// Minutes of work and of standing in turn.
const SHIFT_MIN: [u32; 7] = [120, 16, 104, 44, 104, 16, 76];
/// Between two passes of the work, minutes.
const STEP_MIN: u32 = 4;
/// Said to have worked so long at the beginning, minutes.
const TOLD: &str = "started";

/// What a shift came to, mm.
#[derive(Clone, Copy, Debug, Default)]
pub struct Came {
    pub rms: f64,
    pub worst: f64,
    /// Share of the moments at which the truth lies within the interval stated for 90 per cent.
    pub covered: f64,
}

/// The cell's program of a table that grows by a law, touching with a noise in mm or not.
pub fn program(form: FormChoice, law: GrowthLaw, touch: Option<f64>) -> Vec<u8> {
    with_start_routine(emitted(form, law, touch.map(|sigma_mm| (search(), sigma_mm))))
}

/// With a routine that says how long the arm has worked.
pub fn with_start_routine(program: Vec<u8>) -> Vec<u8> {
    let text = String::from_utf8(program).unwrap();
    text.replacen("  PROC main()", "  PROC started()\n    tcStartAt 40;\n  ENDPROC\n  PROC main()", 1)
        .into_bytes()
}

/// A shift with a touch every so many minutes of work.
pub fn shift(program: &[u8], truth: &Truth, every_min: Option<u32>) -> Came {
    shift_in(&mut Cell::new(program, truth), program, truth, every_min)
}

/// The same in a cell that is there.
pub fn shift_in(cell: &mut Cell, program: &[u8], truth: &Truth, every_min: Option<u32>) -> Came {
    cell.call(TOLD);
    let (mut came, mut n, mut within, mut seen) = (Came::default(), 0_u32, 0_u32, 0_u32);
    let mut since_touch = u32::MAX;
    for (k, minutes) in SHIFT_MIN.into_iter().enumerate() {
        // A pause lasts from the last motion to the next; the first pass is at the beginning.
        let steps: Vec<(u32, bool)> = match k % 2 {
            0 => std::iter::repeat_n((STEP_MIN, true), (minutes / STEP_MIN) as usize).collect(),
            _ => vec![(minutes, false)],
        };
        let at_once = (k == 0).then_some((0, true));
        for (minutes, working) in at_once.into_iter().chain(steps) {
            cell.pass_min(f64::from(minutes), working);
            since_touch = since_touch.saturating_add(minutes);
            if every_min.is_some_and(|every_min| since_touch >= every_min) {
                cell.call("tcTouch");
                since_touch = 0;
            }
            let errors = cell.work();
            came.worst = errors.iter().copied().fold(came.worst, f64::max);
            came.rms += errors.iter().map(|e| e * e).sum::<f64>() / errors.len() as f64;
            n += 1;
            if every_min.is_some() && cell.number("tcTouchAge") >= 0.0 {
                let off_mm =
                    largest_mm(program) * (truth.amount * cell.warmth.share() - cell.number("tcHas"));
                within += u32::from(off_mm.abs() <= 1.645 * cell.number("tcTouchSigma"));
                seen += 1;
            }
        }
    }
    came.rms = (came.rms / f64::from(n)).sqrt();
    came.covered = f64::from(within) / f64::from(seen.max(1));
    came
}

/// What the program multiplies the share's deviation by to show it, mm.
pub fn largest_mm(program: &[u8]) -> f64 {
    let text = String::from_utf8_lossy(program);
    let behind = text.split("tcTouchSigma:=").find_map(|part| part.split_once("*Sqrt(")).unwrap().0;
    behind.parse().unwrap()
}

pub fn median(mut values: Vec<f64>) -> f64 {
    values.sort_by(f64::total_cmp);
    let n = values.len();
    (values[(n - 1) / 2] + values[n / 2]) / 2.0
}

/// Medians over so many runs, touching every so many minutes or not at all, and the mean of what is covered.
fn medians(sigma_mm: f64, every_min: Option<u32>, runs: u64) -> Came {
    let law = GrowthLaw::TwoStage { tau_min: TABLE_TAU_MIN };
    let text = program(FormChoice::Ramp, law, every_min.map(|_| sigma_mm));
    let all: Vec<Came> =
        (0..runs).map(|seed| shift(&text, &Truth::drawn(seed, sigma_mm), every_min)).collect();
    let worst = |came: &Came| came.worst;
    let (least, most) =
        (all.iter().map(worst).fold(f64::MAX, f64::min), all.iter().map(worst).fold(0.0, f64::max));
    let came = Came {
        rms: median(all.iter().map(|c| c.rms).collect()),
        worst: median(all.iter().map(worst).collect()),
        covered: all.iter().map(|c| c.covered).sum::<f64>() / runs as f64,
    };
    println!(
        "{sigma_mm} mm, {every_min:?} min, {runs} runs: {came:?}, worst moments {least:.4} to {most:.4}"
    );
    came
}

#[test]
fn a_few_shifts_are_as_good_as_the_filter_promises() {
    let [with, without] = [Some(30), None].map(|every_min| medians(0.02, every_min, 4));
    assert!(with.rms <= 0.018 && with.worst <= 0.055, "{with:?}");
    assert!(without.worst > 0.055 && without.rms > 1.5 * with.rms, "{without:?}");
}

#[test]
#[ignore = "a quarter of a minute: the figures of docs/TOUCH.md"]
fn a_hundred_shifts_with_a_touch_every_half_hour_and_without() {
    let [with, without] = [Some(30), None].map(|every_min| medians(0.02, every_min, 100));
    assert!(with.rms <= 0.018 && with.worst <= 0.055, "{with:?}");
    assert!((0.85..=0.95).contains(&with.covered), "{with:?}");
    assert!((0.057..0.098).contains(&without.worst), "{without:?}");
}

#[test]
#[ignore = "a quarter of a minute: the figures of docs/TOUCH.md"]
fn a_hundred_shifts_with_a_finer_touch_every_quarter_of_an_hour() {
    let with = medians(0.01, Some(15), 100);
    assert!(with.rms <= 0.009 && (0.85..=0.95).contains(&with.covered), "{with:?}");
}
