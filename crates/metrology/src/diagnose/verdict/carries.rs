//! What was found at the poses measured, held against poses that were held out: what does not carry to them is no cause.

use super::judgement::Judgement;
use crate::diagnose::outcome::{ErrorReduction, Verdict};
use inference::cause::Cause;

/// Less than this share of the gap, in squares, is what a weak effect takes: whether it carries drowns in the noise.
const MUCH: f64 = 0.5;
/// So much of what is taken at the poses measured has to be taken at others too.
const CARRIED: f64 = 0.25;

/// A gap that is so many times as large is larger, and no rounding.
const WORSE: f64 = 1.005;

/// The same of one block, whose noise is that of some dozen readings.
const CLEARLY_WORSE: f64 = 1.1;

/// A size of so many of its standard deviations does not rest on a few poses.
const FIRM: f64 = 10.0;

/// Whether `causes` are one whose size all poses tell alike, so that four fifths of few of them tell it too: then searches without the rest
/// failed, not the cause. No gear line, which over a part of a turn may be any of several.
fn is_firm(causes: &[Cause]) -> bool {
    let [only] = causes else { return false };
    let ratio =
        only.size.zip(only.sigma).map_or(0.0, |(size, sigma)| size.abs() / sigma.max(f64::MIN_POSITIVE));
    only.n.is_none() && ratio > FIRM
}

/// Whether a model that takes most of the gap at its own poses takes next to nothing of it at poses held out, or makes it larger there, beyond
/// what chance does.
fn does_not_carry(shrink: &ErrorReduction) -> Option<[f64; 2]> {
    let (before, after, left) = (shrink.before_rms_mm?, shrink.after_rms_mm?, shrink.floor_rms_mm?);
    let [gap, here, there] = [before.powi(2), before.powi(2) - left.powi(2), before.powi(2) - after.powi(2)];
    let is_worse = shrink.ci90.is_some_and(|[least, _]| least > 1.0);
    (is_worse || here > MUCH * gap && there < CARRIED * here).then_some([before, after])
}

/// The gap at poses held out without and with a model that makes it larger there, 3-D rms, mm, whatever chance does: among all poses, or both
/// in the last part of the time and in a region of the workspace that are held out whole. Where the gap is not explained all that does not
/// carry is as bad, and one such block is enough: lines and springs that stand for a channel that is missing, or for a shape of no cause.
#[must_use]
pub(crate) fn worse_elsewhere(
    shrink: &ErrorReduction,
    verdict: Verdict,
    causes: &[Cause],
) -> Option<[f64; 2]> {
    let (before, after) = (shrink.before_rms_mm?, shrink.after_rms_mm?);
    let blocks = shrink.time_block.zip(shrink.region_block).filter(|(time, region)| {
        [time, region].iter().all(|block| block.after_rms_mm > WORSE * block.before_rms_mm)
    });
    let is_open = matches!(verdict, Verdict::UnexplainedStructure | Verdict::UnexplainedScatter);
    let of_one = || {
        let mut blocks = [shrink.time_block, shrink.region_block].into_iter().flatten();
        blocks.find(|block| block.after_rms_mm > CLEARLY_WORSE * block.before_rms_mm)
    };
    let of_all = (after > WORSE * before).then_some([before, after]);
    let of_blocks = || blocks.map(|(_, region)| [region.before_rms_mm, region.after_rms_mm]);
    let of_open = || does_not_carry(shrink).filter(|_| is_open);
    let of_open_block =
        || of_one().filter(|_| is_open).map(|block| [block.before_rms_mm, block.after_rms_mm]);
    of_all.or_else(of_blocks).or_else(of_open).or_else(of_open_block).filter(|_| !is_firm(causes))
}

