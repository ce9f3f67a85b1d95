//! Data: read, written, refused.

use crate::bench::{double, is_left_clean, of_each, open};
use robot_link::{DataKind, LinkError, Property, Session};
use rws_double::{Double, Fault, Holder, Operator, Personality};

fn set(session: &mut Session, name: &str, value: &str) -> Result<(), LinkError> {
    session.with_right(&mut |_| {}, |session| session.set_value("T_ROB1", "Part", name, value))
}

fn mode_of(double: &Double) -> String {
    double.with(|c| c.value("Part", "tcMode").unwrap())
}

#[test]
fn a_number_is_written_read_back_and_the_right_given_back() {
    for personality in Personality::ALL {
        let double = double(personality);
        let mut session = open(&double);
        let property = session.property("T_ROB1", "Part", "tcMode").unwrap().unwrap();
        let expected = Property {
            kind: DataKind::Persistent,
            data_type: "num".into(),
            dimensions: 0,
            is_read_only: false,
            is_local: false,
        };
        assert_eq!(property, expected);
        assert_eq!(session.property("T_ROB1", "Part", "tcNone").unwrap(), None);
        assert_eq!(session.value("T_ROB1", "Part", "tcMinute").unwrap(), "64.7");
        set(&mut session, "tcMode", "20").unwrap();
        assert_eq!(session.value("T_ROB1", "Part", "tcMode").unwrap(), "20");
        assert_eq!(double.with(|c| c.holder.clone()), Holder::Nobody);
        set(&mut session, "tcState{2}", "0.5").unwrap();
        assert_eq!(session.value("T_ROB1", "Part", "tcState").unwrap(), "[0,0.5,0,0,0,0]");
        set(&mut session, "tcNote", "\"warm \"\"b\"\"\"").unwrap();
        assert_eq!(double.with(|c| c.value("Part", "tcNote").unwrap()), "\"warm \"\"b\"\"\"");
        session.end().unwrap();
        is_left_clean(&double);
    }
}

#[test]
fn what_data_cannot_take_never_reaches_the_controller() {
    for personality in Personality::ALL {
        let double = double(personality);
        let mut session = open(&double);
        for (name, value) in [
            ("tcMode", "TRUE"),
            ("tcSaid", "\"a\""),
            ("tcNone", "1"),
            ("tcNote", "\"a\"b\""),
            ("tcState", "[1,2]"),
        ] {
            assert_eq!(set(&mut session, name, value).unwrap_err().code(), "link::value", "{name}");
        }
        session.end().unwrap();
        assert!(
            !double.requests().iter().any(|r| r.starts_with("POST") && r.contains("/symbol/")),
            "{:?}",
            double.requests()
        );
        is_left_clean(&double);
    }
}

#[test]
fn who_stands_in_the_way_is_said() {
    for personality in Personality::ALL {
        let double = double(personality);
        let mut session = open(&double);
        double.with(|c| c.holder = Holder::Pendant);
        let held = set(&mut session, "tcMode", "20").unwrap_err().code();
        assert_eq!(held, if personality == Personality::Rw8 { "link::station" } else { "link::held" });
        double.with(|c| c.holder = Holder::Nobody);
        double.with(|c| c.has_grants = false);
        assert_eq!(set(&mut session, "tcMode", "20").unwrap_err().code(), "link::grant");
        double.with(|c| c.has_grants = true);
        if personality == Personality::Rw8 {
            double.with(|c| c.remote_access_is_off = true);
            assert_eq!(set(&mut session, "tcMode", "20").unwrap_err().code(), "link::station");
        }
        assert_eq!(mode_of(&double), "-1");
        session.end().unwrap();
        is_left_clean(&double);
    }
}

