//! The table of requests: everything that a [`Session`](crate::Session) can send, and nothing else.
//!
//! A form is `METHOD PATH?QUERY FIELDS`; what stands in braces is filled in, checked and encoded, by the caller. Nothing here
//! starts, stops, jogs, moves the program pointer, switches motors, changes a configuration or restarts; a test holds the table
//! against a list of its own.

use crate::Dialect;

/// What a request does to the controller.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Effect {
    /// Nothing: it is read.
    Reads,
    /// Changes nothing: the controller calculates.
    Calculates,
    /// Begins or ends what belongs to this session alone: login, subscription, register of stations.
    Session,
    /// Takes the right to write.
    TakesRight,
    /// Gives a right to write back.
    GivesRightBack,
    /// Writes a file into HOME.
    WritesFile,
    /// Writes a value into persistent data.
    WritesData,
    /// Loads a module into a stopped program.
    Loads,
    /// Takes a module out of a stopped program.
    Unloads,
}

impl Effect {
    /// Whether it must never be sent twice.
    #[must_use]
    pub fn is_write(self) -> bool {
        !matches!(self, Self::Reads | Self::Calculates | Self::GivesRightBack)
    }
}

/// One request in each dialect.
#[derive(Debug)]
pub struct Request {
    /// What it is called in messages.
    pub name: &'static str,
    /// What it does to the controller.
    pub effect: Effect,
    /// Its form in RobotWare 6, 7 and 8; `None` where there is none.
    pub forms: [Option<&'static str>; 3],
}

impl Request {
    /// Its form in a dialect.
    #[must_use]
    pub fn form(&self, dialect: Dialect) -> Option<&'static str> {
        match dialect {
            Dialect::Rw6 => self.forms[0],
            Dialect::Rw7 => self.forms[1],
            Dialect::Rw8 => self.forms[2],
        }
    }
}

/// The same form in all dialects.
const fn all(form: &'static str) -> [Option<&'static str>; 3] {
    [Some(form), Some(form), Some(form)]
}

/// A form of RobotWare 6, and one of 7 and 8.
const fn two(six: &'static str, seven: &'static str) -> [Option<&'static str>; 3] {
    [Some(six), Some(seven), Some(seven)]
}

/// Declares the requests and the list of all of them.
macro_rules! requests {
    ($($id:ident $name:literal $effect:ident $forms:expr;)*) => {
        $(pub(crate) const $id: &Request = &Request { name: $name, effect: Effect::$effect, forms: $forms };)*
        /// Every request that can be sent.
        pub const ALL: &[&Request] = &[$($id),*];
    };
}

