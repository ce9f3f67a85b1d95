//! Login, cookies, pins, pace, ways out.

use crate::bench::{dialect, double, hasty, is_left_clean, of_each, open, open_with, user};
use robot_link::{Credentials, Execution, Host, LinkError, Mode, Pins, Session, Settings};
use rws_double::{Double, Fault, Options, Personality};
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};
use std::time::{Duration, Instant};

#[test]
fn a_controller_says_what_it_is_in_each_dialect() {
    for personality in Personality::ALL {
        let double = double(personality);
        let mut session = open(&double);
        assert_eq!(session.dialect(), dialect(personality));
        let identity = session.identity().unwrap();
        assert_eq!(identity.robot.as_deref(), Some("IRB 140-6/0.8"));
        assert!(identity.is_virtual && identity.options.iter().any(|o| o == "616-1 PC Interface"));
        assert_eq!((identity.mode, &identity.execution), (Mode::Auto, &Execution::Stopped));
        assert_eq!((identity.absolute_accuracy, identity.writer), (Some(false), None));
        let names: Vec<(&str, bool)> = identity.tasks.iter().map(|t| (t.name.as_str(), t.moves)).collect();
        assert_eq!(names, [("T_ROB1", true), ("T_BACK", false)]);
        let modules = session.modules("T_ROB1").unwrap();
        assert_eq!(modules.iter().map(|m| m.name.as_str()).collect::<Vec<_>>(), ["BASE", "Part"]);
        session.end().unwrap();
        assert_eq!(double.logouts(), 1);
        is_left_clean(&double);
    }
}

#[test]
fn what_is_left_of_memory_is_told_where_it_is_offered() {
    for personality in Personality::ALL {
        let double = double(personality);
        let mut session = open(&double);
        let left = session.free_memory().unwrap();
        let memory: Vec<_> =
            left.rapid.iter().map(|p| (p.name.as_str(), p.value.as_str(), p.unit.as_str())).collect();
        assert_eq!(memory, [("Total memory", "33554432", "bytes"), ("Free memory", "30408704", "bytes")]);
        let disks: Vec<_> =
            left.disks.iter().map(|d| (d.name.as_str(), d.free_bytes, d.total_bytes)).collect();
        // As ABB's manual of RobotWare 6 shows it; 7 and 8 list volumes without sizes.
        let of_six = [("hd0a", 873_164_800, Some(2_068_717_568))];
        assert_eq!(disks, if personality == Personality::Rw6 { &of_six[..] } else { &[] });
        double.with(|controller| controller.tells_memory = false);
        assert_eq!(session.free_memory().unwrap().rapid, []);
        session.end().unwrap();
        is_left_clean(&double);
    }
}

#[test]
fn a_session_that_is_dropped_logs_out_too() {
    for personality in Personality::ALL {
        let double = double(personality);
        drop(open(&double));
        assert_eq!(double.logouts(), 1);
        is_left_clean(&double);
    }
}

#[test]
fn the_pace_is_kept() {
    // As delivered: 50 ms between requests, and 55 ms of the client.
    let double = Double::start(&Options::new(Personality::Rw7)).unwrap();
    let start = Instant::now();
    let mut session = open_with(&double, &Settings::default()).unwrap();
    for _ in 0..10 {
        session.mode().unwrap();
    }
    session.end().unwrap();
    assert!(start.elapsed() >= Duration::from_millis(12 * 55), "{:?}", start.elapsed());
    is_left_clean(&double);
}

#[test]
fn one_login_serves_all_requests() {
    let double = double(Personality::Rw6);
    let mut session = open(&double);
    for _ in 0..100 {
        session.mode().unwrap();
    }
    assert_eq!(double.sessions(), 1);
    session.end().unwrap();
    assert_eq!(double.requests().iter().filter(|r| r.ends_with(" 401")).count(), 1);
    is_left_clean(&double);
}

#[test]
fn a_wrong_password_is_said_and_not_tried_again() {
    for personality in Personality::ALL {
        let double = double(personality);
        let host = Host::parse(&double.root()).unwrap();
        let wrong = Credentials::new("Default User", "secret-word");
        let error = Session::open(&host, &wrong, &mut Pins::in_memory(), &hasty()).unwrap_err();
        assert_eq!(error.code(), "link::login");
        assert!(!error.to_string().contains("secret-word"));
        assert_eq!(double.requests().len(), 2, "{:?}", double.requests());
    }
}

#[test]
fn sessions_that_are_all_taken_are_said() {
    let options = Options { least_gap: Duration::ZERO, sessions: 1, ..Options::new(Personality::Rw7) };
    let double = Double::start(&options).unwrap();
    let first = open(&double);
    assert_eq!(open_with(&double, &hasty()).unwrap_err(), LinkError::Full);
    first.end().unwrap();
    open(&double).end().unwrap();
}

