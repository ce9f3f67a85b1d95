//! A joint's zero is off: its encoder, its calibration mark.

use super::{Candidate, Effect, Form, Motion, Scene, Site, turn_joint};

/// J_j times a constant.
pub struct JointOffset;

impl Effect for JointOffset {
    fn name(&self) -> &'static str {
        "joint_offset"
    }
    fn unit(&self) -> &'static str {
        "rad"
    }
    fn usual(&self) -> &'static str {
        "0.1 to 2 mrad"
    }
    fn source(&self) -> &'static str {
        "Mooring, Roth, Driels, Fundamentals of Manipulator Calibration, 1991, ch. 2"
    }
    fn candidates(&self, _scene: &Scene) -> Vec<Candidate> {
        let mut all: Vec<Candidate> = (0..6).map(|j| Candidate::new(Form::of_joint(j), vec![4e-4])).collect();
        // All at once, for an arm that was never calibrated: the search takes it apart again.
        all.push(Candidate { weight: 0.1, ..Candidate::new(Form::PLAIN, vec![4e-4; 6]) });
        all
    }
    fn motions(&self, form: &Form, _scene: &Scene, site: &Site, out: &mut Vec<Motion>) {
        match form.joint {
            Some(_) => turn_joint(site, form.joint, 1.0, out),
            None => (0..6).for_each(|j| turn_joint(site, Some(j), 1.0, out)),
        }
    }
}
