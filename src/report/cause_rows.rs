//! Causes as lines for people: in words, with their size at the tool.

use metrology::diagnose::{Cause, GearBand, SizeUnit, describe, gear_bands};
use robot_model::deform::EffectKind;
use robot_model::units::mrad_from_rad;
use std::fmt::Write;

/// A row for each cause; the lines of one joint's gear, where there are several, are one. Of causes that are there the largest at
/// the tool stand first, alternatives together, the likeliest of them first; of mere candidates the likeliest. `gap_mm`: the gap that they
/// are to explain.
pub fn rows(causes: &[Cause], named: bool, gap_mm: Option<f64>) -> Vec<String> {
    let (bands, others) = gear_bands(causes);
    let largest = |slot: usize| {
        let of_slot = causes.iter().filter(|c| c.slot == slot);
        of_slot.map(Cause::seen_mm).fold(0.0, f64::max)
    };
    let mut rows: Vec<(f64, String)> =
        bands.iter().map(|band| (band.seen_mm, band_in_words(band, gap_mm))).collect();
    // They come the likeliest first, and sorting keeps that order among alternatives.
    rows.extend(others.iter().map(|cause| (largest(cause.slot), in_words(cause, causes, gap_mm))));
    if named {
        sorting::by(&mut rows, |a, b| b.0.total_cmp(&a.0));
    }
    rows.into_iter().map(|(_, row)| row).collect()
}

/// The lines of one joint's gear.
fn band_in_words(band: &GearBand, gap_mm: Option<f64>) -> String {
    let beyond = if gap_mm.is_some_and(|gap_mm| band.seen_mm > gap_mm) {
        " one by one, more than the gap: over the angles that were measured they take each other back"
    } else {
        ""
    };
    format!(
        "gear_mesh of joint {} ({}): {} lines, {} to {} a turn, {:.3} mrad rms, {}{beyond}",
        band.joint,
        plainly(EffectKind::GearMesh),
        band.lines,
        band.n[0],
        band.n[1],
        mrad_from_rad(band.rms_rad),
        moves(band.rms_mm, band.seen_mm)
    )
}

/// What an effect is, for someone who has never read its name.
pub fn plainly(effect: EffectKind) -> &'static str {
    match effect {
        EffectKind::JointOffset => "its zero is off",
        EffectKind::LinkGeometry => "the link is not as drawn",
        EffectKind::JointCompliance => "its gear gives under gravity's torque",
        EffectKind::LinkBending => "the link bends under what hangs beyond it",
        EffectKind::BaseTilt => "the stand gives under the robot's weight",
        EffectKind::GearEccentricity => "a gear or encoder disc runs out of centre",
        EffectKind::GearSecondHarmonic => "a gear or bearing is oval",
        EffectKind::GearMesh => "teeth or rollers of its gear",
        EffectKind::JointGain => "it turns a little more or less than it says",
        EffectKind::JointCoupling => "one joint turns the other a little",
        EffectKind::Backlash => "play in its gear",
        EffectKind::ThermalLinkGrowth => "links grow as they warm up",
        EffectKind::ThermalJointDrift => "its zero drifts as it warms up",
        EffectKind::JointStep => "its zero jumped at one moment",
        EffectKind::BaseDrift => "base and instrument creep apart",
        EffectKind::BaseStep => "base or instrument was moved",
        EffectKind::InstrumentScale => "the instrument's lengths are scaled",
        EffectKind::ToolDrift => "the target creeps on the flange",
        EffectKind::ToolStep => "the target was moved on the flange",
        EffectKind::PayloadMass => {
            "the payload weighs more or less than declared, or its centre of gravity lies elsewhere"
        }
        EffectKind::JointRounding => "joints are written with too few decimals",
        EffectKind::SwappedAxes => "measured axes are swapped or mirrored",
        EffectKind::GearSpectrum => "",
    }
}

/// Likelier than this a cause is there, however large.
const IS_THERE: f64 = 0.9;

/// One cause; `causes` are all, among which its alternatives are.
fn in_words(cause: &Cause, causes: &[Cause], gap_mm: Option<f64>) -> String {
    let mut text = describe(cause);
    let plain = plainly(cause.effect);
    if !plain.is_empty() {
        let _ = write!(text, " ({plain})");
    }
    if let Some(size) = cause.size {
        let unit = if cause.unit == SizeUnit::One { String::new() } else { format!(" {}", cause.unit) };
        // Writing to a String cannot fail.
        let _ = match cause.sigma {
            Some(sigma) if sigma > size => {
                let there = if cause.posterior > IS_THERE { "it is there, but " } else { "" };
                let most = number(size + 2.0 * sigma);
                write!(text, ": {there}how large it is these data do not tell (anything up to {most}{unit})")
            }
            Some(sigma) => write!(text, ": {}{unit}", measured(size, sigma)),
            None => write!(text, ": {}{unit}", number(size)),
        };
    }
    if let Some(rms_mm) = cause.rms_mm {
        let _ = write!(text, ", {}", moves(rms_mm, cause.seen_mm()));
        if gap_mm.is_some_and(|gap_mm| cause.seen_mm() > gap_mm) {
            let _ = write!(text, ", most of it taken back by others: {:.3} mm of the gap", cause.of_gap_mm());
        }
    }
    let alternatives = causes.iter().filter(|c| c.slot == cause.slot).count();
    let choice =
        if alternatives > 1 { format!(", one of {alternatives} in its place") } else { String::new() };
    let _ = write!(text, "; probability {}{choice}", percent(cause.posterior));
    text
}