#[test]
fn in_manual_mode_the_operator_decides() {
    for personality in [Personality::Rw6, Personality::Rw7] {
        let double = double(personality);
        double.with(|c| c.mode = "MANR");
        let mut session = open(&double);
        let mut notices = Vec::new();
        session
            .with_right(&mut |text| notices.push(text.to_owned()), |session| {
                session.set_value("T_ROB1", "Part", "tcMode", "20")
            })
            .unwrap();
        assert!(notices[0].contains("on the pendant"), "{notices:?}");
        for operator in [Operator::Denies, Operator::Silent] {
            double.with(|c| c.operator = operator);
            assert_eq!(set(&mut session, "tcMode", "19").unwrap_err().code(), "link::operator");
        }
        assert_eq!(mode_of(&double), "20");
        session.end().unwrap();
        is_left_clean(&double);
    }
}

#[test]
fn a_right_that_a_write_has_cleared_is_no_error() {
    let double = double(Personality::Rw8);
    double.with(|c| c.write_clears_right = true);
    let mut session = open(&double);
    set(&mut session, "tcMode", "20").unwrap();
    session.end().unwrap();
    is_left_clean(&double);
}

/// The fault meets the write alone.
fn at_write(fault: Fault) -> rws_double::Plan {
    let mut pending = Some(fault);
    Box::new(move |seen, _| {
        let is_write = seen.method == "POST" && seen.uri.contains("/symbol/");
        if is_write { pending.take() } else { None }
    })
}

#[test]
fn a_write_is_sent_once_and_called_done_only_when_it_is_there() {
    of_each(|personality| {
        let double = double(personality);
        let mut session = open(&double);
        for (n, (fault, is_done)) in [
            (Fault::DropAfter, true),
            (Fault::Stall(1000), true),
            (Fault::CutBody, true),
            (Fault::DropBefore, false),
            (Fault::Unavailable, false),
            (Fault::ErrorInside, false),
            (Fault::SessionLost, false),
            (Fault::PendantTakes, false),
        ]
        .into_iter()
        .enumerate()
        {
            double.plan(at_write(fault));
            let before = mode_of(&double);
            let ended = set(&mut session, "tcMode", &n.to_string());
            assert_eq!(ended.is_ok(), is_done, "{personality} {fault:?}: {ended:?}");
            assert_eq!(mode_of(&double), if is_done { n.to_string() } else { before }, "{fault:?}");
            double.with(|c| c.holder = Holder::Nobody);
        }
        session.end().unwrap();
        let written =
            double.requests().iter().filter(|r| r.starts_with("POST") && r.contains("/symbol/")).count();
        assert_eq!(written, 8, "each once");
        is_left_clean(&double);
    });
}

#[test]
fn a_turned_key_is_told() {
    let double = double(Personality::Rw7);
    let mut session = open(&double);
    let mut is_written = false;
    double.plan(Box::new(move |seen, _| {
        let turns =
            std::mem::replace(&mut is_written, seen.method == "POST" && seen.uri.contains("/symbol/"));
        turns.then_some(Fault::ModeTurned("MANR"))
    }));
    assert_eq!(set(&mut session, "tcMode", "20").unwrap_err().code(), "link::mode-changed");
    session.end().unwrap();
    is_left_clean(&double);
}

#[test]
fn changes_are_told_by_subscription() {
    use robot_link::{DataName, Event};
    use std::time::Duration;
    for personality in Personality::ALL {
        let double = double(personality);
        double.with(|c| c.foreign_location = true);
        let mut session = open(&double);
        let [task, module, name] = ["T_ROB1", "Part", "tcMinute"].map(str::to_owned);
        let watched = [DataName { task, module, name }];
        let mut subscription = session.subscribe(&watched).unwrap();
        // The present value first, then each change, and nothing between.
        assert_eq!(subscription.next(Duration::from_secs(2)), Event::Changed);
        assert_eq!(subscription.next(Duration::from_millis(100)), Event::Nothing);
        double.with(|c| c.run_sets("Part", "tcMinute", "65"));
        assert_eq!(subscription.next(Duration::from_secs(2)), Event::Changed);
        assert_eq!(session.value("T_ROB1", "Part", "tcMinute").unwrap(), "65");
        session.unsubscribe(subscription).unwrap();
        double.with(|c| c.offers_subscriptions = false);
        assert!(session.subscribe(&watched).is_err());
        session.end().unwrap();
        assert_eq!(double.subscriptions(), 0);
        is_left_clean(&double);
    }
}
