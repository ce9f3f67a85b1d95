//! A double and a client for it.

use robot_link::{Credentials, Dialect, Host, LinkError, Pins, Session, Settings};
use rws_double::{Double, Holder, Options, Personality};
use std::time::Duration;

/// A module with data of a corrected program.
pub(crate) const MODULE: &str = "MODULE Part\n  ! driftpost 0.1.0 made this module\n  TASK PERS num tcMode:=-1;\n  TASK PERS num tcMinute:=64.7;\n\
    \x20 LOCAL PERS num tcState{6}:=[0,0,0,0,0,0];\n  LOCAL VAR string tcSaid:=\"\";\n  PERS string tcNote:=\"a\";\nENDMODULE\n";

/// A double that takes requests as fast as they come.
pub(crate) fn double(personality: Personality) -> Double {
    let double = Double::start(&Options { least_gap: Duration::ZERO, ..Options::new(personality) }).unwrap();
    double.with(|c| c.load(MODULE, "ProgMod"));
    double
}

/// A client that asks as fast as it can.
pub(crate) fn hasty() -> Settings {
    Settings {
        pace: Duration::ZERO,
        deadline: Duration::from_millis(400),
        long_deadline: Duration::from_millis(400),
        operator_deadline: Duration::from_millis(50),
        ..Settings::default()
    }
}

pub(crate) fn user() -> Credentials {
    Credentials::new("Default User", "robotics")
}

pub(crate) fn open_with(double: &Double, settings: &Settings) -> Result<Session, LinkError> {
    Session::open(&Host::parse(&double.root()).unwrap(), &user(), &mut Pins::in_memory(), settings)
}

pub(crate) fn open(double: &Double) -> Session {
    open_with(double, &hasty()).unwrap()
}

pub(crate) fn dialect(personality: Personality) -> Dialect {
    match personality {
        Personality::Rw6 => Dialect::Rw6,
        Personality::Rw7 => Dialect::Rw7,
        Personality::Rw8 => Dialect::Rw8,
    }
}

/// What must hold of a double when its client has gone.
pub(crate) fn is_left_clean(double: &Double) {
    assert_eq!(double.hits(), Vec::<String>::new(), "nothing that could move the robot");
    assert_eq!(double.too_fast(), 0, "no request too soon");
    assert_eq!(double.sessions(), 0, "logged out:\n{}", double.requests().join("\n"));
    let holder = double.with(|c| c.holder.clone());
    assert!(!matches!(holder, Holder::Session(..)), "no right held:\n{}", double.requests().join("\n"));
}

/// Runs `test` for each personality side by side: most of it is waiting for answers that do not come.
pub(crate) fn of_each(test: fn(Personality)) {
    std::thread::scope(|scope| {
        Personality::ALL.iter().for_each(|personality| drop(scope.spawn(|| test(*personality))));
    });
}
