//! The links grow as they warm up.

use super::{Candidate, Effect, Form, Motion, Scene, Site, thermal};

/// Each link's vector grows by one strain (all links) or one link's alone, over warm-up; plus a constant.
pub struct ThermalLinkGrowth;

impl Effect for ThermalLinkGrowth {
    fn name(&self) -> &'static str {
        "thermal_link_growth"
    }
    fn unit(&self) -> &'static str {
        "ppm"
    }
    fn usual(&self) -> &'static str {
        "11 to 23 ppm/K over 5 to 25 K"
    }
    fn source(&self) -> &'static str {
        "Heisel, Richter, Wurst 1997, Thermal behaviour of industrial robots"
    }
    fn time(&self) -> &'static str {
        "drift"
    }
    fn untestable(&self, scene: &Scene) -> Option<String> {
        thermal::untestable(scene)
    }
    fn candidates(&self, scene: &Scene) -> Vec<Candidate> {
        let mut all = Vec::new();
        for link in [None, Some(0), Some(1), Some(2), Some(3), Some(4)] {
            let form = Form { joint: link, ..Form::PLAIN };
            let weight = if link.is_none() { 1.0 } else { 0.2 };
            let whole = Candidate {
                positive: true,
                counted: 1,
                factor: 1e6,
                weight,
                ..Candidate::new(form, vec![1.5e-4, 3e-4])
            };
            all.extend(thermal::shapes(scene, &whole));
        }
        all
    }
    fn motions(&self, form: &Form, scene: &Scene, site: &Site, out: &mut Vec<Motion>) {
        let mut grown = [[0.0; 6]; 2];
        for i in 0..6 {
            // Link i, counted from 0, lies between the origins i and i+1 and warms with joint i.
            if form.joint.is_some_and(|link| link != i) {
                continue;
            }
            let along = site.origins_m[i + 1] - site.origins_m[i];
            let drive = scene.drive(form.driver, site, Some(i));
            for k in 0..3 {
                grown[0][k] += along[k] * drive;
                grown[1][k] += along[k];
            }
        }
        out.extend(grown);
    }
}
