//! How far the moves of a pass are from what the original means, collected into the session's report.

use super::arm::Move;
use super::compare::MoveComparator;
use super::findings::{BucketSwitch, ErrorStatistics, Pass, WorstMove};
use super::session::{ExecutedPass, Session};
use robot_model::deform::DeformedArm;

impl Session {
    /// Evaluates every move of a pass; `arm_at` gives the true arm at the program's move of an index.
    pub fn evaluate(&mut self, pass: ExecutedPass, t_min: f64, arm_at: &mut dyn FnMut(usize) -> DeformedArm) {
        let ExecutedPass { intended, executed, at_min, failure } = pass;
        let mismatch = MoveComparator::same_moves(&intended, &executed).err();
        let mut pass = Pass { failure, mismatch, ..self.pass_before_moves(t_min, at_min) };
        let evaluator = MoveComparator { closed: &self.closed, nominal: &self.nominal };
        let mut now: Option<(f64, DeformedArm)> = None;
        let mut unchanged = Vec::new();
        for (i, (a, b)) in intended.iter().zip(&executed).enumerate() {
            let truth = match &now {
                Some((at, truth)) if *at == b.steady_s => truth.clone(),
                _ => arm_at(i),
            };
            now = Some((b.steady_s, truth.clone()));
            let (Some(before), Some(after)) =
                (evaluator.pose_error(&truth, a, a), evaluator.pose_error(&truth, a, b))
            else {
                // One that the original does not make either, on this robot, is not made all the same.
                pass.unreached += usize::from(b.q_rad.is_none());
                continue;
            };
            pass.n += 1;
            pass.before.add(&before);
            pass.after.add(&after);
            if is_same(a.q_rad.as_ref(), b.q_rad.as_ref()) && evaluator.same_circle_point(a, b) {
                unchanged.push((b, after.position_m));
            } else {
                pass.corrected.add(&after);
                pass.mismatch = pass.mismatch.or_else(|| MoveComparator::other_joints(a, b));
                self.changed.insert((b.at.file.clone(), b.at.line));
            }
            if pass.worst.as_ref().is_none_or(|w| after.position_m > w.error_m) {
                pass.worst = Some(WorstMove::of(b, t_min, after.position_m));
            }
            if self.options.paths
                && let Some(path) = evaluator.path_error_m(&truth, a, b)
            {
                pass.path_after_m = Some(pass.path_after_m.unwrap_or(0.0).max(path));
            }
        }
        let corrected = pass.n - unchanged.len();
        if corrected > 0 {
            self.note_unchanged(&unchanged);
        }
        for (statistics, n) in
            [(&mut pass.before, pass.n), (&mut pass.after, pass.n), (&mut pass.corrected, corrected)]
        {
            statistics.rms_m = (statistics.rms_m / (n.max(1) as f64)).sqrt();
        }
        self.note_switch(&pass, intended.into_iter().zip(executed).collect(), arm_at);
        self.finish(pass);
    }

    /// A pass of which no move has been looked at.
    fn pass_before_moves(&mut self, t_min: f64, at_min: f64) -> Pass {
        Pass {
            t_min,
            at_min,
            n: 0,
            before: ErrorStatistics::default(),
            after: ErrorStatistics::default(),
            corrected: ErrorStatistics::default(),
            path_after_m: None,
            index: self.program.number(self.options.own_name("tcI")).ok(),
            program_min: self.program.number(self.options.own_name("tcMinute")).ok(),
            worst: None,
            failure: None,
            unreached: 0,
            mismatch: None,
        }
    }

    /// Notes the largest error of moves that are as in the original, by the line that they stand in.
    fn note_unchanged(&mut self, unchanged: &[(&Move, f64)]) {
        for (b, error_m) in unchanged {
            let worst = self.report.unchanged.entry((b.at.file.clone(), b.at.line)).or_insert(0.0);
            *worst = worst.max(*error_m);
        }
    }

    /// Notes how far targets jumped where the program has changed its bucket since the last pass; moves that then went to another place,
    /// or with another tool or work object, tell nothing of it.
    fn note_switch(
        &mut self,
        pass: &Pass,
        moves: Vec<(Move, Move)>,
        arm_at: &mut dyn FnMut(usize) -> DeformedArm,
    ) {
        let evaluator = MoveComparator { closed: &self.closed, nominal: &self.nominal };
        if let (Some(index), Some((last, last_moves))) = (pass.index, &self.last)
            && index != *last
        {
            let truth = moves.len().checked_sub(1).map(arm_at);
            let jump = truth.map_or(0.0, |truth| {
                let same_place = last_moves.iter().zip(&moves).filter(|((last, _), (now, _))| {
                    is_same(last.q_rad.as_ref(), now.q_rad.as_ref()) && last.setup == now.setup
                });
                same_place
                    .filter_map(|((_, last), (_, now))| evaluator.jump_m(&truth, last, now))
                    .fold(0.0, f64::max)
            });
            self.report.switches.push(BucketSwitch { t_min: pass.t_min, jump_m: jump });
        }
        if let Some(index) = pass.index {
            self.last = Some((index, moves));
        }
    }

    fn finish(&mut self, pass: Pass) {
        if let Some(worst) = &pass.worst
            && self.report.worst.as_ref().is_none_or(|w| worst.error_m > w.error_m)
        {
            self.report.worst = Some(worst.clone());
        }
        self.collect_messages();
        self.report.passes.push(pass);
    }
}

/// Joints closer than this are the same but for rounding, radians.
const ROUNDING_RAD: f64 = 1e-9;

fn is_same(a: Option<&[f64; 6]>, b: Option<&[f64; 6]>) -> bool {
    match (a, b) {
        (Some(a), Some(b)) => a.iter().zip(b).all(|(a, b)| (a - b).abs() < ROUNDING_RAD),
        (None, None) => true,
        _ => false,
    }
}

impl WorstMove {
    fn of(executed: &Move, t_min: f64, error_m: f64) -> Self {
        let (file, line) = (executed.at.file.clone(), executed.at.line);
        Self { t_min, file, line, target: executed.target.clone(), error_m }
    }
}
