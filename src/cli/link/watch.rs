//! `driftpost link watch`: state, bucket or share, minute and messages of corrected programs, as they change.

use super::connection::Connection;
use crate::cli::number::positive;
use crate::cli::{Console, Outcome};
use driftpost::application::OwnData;
use rapid_syntax::diagnostic::Diagnostic;
use robot_link::{Event, LinkError, Session, Subscription};
use std::time::{Duration, Instant};

/// How long an event is waited for at a time, so that an interruption is seen.
const MOMENT: Duration = Duration::from_millis(200);
/// As many failures one after the other end it.
const MOST_FAILURES: u32 = 5;

/// Options of `link watch`.
#[derive(Debug, clap::Args)]
pub struct Args {
    /// The host, who logs in, and how its certificate is pinned.
    #[command(flatten)]
    connection: Connection,

    /// Seconds between two looks.
    #[arg(long, value_name = "S", default_value_t = 1.0)]
    interval_s: f64,

    /// Let the controller tell of changes, where it offers that, and look only then.
    #[arg(long)]
    subscribe: bool,

    /// A JSON object in each line, with the seconds since the start.
    #[arg(long)]
    json: bool,

    /// End after so many lines; without it Ctrl-C does.
    #[arg(long, value_name = "N")]
    count: Option<u64>,
}

/// Runs `link watch`.
///
/// # Errors
/// `link::*`; no corrected program is loaded.
pub fn run(args: &Args, console: &mut Console) -> anyhow::Result<Outcome> {
    positive(&[("--interval-s", Some(args.interval_s))])?;
    let mut session = args.connection.open(console)?;
    let mut own = Vec::new();
    for task in session.tasks()? {
        let modules = session.modules(&task.name)?;
        own.extend(OwnData::of_task(&mut session, &task.name, &modules)?);
    }
    if own.is_empty() {
        let text = "no corrected program is loaded";
        return Err(Diagnostic::error("link::no-data", text)
            .help("`link info` lists tasks and modules")
            .into());
    }
    let mut subscription = if args.subscribe { subscribe(&own, &mut session, console) } else { None };
    let (start, mut failures) = (Instant::now(), 0);
    let mut lines = 0;
    loop {
        match own.iter_mut().try_for_each(|own| own.read_again(&mut session)) {
            Ok(()) => {
                failures = 0;
                lines += write(args, &own, start, console)?;
            }
            Err(LinkError::Interrupted) => break,
            Err(error) if failures < MOST_FAILURES => {
                failures += 1;
                console.say(format_args!("warning: {error}"));
            }
            Err(error) => return Err(error.into()),
        }
        if args.count.is_some_and(|count| lines >= count)
            || next(args, &mut subscription, &session, console).is_err()
        {
            break;
        }
    }
    if let Some(subscription) = subscription {
        // Closing the socket ends it as well.
        let _ = session.unsubscribe(subscription);
    }
    session.end()?;
    Ok(Outcome::Done)
}

fn write(args: &Args, own: &[OwnData], start: Instant, console: &mut Console) -> std::io::Result<u64> {
    for own in own {
        if args.json {
            let mut object = own.json();
            object["t_s"] = ((start.elapsed().as_secs_f64() * 10.0).round() / 10.0).into();
            writeln!(console.out(), "{object}")?;
        } else {
            writeln!(console.out(), "{}/{}: {}", own.task, own.module, own.line())?;
        }
    }
    console.out().flush()?;
    Ok(own.len() as u64)
}

fn subscribe(own: &[OwnData], session: &mut Session, console: &mut Console) -> Option<Subscription> {
    let all = own.iter().flat_map(|own| {
        own.values.iter().map(|(name, _)| (own.task.clone(), own.module.clone(), name.clone()))
    });
    let all: Vec<_> = all.collect();
    match session.subscribe(&all) {
        Ok(subscription) => Some(subscription),
        Err(error) => {
            console.say(format_args!(
                "note: no subscription ({error}); looking every second or as --interval-s says"
            ));
            None
        }
    }
}

/// Waits for the next look.
fn next(
    args: &Args,
    subscription: &mut Option<Subscription>,
    session: &Session,
    console: &mut Console,
) -> Result<(), LinkError> {
    let Some(open) = subscription else { return session.wait(Duration::from_secs_f64(args.interval_s)) };
    loop {
        match open.next(MOMENT) {
            Event::Changed => return Ok(()),
            Event::Nothing if session.is_stopped() => return Err(LinkError::Interrupted),
            Event::Nothing => {}
            Event::Ended(why) => {
                console.say(format_args!("note: the controller ended the subscription ({why}); looking by --interval-s from here on"));
                *subscription = None;
                return Ok(());
            }
        }
    }
}