impl Judgement {
    /// Takes the verdict back where causes that explain the gap at the poses measured leave it as it is at poses held out: a shape that no
    /// effect has is taken by any dozen of gear lines, pose by pose. The gap there without and with them, 3-D rms, mm.
    pub(crate) fn hold_against(&mut self, shrink: &ErrorReduction) -> Option<[f64; 2]> {
        let names = self.verdict.names_causes();
        let [before_mm, after_mm] = does_not_carry(shrink).filter(|_| names && !is_firm(&self.causes))?;
        self.verdict = Verdict::UnexplainedStructure;
        self.reason = format!(
            "what takes the gap at the poses measured does not at poses held out ({before_mm:.3} mm without it, {after_mm:.3} mm with it): the gap \
             has a structure that no effect of the library takes"
        );
        self.are_candidates();
        Some([before_mm, after_mm])
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::diagnose::outcome::HeldOutBlock;
    use robot_model::deform::EffectKind;

    /// Before, after and noise: all of 0.1 mm but the noise, none, and an effect below the noise.
    #[test]
    fn what_is_taken_has_to_be_taken_elsewhere_too() {
        let of = |[before, after, left]: [f64; 3]| {
            let [before_rms_mm, after_rms_mm, floor_rms_mm] = [before, after, left].map(Some);
            does_not_carry(&ErrorReduction {
                before_rms_mm,
                after_rms_mm,
                floor_rms_mm,
                ..ErrorReduction::default()
            })
        };
        assert_eq!(of([0.1, 0.03, 0.02]), None);
        assert_eq!(of([0.1, 0.11, 0.02]), Some([0.1, 0.11]));
        assert_eq!(of([0.1, 0.1, 0.09]), None);
        assert_eq!(does_not_carry(&ErrorReduction::default()), None);
        // A step found in what sways, most of which is taken for noise.
        let sways = |ci90| ErrorReduction {
            before_rms_mm: Some(0.054),
            after_rms_mm: Some(0.068),
            floor_rms_mm: Some(0.053),
            ci90: Some(ci90),
            ..ErrorReduction::default()
        };
        assert_eq!(does_not_carry(&sways([1.1, 1.38])), Some([0.054, 0.068]));
        assert_eq!(does_not_carry(&sways([0.97, 1.5])), None);
        let worse = |shrink: &ErrorReduction, verdict| worse_elsewhere(shrink, verdict, &[]);
        assert_eq!(worse(&sways([0.97, 1.5]), Verdict::Explained), Some([0.054, 0.068]));
        assert_eq!(worse(&ErrorReduction::default(), Verdict::Explained), None);
        // Better at poses here and there, and worse where a day or a region is held out.
        let block = |before_rms_mm, after_rms_mm| {
            Some(HeldOutBlock { n: 17, before_rms_mm, after_rms_mm, causes_only_rms_mm: after_rms_mm })
        };
        let of_blocks = |time_block, region_block| ErrorReduction {
            before_rms_mm: Some(0.2),
            after_rms_mm: Some(0.19),
            floor_rms_mm: Some(0.19),
            time_block,
            region_block,
            ..ErrorReduction::default()
        };
        let both = of_blocks(block(0.18, 0.3), block(0.21, 0.31));
        assert_eq!(worse(&both, Verdict::Several), Some([0.21, 0.31]));
        assert_eq!(worse(&of_blocks(block(0.18, 0.3), block(0.21, 0.2)), Verdict::Several), None);
        // What takes all of 2 mm here takes 0.02 of it elsewhere.
        let follows = ErrorReduction {
            before_rms_mm: Some(2.0),
            after_rms_mm: Some(1.98),
            floor_rms_mm: Some(0.1),
            ..ErrorReduction::default()
        };
        assert_eq!(worse(&follows, Verdict::UnexplainedScatter), Some([2.0, 1.98]));
        assert_eq!(worse(&follows, Verdict::Geometry), None);
    }

    #[test]
    fn one_size_that_is_known_to_a_tenth_is_firm() {
        let sized =
            |kind, size, sigma| Cause { size: Some(size), sigma: Some(sigma), ..Cause::of(kind, 0.9) };
        let coupling = |sigma| sized(EffectKind::JointCoupling, -9e-4, sigma);
        assert!(is_firm(&[coupling(3e-5)]));
        assert!(!is_firm(&[coupling(2e-4)]));
        assert!(!is_firm(&[coupling(3e-5), coupling(3e-5)]));
        let line = Cause { n: Some(88), ..sized(EffectKind::GearMesh, 1e-4, 1e-6) };
        assert!(!is_firm(&[line]));
        assert!(!is_firm(&[Cause::of(EffectKind::BaseTilt, 0.9)]));
    }
}
