//! `driftpost link watch`: state, bucket or share, minute and messages of corrected programs, as they change.

use super::connection::Connection;
use crate::application::EmittedState;
use crate::cli::number::positive;
use crate::cli::page::ReportArgs;
use crate::cli::{Console, Outcome, files};
use crate::report::WatchPage;
use rapid_syntax::diagnostic::Diagnostic;
use robot_link::{DataName, Event, LinkError, Session, Subscription};
use std::path::PathBuf;
use std::time::{Duration, Instant, SystemTime};

/// How long an event is waited for at a time, so that an interruption is seen.
const MOMENT: Duration = Duration::from_millis(200);
/// As many failures one after the other end it.
const MOST_FAILURES: u32 = 5;

/// The page is written anew so often, seconds, and at once where something changed.
const PAGE_EVERY_S: f64 = 5.0;

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

    /// A page of it, written anew while it goes on, which loads itself anew.
    #[command(flatten)]
    page: ReportArgs,
}

/// Runs `link watch`.
///
/// # Errors
/// `link::*`; no corrected program is loaded.
pub fn run(args: &Args, console: &mut Console) -> anyhow::Result<Outcome> {
    positive(&[("--interval-s", Some(args.interval_s))])?;
    // whether it can be written is known before anybody is asked for a password
    drop(args.page.open()?);
    let mut session = args.connection.open(console)?;
    let mut own = Vec::new();
    for task in session.tasks()? {
        let modules = session.modules(&task.name)?;
        own.extend(EmittedState::of_task(&mut session, &task.name, &modules)?);
    }
    if own.is_empty() {
        let text = "no corrected program is loaded";
        return Err(Diagnostic::error("link::no-data", text)
            .help("`link info` lists tasks and modules")
            .into());
    }
    let mut subscription = if args.subscribe { subscribe(&own, &mut session, console) } else { None };
    let mut watch = Watch {
        start: Instant::now(),
        page: args.page.report.clone().map(|path| LivePage::new(path, args.connection.host.clone())),
    };
    let watched = watch_values(args, &mut own, &mut session, &mut subscription, &mut watch, console);
    let why = watched
        .as_ref()
        .err()
        .map_or_else(|| "The watch has ended.".to_owned(), |error| format!("The watch has ended: {error}"));
    watch.end(why)?;
    watched?;
    if let Some(subscription) = subscription {
        // Closing the socket ends it as well.
        let _ = session.unsubscribe(subscription);
    }
    session.end()?;
    Ok(Outcome::Done)
}

/// Looks again and again, until it is interrupted or has seen enough.
fn watch_values(
    args: &Args,
    own: &mut [EmittedState],
    session: &mut Session,
    subscription: &mut Option<Subscription>,
    watch: &mut Watch,
    console: &mut Console,
) -> anyhow::Result<()> {
    let (mut lines, mut failures) = (0, 0);
    loop {
        match own.iter_mut().try_for_each(|own| own.read_again(session)) {
            Ok(()) => {
                failures = 0;
                lines += watch.write(args, own, console)?;
            }
            Err(LinkError::Interrupted) => return Ok(()),
            Err(error) if failures < MOST_FAILURES => {
                failures += 1;
                console.note(format_args!("warning: {error}"));
                watch.warn(&error)?;
            }
            Err(error) => return Err(error.into()),
        }
        if args.count.is_some_and(|count| lines >= count)
            || next(args, subscription, session, console).is_err()
        {
            return Ok(());
        }
    }
}

/// What is written of each look.
struct Watch {
    start: Instant,
    page: Option<LivePage>,
}

impl Watch {
    /// Tenths of a second since the start.
    fn t_s(&self) -> f64 {
        (self.start.elapsed().as_secs_f64() * 10.0).round() / 10.0
    }

    fn write(&mut self, args: &Args, own: &[EmittedState], console: &mut Console) -> anyhow::Result<u64> {
        let t_s = self.t_s();
        let record = |own: &EmittedState| {
            let mut object = own.json();
            object["t_s"] = t_s.into();
            object
        };
        for own in own {
            if args.json {
                writeln!(console.out(), "{}", record(own))?;
            } else {
                writeln!(console.out(), "{}/{}: {}", own.task, own.module, own.line())?;
            }
        }
        console.out().flush()?;
        if let Some(page) = &mut self.page {
            let is_news = page.content.add(own.iter().map(record).collect());
            page.write(is_news)?;
        }
        Ok(own.len() as u64)
    }

    fn warn(&mut self, error: &LinkError) -> anyhow::Result<()> {
        let t_s = self.t_s();
        let Some(page) = &mut self.page else { return Ok(()) };
        page.content.warn(t_s, error.to_string());
        page.write(true)
    }

    fn end(self, why: String) -> anyhow::Result<()> {
        let Some(mut page) = self.page else { return Ok(()) };
        page.content.ended = Some(why);
        page.write(true)
    }
}

/// A page that is put in its place again and again, whole each time.
struct LivePage {
    path: PathBuf,
    content: WatchPage,
    written: Option<Instant>,
}

impl LivePage {
    fn new(path: PathBuf, host: String) -> Self {
        Self { path, content: WatchPage::new(host), written: None }
    }

    /// Writes it where that is due, or `at_once`.
    fn write(&mut self, at_once: bool) -> anyhow::Result<()> {
        let is_due = self.written.is_none_or(|at| at.elapsed().as_secs_f64() >= PAGE_EVERY_S);
        if !(is_due || at_once) {
            return Ok(());
        }
        let now = SystemTime::now().duration_since(SystemTime::UNIX_EPOCH).map_or(0.0, |d| d.as_secs_f64());
        let mut text = Vec::new();
        self.content.write(now, PAGE_EVERY_S, &mut text)?;
        files::Pending::new(&self.path)?.write(&text)?;
        self.written = Some(Instant::now());
        Ok(())
    }
}

fn subscribe(own: &[EmittedState], session: &mut Session, console: &mut Console) -> Option<Subscription> {
    let all = own.iter().flat_map(|own| {
        own.values.iter().map(|(name, _)| DataName {
            task: own.task.clone(),
            module: own.module.clone(),
            name: name.clone(),
        })
    });
    let all: Vec<_> = all.collect();
    match session.subscribe(&all) {
        Ok(subscription) => Some(subscription),
        Err(error) => {
            console.note(format_args!(
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
                console.note(format_args!("note: the controller ended the subscription ({why}); looking by --interval-s from here on"));
                *subscription = None;
                return Ok(());
            }
        }
    }
}