/// Where base and target take more than this share of what an effect does, both numbers are said.
const LEFT: f64 = 0.8;

/// What an effect does at the measured point, and what base and target leave of that; one on an axis that the point lies on is seen
/// by the orientation alone.
fn moves(rms_mm: f64, seen_mm: f64) -> String {
    if rms_mm < 0.0005 {
        "turns the tool without moving it".to_owned()
    } else {
        let seen = if seen_mm < LEFT * rms_mm {
            format!(", {seen_mm:.3} mm beside base and target")
        } else {
            String::new()
        };
        format!("moves the tool by {rms_mm:.3} mm{seen}")
    }
}

pub fn percent(p: f64) -> String {
    if p > 0.999 {
        "over 99.9 %".to_owned()
    } else if p < 0.001 {
        "under 0.1 %".to_owned()
    } else {
        format!("{:.1} %", 100.0 * p)
    }
}

pub fn number(value: f64) -> String {
    if wants_exponent(value) { format!("{value:.2e}") } else { format!("{value:.3}") }
}

fn wants_exponent(value: f64) -> bool {
    value != 0.0 && !(1e-2..1e5).contains(&value.abs())
}

/// Decimals beyond which no size is written.
const MOST_DECIMALS: i32 = 9;

/// A size with its standard uncertainty to two significant digits, both to the same place (JCGM 100:2008, 7.2.6).
fn measured(size: f64, sigma: f64) -> String {
    let place = |value: f64| value.abs().log10().floor() as i32;
    if !(sigma > 0.0 && sigma.is_finite() && size.is_finite()) {
        return format!("{} +- {}", number(size), number(sigma));
    }
    let exponent = if wants_exponent(size) { place(size) } else { 0 };
    let decimals = (exponent - place(sigma) + 1).clamp(0, MOST_DECIMALS) as usize;
    let unit = 10.0_f64.powi(exponent);
    let power = if exponent == 0 { String::new() } else { format!("e{exponent}") };
    format!("{:.decimals$}{power} +- {:.decimals$}{power}", size / unit, sigma / unit)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn row(posterior: f64, size: f64, seen_mm: f64) -> String {
        let cause = Cause {
            size: Some(size),
            sigma: Some(1e-5),
            unit: SizeUnit::Radian,
            rms_mm: Some(2.0),
            rms_seen_mm: Some(seen_mm),
            rms_of_gap_mm: Some(0.05),
            ..Cause::of(EffectKind::JointOffset, posterior)
        };
        rows(&[cause], true, Some(0.18)).remove(0)
    }

    #[test]
    fn a_cause_that_others_take_back_is_told_by_what_of_the_gap_rests_on_it() {
        let more = row(0.99, 1e-3, 1.99);
        assert!(
            more.contains("moves the tool by 2.000 mm, most of it taken back by others: 0.050 mm of the gap"),
            "{more}"
        );
        assert!(!row(0.99, 1e-3, 0.15).contains("taken back"));
    }

    #[test]
    fn a_size_ends_where_its_uncertainty_does() {
        for (size, sigma, text) in [
            (674.232, 98.645, "674 +- 99"),
            (2.9218, 0.36623, "2.92 +- 0.37"),
            (0.212, 0.065, "0.212 +- 0.065"),
            (12.3456, 0.0012, "12.3456 +- 0.0012"),
            (1.51e-3, 1.31e-4, "1.51e-3 +- 0.13e-3"),
            (3.29e-7, 7.81e-8, "3.29e-7 +- 0.78e-7"),
            (0.02, 1e-5, "0.020000 +- 0.000010"),
            // Tens and hundreds are written out, and no sigma means none.
            (4321.0, 1234.0, "4321 +- 1234"),
            (0.5, 0.0, "0.500 +- 0.000"),
        ] {
            assert_eq!(measured(size, sigma), text);
        }
    }

    #[test]
    fn a_size_that_is_not_told_is_said_to_be_so() {
        let open = row(0.9999, 5e-6, 0.1);
        assert!(
            open.contains(
                "it is there, but how large it is these data do not tell (anything up to 2.50e-5 rad)"
            ),
            "{open}"
        );
        assert!(row(0.4, 5e-6, 0.1).contains(": how large it is these data do not tell"));
    }
}
