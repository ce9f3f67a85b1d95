//! A virtual controller with the emitted routines in a small module of targets.

use nalgebra::{Isometry3, Quaternion, Translation3, UnitQuaternion};
use rapid_compensation::emit::live::{Cap, Function, LiveModel, TestTarget};
use robot_model::deform::DeformedArm;
use robot_model::kinematics::{Chain, ClosedForm, Configuration, FrameOffsets};
use robot_model::robot::Robot;
use virtual_controller::{Controller, Effort, Value};

const CUBE: &str = include_str!("../../../fixtures/robodk/irc5/Cube45.mod");
/// tool0 and wobj0, as PERS of the module.
pub const TOOL0: &str = "[TRUE,[[0,0,0],[1,0,0,0]],[2,[0,0,15],[1,0,0,0],0,0,0.005]]";

/// How far a pose is from another.
#[derive(Clone, Copy, Debug, Default)]
pub struct Off {
    pub mm: f64,
    pub deg: f64,
}

impl Off {
    pub fn max(self, other: Self) -> Self {
        Self { mm: self.mm.max(other.mm), deg: self.deg.max(other.deg) }
    }

    pub fn between(a: &Isometry3<f64>, b: &Isometry3<f64>) -> Self {
        // The vector of the quaternion: exact where the angle is tiny.
        let turn = (a.rotation.inverse() * b.rotation).into_inner().imag().norm();
        Self {
            mm: 1000.0 * (a.translation.vector - b.translation.vector).norm(),
            deg: (2.0 * turn.min(1.0).asin()).to_degrees(),
        }
    }
}

/// 1 mm, 0.5 degrees, 1 degree of a joint.
pub fn cap() -> Cap {
    Cap { shift_m: 1e-3, turn_rad: 0.5_f64.to_radians(), joint_rad: 1.0_f64.to_radians() }
}

/// A table by one function of time.
pub fn table(offsets: &FrameOffsets) -> Vec<Function> {
    vec![Function { offsets: *offsets, shape: None }]
}

/// All numbers of a RAPID aggregate, as a `num` holds them.
pub fn numbers(text: &str) -> Vec<f64> {
    let words = text.split(|c: char| !c.is_ascii_alphanumeric() && !"+-.".contains(c));
    words.filter_map(|word| word.parse::<f32>().ok()).map(f64::from).collect()
}

/// The pose at the head of a robtarget's numbers.
pub fn pose(n: &[f64]) -> Isometry3<f64> {
    Isometry3::from_parts(
        Translation3::new(n[0] / 1000.0, n[1] / 1000.0, n[2] / 1000.0),
        UnitQuaternion::from_quaternion(Quaternion::new(n[3], n[4], n[5], n[6])),
    )
}

pub fn configuration(n: &[f64]) -> Configuration {
    Configuration { cf1: n[7] as i32, cf4: n[8] as i32, cf6: n[9] as i32, cfx: n[10] as i32 }
}

pub fn q_rad(degrees: &[f64]) -> [f64; 6] {
    std::array::from_fn(|i| degrees[i].to_radians())
}

/// The robtargets of the cube, as written.
pub fn cube_targets() -> Vec<String> {
    let moves = CUBE.lines().filter_map(|line| line.trim().strip_prefix("MoveL "));
    moves.map(|rest| rest.split(",rdkSpeed").next().unwrap().to_owned()).collect()
}

fn frames(tool: &str, wobj: Option<&str>) -> [Isometry3<f64>; 2] {
    let object = wobj.map_or_else(Isometry3::identity, |text| {
        let n = numbers(text);
        pose(&n) * pose(&n[7..])
    });
    [pose(&numbers(tool)), object]
}