requests! {
    SYSTEM "system" Reads all("GET /rw/system");
    OPTIONS "options" Reads all("GET /rw/system/options");
    ROBOT_TYPE "robot type" Reads all("GET /rw/system/robottype");
    CONTROLLER "controller" Reads all("GET /ctrl/identity");
    MODE "operating mode" Reads all("GET /rw/panel/opmode");
    MOTORS "state of the motors" Reads two("GET /rw/panel/ctrlstate", "GET /rw/panel/ctrl-state");
    EXECUTION "state of execution" Reads all("GET /rw/rapid/execution");
    TASKS "tasks" Reads all("GET /rw/rapid/tasks");
    MODULES "modules" Reads two("GET /rw/rapid/modules?task={task}", "GET /rw/rapid/tasks/{task}/modules");
    MOTION "motion system" Reads all("GET /rw/motionsystem");
    JOINTS_NOW "joints of the arm" Reads all("GET /rw/motionsystem/mechunits/{unit}/jointtarget");
    POSE_NOW "pose of the arm" Reads
        all("GET /rw/motionsystem/mechunits/{unit}/robtarget?tool=tool0&wobj=wobj0&coordinate=Base");
    CODE_TEXT "text of a code" Reads all("GET /rw/retcode?code={code}");

    FORWARD "forward kinematics" Calculates two(
        "POST /rw/motionsystem/mechunits/{unit}?action=CalcPoseFromJoints rob_joints={joints}&ext_joints={external}\
         &tool_frame_position={tool_position}&tool_frame_orientation={tool_orientation}&robot_fixed_object=FALSE\
         &elog_at_error=FALSE",
        "POST /rw/motionsystem/mechunits/{unit}/pose-from-joints rob_joints={joints}&ext_joints={external}\
         &tool_frame_position={tool_position}&tool_frame_orientation={tool_orientation}&robot_fixed_object=FALSE\
         &elog_at_error=FALSE",
    );
    INVERSE "inverse kinematics" Calculates two(
        "POST /rw/motionsystem/mechunits/{unit}?action=JointsFromCartesian curr_position={position}\
         &curr_orientation={orientation}&curr_ext_joints={external}&old_rob_joints={near}&old_ext_joints={external}\
         &robot_configuration={configuration}&tool_frame_position={tool_position}\
         &tool_frame_orientation={tool_orientation}&robot_fixed_object=FALSE&elog_at_error=FALSE",
        "POST /rw/motionsystem/mechunits/{unit}/joints-from-cartesian curr_position={position}\
         &curr_orientation={orientation}&curr_ext_joints={external}&old_rob_joints={near}&old_ext_joints={external}\
         &robot_configuration={configuration}&tool_frame_position={tool_position}\
         &tool_frame_orientation={tool_orientation}&robot_fixed_object=FALSE&elog_at_error=FALSE",
    );
    SOLUTIONS "all joint solutions" Calculates two(
        "POST /rw/motionsystem/mechunits/{unit}?action=AllJointSolutions curr_position={position}\
         &curr_orientation={orientation}&curr_ext_joints={external}&robot_configuration={configuration}\
         &tool_frame_position={tool_position}&tool_frame_orientation={tool_orientation}&robot_fixed_object=FALSE",
        "POST /rw/motionsystem/mechunits/{unit}/all-joints-solution curr_position={position}\
         &curr_orientation={orientation}&curr_ext_joints={external}&robot_configuration={configuration}\
         &tool_frame_position={tool_position}&tool_frame_orientation={tool_orientation}&robot_fixed_object=FALSE",
    );

    VALUE "value of data" Reads two(
        "GET /rw/rapid/symbol/data/RAPID/{task}/{module}/{name}",
        "GET /rw/rapid/symbol/RAPID/{task}/{module}/{name}/data",
    );
    PROPERTIES "properties of data" Reads two(
        "GET /rw/rapid/symbol/properties/RAPID/{task}/{module}/{name}",
        "GET /rw/rapid/symbol/RAPID/{task}/{module}/{name}/properties",
    );
    SET_VALUE "write of data" WritesData two(
        "POST /rw/rapid/symbol/data/RAPID/{task}/{module}/{name}?action=set value={value}",
        "POST /rw/rapid/symbol/RAPID/{task}/{module}/{name}/data value={value}",
    );

    DISKS "disks" Reads all("GET /fileservice");
    RESOURCES "software resources" Reads all("GET /rw/devices/SW_RESOURCES");
    RESOURCE "a software resource" Reads all("GET /rw/devices/SW_RESOURCES/{device}");
    RESOURCE_PART "part of a software resource" Reads all("GET /rw/devices/SW_RESOURCES/{device}/{part}");

    LIST "list of HOME" Reads all("GET /fileservice/{home}");
    FILE "file" Reads all("GET /fileservice/{home}/{file}");
    WRITE_FILE "write of a file" WritesFile all("PUT /fileservice/{home}/{file}");
    LOAD "load of a module" Loads two(
        "POST /rw/rapid/tasks/{task}?action=loadmod modulepath={home}/{file}&replace=false",
        "POST /rw/rapid/tasks/{task}/loadmod modulepath={home}/{file}&replace=false",
    );
    UNLOAD "unload of a module" Unloads two(
        "POST /rw/rapid/tasks/{task}?action=unloadmod module={module}",
        "POST /rw/rapid/tasks/{task}/unloadmod module={module}",
    );

    TAKE "request for the right to write" TakesRight [
        Some("POST /rw/mastership/rapid?action=request"),
        Some("POST /rw/mastership/edit/request"),
        Some("POST /rw/controlstation/writeaccess/request"),
    ];
    GIVE_BACK "release of the right to write" GivesRightBack [
        Some("POST /rw/mastership/rapid?action=release"),
        Some("POST /rw/mastership/edit/release"),
        Some("POST /rw/controlstation/writeaccess/release"),
    ];
    HOLDER "holder of the right to write" Reads [
        Some("GET /rw/mastership/rapid"),
        Some("GET /rw/mastership/edit"),
        Some("GET /rw/controlstation/writeaccess/status"),
    ];
    STATION "register of control stations" Session [
        None,
        None,
        Some("POST /rw/controlstation/register/remote control-station-name={name}&control-station-id={id}&pincode={pincode}"),
    ];
    ASK_OPERATOR "request to the operator" TakesRight
        [Some("POST /users/rmmp privilege=modify"), Some("POST /users/rmmp privilege=modify"), None];
    OPERATOR_SAYS "answer of the operator" Reads [Some("GET /users/rmmp/poll"), Some("GET /users/rmmp/poll"), None];
    ASK_NO_MORE "end of the request to the operator" GivesRightBack
        [Some("POST /users/rmmp?action=cancel"), Some("POST /users/rmmp/cancel"), None];

    SUBSCRIBE "subscription" Session all("POST /subscription {resources}");
    UNSUBSCRIBE "end of the subscription" Session all("DELETE /subscription/{group}");
    EVENTS "websocket of events" Session all("GET /poll/{group}");
    LOGOUT "logout" Session all("GET /logout");
}
