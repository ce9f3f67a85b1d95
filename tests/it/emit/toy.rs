//! Programs and plans for the tests of emitting, made from text by a reader that knows just enough: so
//! that what is emitted is tested apart from how targets are understood and corrected.

use nalgebra::{Isometry3, Quaternion, Translation3, UnitQuaternion};
use rapid_compensation::compensate::plan::{
    Corrected, Corrections, Form, PathDeviation, Plan, PlannedMotion, PlannedTarget, Status, Summary,
};
use rapid_compensation::schedule::{Bucket, Schedule};
use rapid_program::Program;
use rapid_program::data::{ConfData, JointTarget, RobTarget};
use rapid_program::motion::{
    Loop, Motion, MotionSetup, Origin, Path, RoutineId, RoutineInfo, Target, TargetValue,
};
use rapid_program::one_or_many::OneOrMany;
use rapid_syntax::SourceFile;
use rapid_syntax::diagnostic::FileId;
use rapid_syntax::tree::{
    ArgKind, CallStmt, Callee, DataDecl, Expr, ExprKind, FileItem, Module, ModuleItem, Routine, Stmt,
    StmtKind,
};
use robot_model::units::{m_from_mm, rad_from_deg};
use std::sync::Arc;

/// Reads the files.
pub fn program(files: &[(&str, &[u8])]) -> Program {
    let read = |(i, (path, bytes)): (u32, &(&str, &[u8]))| SourceFile::read(FileId(i), *path, bytes.to_vec());
    program_of((0..).zip(files).map(read).collect())
}

/// Understands files that were read.
pub fn program_of(files: Vec<SourceFile>) -> Program {
    let mut program = Program { files: files.clone(), ..Program::default() };
    for file in &files {
        for item in &file.tree.items {
            let FileItem::Module(module) = item else { continue };
            for item in &module.items {
                if let ModuleItem::Routine(routine) = item {
                    Reader { files: &files, file, module, routine, program: &mut program, loops: vec![] }
                        .read();
                }
            }
        }
    }
    program
}

struct Reader<'a> {
    files: &'a [SourceFile],
    file: &'a SourceFile,
    module: &'a Module,
    routine: &'a Routine,
    program: &'a mut Program,
    loops: Vec<usize>,
}

impl Reader<'_> {
    fn read(&mut self) {
        let text = |r| String::from_utf8_lossy(self.file.text(r)).into_owned();
        self.program.routines.push(RoutineInfo {
            file: self.file.id,
            module: text(self.module.name),
            name: text(self.routine.name),
            range: self.routine.range,
        });
        let before = self.program.motions.len();
        self.body(&self.routine.body);
        if self.program.motions.len() == before {
            self.program.routines.pop();
        }
    }

    fn body(&mut self, body: &[Stmt]) {
        for stmt in body {
            match &stmt.kind {
                StmtKind::Call(call) => self.call(stmt, call),
                StmtKind::CompactIf(branch) => self.body(std::slice::from_ref(&branch.then)),
                StmtKind::If(branch) => {
                    branch.arms.iter().for_each(|(_, body)| self.body(body));
                    self.body(branch.otherwise.as_deref().unwrap_or_default());
                }
                StmtKind::While(looped) => {
                    self.loops.push(self.program.loops.len());
                    self.program.loops.push(Loop {
                        file: self.file.id,
                        routine: RoutineId(self.program.routines.len() as u32 - 1),
                        unconditional: looped.cond.kind == ExprKind::Bool(true),
                        passes: None,
                    });
                    self.body(&looped.body);
                    self.loops.pop();
                }
                StmtKind::For(looped) => self.body(&looped.body),
                _ => {}
            }
        }
    }

    fn call(&mut self, stmt: &Stmt, call: &CallStmt) {
        let Callee::Name(name) = call.callee else { return };
        let (kind, path, count) = match self.file.text(name).to_ascii_lowercase().as_slice() {
            b"movel" => ("MoveL", Path::Linear, 1),
            b"movej" => ("MoveJ", Path::Joint, 1),
            b"moveabsj" => ("MoveAbsJ", Path::AbsJoint, 1),
            b"movec" => ("MoveC", Path::Circular, 2),
            _ => return,
        };
        let args = call.args.iter().filter_map(|a| match &a.kind {
            ArgKind::Positional(expr) => Some(expr),
            _ => None,
        });
        let joint = path == Path::AbsJoint;
        let targets = args.take(count).map(|expr| self.target(expr, joint)).collect();
        let setup = MotionSetup {
            routine: RoutineId(self.program.routines.len() as u32 - 1),
            loops: self.loops.clone(),
            kind: kind.into(),
            path,
            tool_name: None,
            tool: None,
            wobj_name: None,
            wobj: None,
            later_frames: vec![],
            tool_argument: None,
            wobj_argument: None,
            speed: None,
            zone: None,
            time_s: None,
            conf_monitored: None,
            grip: None,
            has_total_load: false,
            uneven_turn: None,
        };
        self.program.motions.push(Motion {
            file: self.file.id,
            line: self.file.line(stmt.range),
            range: stmt.range,
            setup: Arc::new(setup),
            targets,
            previous: None,
            from_start: false,
            skip_reason: None,
            run_time: false,
            from_search: false,
        });
    }

    fn target(&self, expr: &Expr, joint: bool) -> Target {
        let (mut origin, mut literal) = (Origin::Expression(Box::default()), None);
        match &expr.kind {
            ExprKind::Aggregate(_) | ExprKind::Numbers => {
                origin = Origin::Inline;
                literal = Some(self.file.span(expr.range));
            }
            ExprKind::Name => {
                let name = self.file.text(expr.range);
                if let Some((file, data)) = self.declaration(name) {
                    let name = String::from_utf8_lossy(name).into_owned();
                    origin = Origin::Named { name, declaration: file.span(data.range) };
                    let init = data
                        .init
                        .as_ref()
                        .filter(|i| matches!(i.kind, ExprKind::Aggregate(_) | ExprKind::Numbers));
                    literal = init.map(|i| file.span(i.range));
                }
            }
            _ => {}
        }
        let numbers = literal.map(|span| numbers(span.range.of(&self.files[span.file.0 as usize].bytes)));
        let value = value(&numbers.unwrap_or_default(), joint);
        let target = Target::new(expr.range, origin).with_value(&value);
        match literal {
            Some(literal) => target.with_literal(literal),
            None => target,
        }
    }

    fn declaration(&self, name: &[u8]) -> Option<(&SourceFile, &DataDecl)> {
        let is = |file: &SourceFile, d: &DataDecl| file.text(d.name).eq_ignore_ascii_case(name);
        for stmt in &self.routine.body {
            if let StmtKind::Data(data) = &stmt.kind
                && is(self.file, data)
            {
                return Some((self.file, data));
            }
        }
        std::iter::once(self.file).chain(self.files).find_map(|file| {
            file.tree.items.iter().find_map(|item| match item {
                FileItem::Module(module) => module.items.iter().find_map(|item| match item {
                    ModuleItem::Data(data) if is(file, data) => Some((file, data)),
                    _ => None,
                }),
                _ => None,
            })
        })
    }
}