/// Targets at joints within the ranges, away from singularities; a seed each.
pub fn at(robot: &Robot, count: usize, tool: &str, wobj: Option<&str>, seed: u32) -> Vec<String> {
    let [tool, object] = frames(tool, wobj);
    let closed = ClosedForm::new(robot).unwrap();
    let mut state = u64::from(seed) * 7919 + 1;
    let mut unit = || {
        state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        (state >> 40) as f64 / f64::from(1_u32 << 24)
    };
    let mut targets = Vec::new();
    while targets.len() < count {
        let mut q_rad: [f64; 6] = std::array::from_fn(|i| {
            let [low, high] = robot.joints[i].range_rad.unwrap_or([-2.0, 2.0]);
            let (low, high) = (low.max(-2.5) + 0.1, high.min(2.5) - 0.1);
            low + (high - low) * unit()
        });
        q_rad[1] *= 0.5;
        q_rad[2] *= 0.5;
        let base_from_flange = Chain::nominal(robot).forward(&q_rad);
        let found = closed.nearest(&base_from_flange, &q_rad);
        let posture_is_good = q_rad[4].abs() > 0.3
            && base_from_flange.translation.vector.xy().norm() > 0.15
            && found.is_some_and(|s| s.squared_distance(&q_rad) < 1e-12);
        if !posture_is_good {
            continue;
        }
        let p = object.inverse() * base_from_flange * tool;
        let (t, r) = (p.translation.vector * 1000.0, p.rotation);
        let c = closed.configuration(&q_rad);
        let text = format!(
            "[[{},{},{}],[{},{},{},{}],[{},{},{},{}],[10,9E9,9E9,9E9,9E9,-20]]",
            t.x as f32,
            t.y as f32,
            t.z as f32,
            r.w as f32,
            r.i as f32,
            r.j as f32,
            r.k as f32,
            c.cf1,
            c.cf4,
            c.cf6,
            c.cfx
        );
        let exact = |text: &str| !text.contains('e');
        if exact(&text)
            && closed.solutions(&base_from_flange).iter().filter(|s| closed.agrees(&c, &s.q_rad)).count() == 1
        {
            targets.push(text);
        }
    }
    targets
}

/// A controller in which targets can be asked for.
pub struct Cell {
    pub controller: Controller,
    pub robot: Robot,
    pub tool: Isometry3<f64>,
    pub object: Isometry3<f64>,
    targets: Vec<String>,
    closed: ClosedForm,
}

impl Cell {
    /// The cube of 45 as it is programmed.
    pub fn cube(model: &LiveModel, robot: &str) -> Self {
        Self::cube_with(model, robot, &[])
    }

    pub fn cube_with(model: &LiveModel, robot: &str, tests: &[TestTarget]) -> Self {
        let wobj = "[FALSE,TRUE,\"\",[[0,0,0],[1,0,0,0]],[[0,0,0],[1,0,0,0]]]";
        Self::with(model, &Robot::built_in(robot).unwrap(), &cube_targets(), TOOL0, Some(wobj), tests)
    }

    pub fn new(model: &LiveModel, robot: &Robot, targets: &[String], tool: &str, wobj: Option<&str>) -> Self {
        Self::with(model, robot, targets, tool, wobj, &[])
    }

    fn with(
        model: &LiveModel,
        robot: &Robot,
        targets: &[String],
        tool: &str,
        wobj: Option<&str>,
        tests: &[TestTarget],
    ) -> Self {
        let with = wobj.map_or("tT", |_| "tT\\WObj:=wW");
        let closed = ClosedForm::new(robot).unwrap();
        let [tool_frame, object] = frames(tool, wobj);
        let joints = targets.iter().map(|text| {
            let n = numbers(text);
            let flange = object * pose(&n) * tool_frame.inverse();
            let found =
                closed.solutions(&flange).into_iter().find(|s| closed.agrees(&configuration(&n), &s.q_rad));
            let q = found.unwrap().q_rad.map(|q| (q.to_degrees() as f32).to_string());
            format!("[[{}],[10,9E9,9E9,9E9,9E9,-20]]", q.join(","))
        });
        let count = targets.len();
        let functions: String =
            (1..=model.functions()).map(|r| format!("  LOCAL VAR num tcF{r}:=0;\n")).collect();
        let text = format!(
            "MODULE L\n{functions}{data}\n  PERS tooldata tT:={tool};\n  PERS wobjdata wW:={object_data};\n\
             \x20 CONST robtarget p{{{count}}}:=[{list}];\n  CONST jointtarget j{{{count}}}:=[{joints}];\n\
             \x20 VAR robtarget r{{{count}}};\n  VAR jointtarget js{{{count}}};\n{module}\
             \x20 PROC run()\n    FOR i FROM 1 TO {count} DO\n      r{{i}}:=tcLive(p{{i}},{with});\n    ENDFOR\n  ENDPROC\n\
             \x20 PROC runJ()\n    FOR i FROM 1 TO {count} DO\n      js{{i}}:=tcLiveJ(j{{i}},{with});\n    ENDFOR\n  ENDPROC\n\
             \x20 PROC moves()\n    FOR i FROM 1 TO {count} DO\n      MoveJ tcLiveSame(p{{i}},{with}),v100,fine,{with};\n    ENDFOR\n  ENDPROC\n\
             \x20 PROC teach()\n    MoveAbsJ j{{k}},v100,fine,tT;\n    tcTeach given,{with};\n    is:=tcLive(given,{with});\n\
             \x20   plainly:=CRobT(\\Tool:={with});\n  ENDPROC\n{routines}\nENDMODULE\n",
            data = model.data(tests).join("\n"),
            object_data = wobj.unwrap_or("[FALSE,TRUE,\"\",[[0,0,0],[1,0,0,0]],[[0,0,0],[1,0,0,0]]]"),
            list = targets.join(",\n"),
            joints = joints.collect::<Vec<_>>().join(",\n"),
            module = match model.has_offsets_of_time() {
                true => include_str!("cell.mod")
                    .replace("tcUpdates:=tcUpdates+1;", "tcUpdates:=tcUpdates+1;\n    tcOffsets;"),
                false => include_str!("cell.mod").to_owned(),
            },
            routines = model.routines(tests).join("\n"),
        );
        let mut controller = Controller::with_robot(robot).unwrap();
        controller.load("l.mod", text.as_bytes()).unwrap();
        Self { controller, robot: robot.clone(), tool: tool_frame, object, targets: targets.to_vec(), closed }
    }