#[test]
fn the_certificate_is_pinned_on_first_use() {
    let folder = std::env::temp_dir().join(format!("driftpost_link_{}", std::process::id()));
    let known = folder.join("known");
    let first =
        Double::start(&Options { least_gap: Duration::ZERO, ..Options::new(Personality::Rw7) }).unwrap();
    let host = Host::parse(&first.root()).unwrap();
    let port: u16 = first.root().rsplit_once(':').unwrap().1.parse().unwrap();
    let mut session = Session::open(&host, &user(), &mut Pins::of_file(&known).unwrap(), &hasty()).unwrap();
    assert!(session.notices()[0].starts_with("first time at 127.0.0.1"));
    session.end().unwrap();
    let mut session = Session::open(&host, &user(), &mut Pins::of_file(&known).unwrap(), &hasty()).unwrap();
    assert!(session.notices().is_empty());
    session.end().unwrap();
    drop(first);
    let options = Options {
        least_gap: Duration::ZERO,
        port,
        other_certificate: true,
        ..Options::new(Personality::Rw7)
    };
    let other = Double::start(&options).unwrap();
    let error = Session::open(&host, &user(), &mut Pins::of_file(&known).unwrap(), &hasty()).unwrap_err();
    assert_eq!(error.code(), "link::certificate");
    assert_eq!(other.requests(), Vec::<String>::new(), "no password, no request");
    std::fs::remove_dir_all(folder).unwrap();
}

#[test]
fn another_controller_at_the_same_address_is_refused() {
    let double = double(Personality::Rw6);
    let host = Host::parse(&double.root()).unwrap();
    let mut pins = Pins::in_memory();
    Session::open(&host, &user(), &mut pins, &hasty()).unwrap().end().unwrap();
    double.with(|c| c.system_id = "{FFFFFFFF-0000-4000-8000-00000000D0B1}".to_owned());
    let error = Session::open(&host, &user(), &mut pins, &hasty()).unwrap_err();
    assert_eq!(error.code(), "link::other-controller");
    is_left_clean(&double);
}

#[test]
fn a_lost_session_is_renewed_for_a_read_and_its_cookies_are_adopted() {
    for personality in Personality::ALL {
        let double = double(personality);
        let mut session = open(&double);
        for fault in [
            Fault::SessionLost,
            Fault::Restart,
            Fault::WrongCookies,
            Fault::Unavailable,
            Fault::DropBefore,
            Fault::WrongType,
        ] {
            let mut pending = Some(fault);
            double.plan(Box::new(move |_, _| pending.take()));
            assert_eq!(
                session.mode().unwrap_or_else(|e| panic!("{fault:?} {e} {:#?}", double.requests())),
                Mode::Auto,
                "{fault:?}"
            );
            assert_eq!(session.mode().unwrap(), Mode::Auto, "after {fault:?}");
        }
        session.end().unwrap();
        is_left_clean(&double);
    }
}

#[test]
fn a_cut_or_stalled_answer_is_an_error_in_time() {
    of_each(|personality| {
        let double = double(personality);
        let mut session = open(&double);
        for fault in [Fault::CutBody, Fault::Stall(2000), Fault::BrokenText, Fault::ErrorInside] {
            double.plan(Box::new(move |_, _| Some(fault)));
            let start = Instant::now();
            let error = session.mode().unwrap_err();
            assert!(start.elapsed() < Duration::from_millis(1500), "{fault:?}");
            assert!(["link::no-answer", "link::busy"].contains(&error.code()), "{fault:?}: {error}");
        }
        double.plan(Box::new(|_, _| None));
        session.end().unwrap();
    });
}

#[test]
fn a_list_that_never_ends_is_refused() {
    let double = double(Personality::Rw7);
    let mut session = open(&double);
    double.plan(Box::new(|_, _| Some(Fault::LoopingNext)));
    assert_eq!(session.modules("T_ROB1").unwrap_err().code(), "link::incomplete");
    assert!(double.requests().len() < 10);
}

#[test]
fn an_interruption_ends_the_work_and_gives_back() {
    for personality in Personality::ALL {
        let double = double(personality);
        let stop = Arc::new(AtomicBool::new(false));
        let mut session = open_with(&double, &Settings { stop: Arc::clone(&stop), ..hasty() }).unwrap();
        let ended = session.with_right(&mut |_| {}, |session| {
            stop.store(true, Ordering::Relaxed);
            session.mode()
        });
        assert_eq!(ended.unwrap_err(), LinkError::Interrupted);
        drop(session);
        is_left_clean(&double);
    }
}

#[test]
fn a_panic_gives_back_and_logs_out() {
    for personality in Personality::ALL {
        let double = double(personality);
        let mut session = open(&double);
        let ended = std::panic::catch_unwind(std::panic::AssertUnwindSafe(move || {
            session.with_right::<()>(&mut |_| {}, |_| panic!("on purpose"))
        }));
        assert!(ended.is_err());
        is_left_clean(&double);
    }
}