/// The numbers of an aggregate; whatever is no number counts as nothing.
pub fn numbers(text: &[u8]) -> Vec<f64> {
    let text = String::from_utf8_lossy(text).into_owned();
    text.split([',', '[', ']']).filter_map(|t| t.trim().parse().ok()).collect()
}

fn value(n: &[f64], joint: bool) -> TargetValue {
    let ext = |from: usize| std::array::from_fn(|i| n.get(from + i).copied().filter(|v| *v < 8e9));
    let at = |i: usize| n.get(i).copied().unwrap_or_default();
    if joint {
        let q_rad = std::array::from_fn(|i| Some(rad_from_deg(at(i))));
        return TargetValue::Joint(JointTarget { q_rad, ext: ext(6) });
    }
    let w = if n.len() > 3 { at(3) } else { 1.0 };
    let rotation = UnitQuaternion::from_quaternion(Quaternion::new(w, at(4), at(5), at(6)));
    let translation = Translation3::new(m_from_mm(at(0)), m_from_mm(at(1)), m_from_mm(at(2)));
    let conf = ConfData { cf1: at(7) as i32, cf4: at(8) as i32, cf6: at(9) as i32, cfx: at(10) as i32 };
    TargetValue::Rob(RobTarget {
        object_from_tcp: Isometry3::from_parts(translation, rotation),
        conf,
        ext: ext(11),
    })
}

/// A plan of `buckets` buckets 10 minutes wide: bucket k moves each target by k + 1 hundredths of a mm or
/// degree, and where `tool` says so by as much more.
pub fn plan(program: &Program, buckets: usize, kept: &[usize], tool: impl Fn(&Motion) -> f64) -> Plan {
    let motions = program.motions.iter().enumerate().map(|(i, motion)| {
        let mut planned = PlannedMotion {
            status: Status::Compensated,
            form: Form::Schedule,
            targets: OneOrMany::default(),
            max_correction_m: m_from_mm(0.01 * buckets as f64),
            max_correction_rad: 0.0,
            mid_path: PathDeviation::Unknown,
            error_m: None,
        };
        if kept.contains(&i) {
            let keep = rapid_program::motion::SkipReason {
                code: "keep::test",
                reason: "the test says so".into(),
                because: None,
            };
            planned.status = Status::Kept(Arc::new(keep));
        } else {
            let by = |k: usize| 0.01 * (k as f64 + 1.0) + tool(motion);
            let target = |target: &Target| PlannedTarget {
                pose: None,
                nominal_q_rad: [0.0; 6],
                conditions: None,
                corrections: Corrections::InBuckets((0..buckets).map(|k| moved(target, by(k))).collect()),
            };
            planned.targets = motion.targets.iter().map(target).collect();
        }
        planned
    });
    Plan {
        motions: motions.collect(),
        schedule: schedule(buckets),
        temperature_c: None,
        functions: None,
        live: None,
        summary: Summary::default(),
        diagnostics: Vec::new(),
    }
}

pub fn schedule(buckets: usize) -> Schedule {
    let bucket = |k: usize| Bucket {
        from_min: 10.0 * k as f64,
        to_min: (k + 1 < buckets).then_some(10.0 * (k as f64 + 1.0)),
        at_min: 10.0 * k as f64 + 5.0,
    };
    Schedule { buckets: (0..buckets).map(bucket).collect(), parts_per_min: 1 }
}

/// A target so many mm further up, or so many degrees further on.
fn moved(target: &Target, by: f64) -> Corrected {
    match target.value().unwrap() {
        TargetValue::Rob(rob) => {
            let q = rob.object_from_tcp.rotation;
            let mut position_m: [f64; 3] = rob.object_from_tcp.translation.vector.into();
            position_m[2] += m_from_mm(by);
            Corrected::Pose { position_m, orientation_wxyz: [q.w, q.i, q.j, q.k] }
        }
        TargetValue::Joint(joint) => {
            Corrected::Joints { q_rad: joint.q_rad.map(|q| q.unwrap() + rad_from_deg(by)) }
        }
        TargetValue::FromJoints(_) => unreachable!("not made here"),
    }
}