    pub fn set(&mut self, name: &str, value: f32) {
        self.controller.set(name, Value::Num(value)).unwrap();
    }

    pub fn call(&mut self, routine: &str) {
        let outcome = self.controller.call(routine, 1).unwrap();
        assert!(outcome.is_good(), "{routine}: {outcome:?}");
        assert_eq!(self.controller.unknown_instructions(), Vec::<String>::new());
    }

    /// The most that a call of `tcLive` takes for any of the targets, the clock's update apart.
    pub fn effort(&mut self) -> Effort {
        self.call("run");
        self.controller.take_efforts();
        self.call("moves");
        let asked = self.controller.take_efforts()["tcLiveSame"];
        assert_eq!(asked.calls as usize, self.targets.len());
        asked.most
    }

    pub fn asked(&mut self) -> Vec<Vec<f64>> {
        self.targets.iter().map(|text| numbers(text)).collect()
    }

    pub fn answers(&mut self) -> Vec<Vec<f64>> {
        self.list("r")
    }

    pub fn joints(&mut self, name: &str) -> Vec<Vec<f64>> {
        self.list(name)
    }

    pub fn joints_of(&mut self, name: &str) -> Vec<f64> {
        self.controller.value(name).unwrap().numbers()
    }

    pub fn target(&mut self, name: &str) -> Vec<f64> {
        self.controller.value(name).unwrap().numbers()
    }

    fn list(&mut self, name: &str) -> Vec<Vec<f64>> {
        self.controller.value(name).unwrap().parts().iter().map(Value::numbers).collect()
    }

    /// The nominal joints of a target, nearest to others.
    pub fn joints_for(&self, target: &[f64], near: &[f64; 6]) -> [f64; 6] {
        let flange = self.object * pose(target) * self.tool.inverse();
        self.closed.nearest(&flange, near).unwrap().q_rad
    }

    /// Asks for all targets and says how far from them `arm` stands at the nominal joints of the answers.
    pub fn worst(&mut self, arm: &DeformedArm) -> Off {
        self.worst_under(arm, &Default::default())
    }

    pub fn worst_under(&mut self, arm: &DeformedArm, conditions: &robot_model::deform::Conditions) -> Off {
        self.call("run");
        let (asked, answers, joints) = (self.asked(), self.answers(), self.joints("j"));
        let mut worst = Off::default();
        for ((asked, answer), joints) in asked.iter().zip(&answers).zip(&joints) {
            assert_eq!(asked[7..], answer[7..], "configuration and external axes stay");
            let q_rad = self.joints_for(answer, &q_rad(joints));
            let stands = self.object.inverse() * arm.under(conditions).forward(&q_rad) * self.tool;
            worst = worst.max(Off::between(&pose(asked), &stands));
        }
        worst
    }
}
