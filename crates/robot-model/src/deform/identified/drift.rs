//! What of a model grows as the robot warms up, and what is there from the cold start on.

use super::{Growth, Identified, Term};
use crate::deform::{Deformation, EffectKind, GrowthLaw};

impl Term {
    /// How many of the values the growth scales, from the first on; those behind them are there from the cold start on.
    pub(in crate::deform) fn growing(&self) -> usize {
        if self.growth == Growth::Always {
            return 0;
        }
        match self.kind {
            EffectKind::ThermalLinkGrowth | EffectKind::ThermalJointDrift | EffectKind::JointStep => 1,
            EffectKind::LinkGeometry
            | EffectKind::BaseDrift
            | EffectKind::BaseStep
            | EffectKind::ToolDrift
            | EffectKind::ToolStep => self.values.len(),
            _ => 0,
        }
    }

    pub(in crate::deform) fn drifts(&self) -> bool {
        self.values.iter().take(self.growing()).any(|v| v.value != 0.0)
    }
}

impl Identified {
    /// The terms that grow, but not by `law`, each by its name and what it grows by.
    #[must_use]
    pub fn drifts_beside(&self, law: GrowthLaw) -> Vec<String> {
        let mut names: Vec<String> = Vec::new();
        for term in self.terms.iter().filter(|term| term.drifts()) {
            let by = match term.growth {
                Growth::Law(own) if own == law => continue,
                Growth::Law(own) => own.to_string(),
                Growth::Linear { from_min, to_min } => format!("minute {from_min} to {to_min}"),
                Growth::Step { t0_min } => format!("a step at minute {t0_min}"),
                Growth::Temperature { .. } => "temperature".to_owned(),
                Growth::Always => continue,
            };
            let name = format!("{} by {by}", term.kind.name());
            if !names.contains(&name) {
                names.push(name);
            }
        }
        names
    }

    /// Whether any term grows.
    #[must_use]
    pub fn drifts(&self) -> bool {
        self.terms.iter().any(Term::drifts)
    }

    /// Whether the cold arm is off already.
    #[must_use]
    pub fn is_off_cold(&self) -> bool {
        self.terms.iter().any(|term| term.values.iter().skip(term.growing()).any(|v| v.value != 0.0))
    }

    /// The same model of a robot that drifts `by` times as far; what is there from the cold start on stays.
    #[must_use]
    pub fn with_drift(&self, by: f64) -> Self {
        let mut model = self.clone();
        for term in &mut model.terms {
            let growing = term.growing();
            term.values.iter_mut().take(growing).for_each(|v| v.value *= by);
        }
        model
    }
}

impl Deformation {
    /// The law by which all of the drift grows, the table's and that of a model on top of it, which may hold besides what is there
    /// from the cold start on; `None` where nothing drifts, by lags, or one thing by another law than another.
    ///
    /// A step is taken as having happened ([`Identified::for_programs`]).
    #[must_use]
    pub fn one_law(&self, model: Option<&Identified>) -> Option<GrowthLaw> {
        let law = *self.growth()?;
        let Some(model) = model.map(|model| model.for_programs().0) else { return Some(law) };
        let drifts = model.drifts() || self.settled() != Default::default();
        (law.tau_min().is_some() && drifts && model.drifts_beside(law).is_empty()).then_some(law)
    }
}

#[cfg(test)]
mod tests {
    use super::super::{Estimate, Growth, Identified, Term};
    use crate::deform::{Deformation, EffectKind, GrowthLaw};
    use crate::kinematics::FrameOffsets;
    use crate::robot::Axis;

    fn term(kind: EffectKind, growth: Growth, values: &[f64]) -> Term {
        let values = values.iter().map(|&value| Estimate { value, sigma: None }).collect();
        Term { growth, ..Term::plain(kind, Some(Axis::at(1)), values) }
    }

    fn model(terms: Vec<Term>) -> Identified {
        Identified { terms, ..Identified::default() }
    }

    const LAW: GrowthLaw = GrowthLaw::TwoStage { tau_min: 46.0 };

    #[test]
    fn one_law_is_that_of_table_and_terms_alike() {
        let table = Deformation::paper();
        let none = Deformation::from_static(FrameOffsets::default(), LAW);
        let grows = |law| model(vec![term(EffectKind::ThermalLinkGrowth, Growth::Law(law), &[1e-4, 3e-5])]);
        let still = model(vec![term(EffectKind::JointOffset, Growth::Always, &[1e-3])]);
        assert_eq!(table.one_law(None), Some(LAW));
        assert_eq!(table.one_law(Some(&still)), Some(LAW));
        assert_eq!(none.one_law(Some(&still)), None, "nothing drifts");
        assert_eq!(none.one_law(Some(&grows(LAW))), Some(LAW));
        let other = grows(GrowthLaw::Exp { tau_min: 20.0 });
        assert_eq!(table.one_law(Some(&other)), None);
        assert_eq!(other.drifts_beside(LAW), ["thermal_link_growth by exp:20"]);
        // A step has happened: it is there from the cold start on, and no law of its own.
        let stepped = model(vec![term(EffectKind::BaseStep, Growth::Step { t0_min: 30.0 }, &[1e-4])]);
        assert_eq!(table.one_law(Some(&stepped)), Some(LAW));
    }

    #[test]
    fn the_drift_is_scaled_and_what_is_there_cold_is_not() {
        let grows = term(EffectKind::ThermalLinkGrowth, Growth::Law(LAW), &[1e-4, 3e-5]);
        let all = term(EffectKind::BaseDrift, Growth::Law(LAW), &[1e-4, 2e-4]);
        let still = term(EffectKind::JointOffset, Growth::Always, &[1e-3]);
        let scaled = model(vec![grows.clone(), all.clone(), still]).with_drift(2.0);
        let values = |k: usize| scaled.terms[k].values.iter().map(|v| v.value).collect::<Vec<f64>>();
        assert_eq!((values(0), values(1), values(2)), (vec![2e-4, 3e-5], vec![2e-4, 4e-4], vec![1e-3]));
        assert!(model(vec![grows]).is_off_cold() && !model(vec![all]).is_off_cold());
    }
}
