//! Who asks which controller: host, user, password, and the file of controllers that are known.

use crate::cli::{Console, interrupt};
use robot_link::{Credentials, Host, LinkError, Pins, Session, Settings};
use std::io::{self, IsTerminal};
use std::path::PathBuf;
use std::process::Command;
use std::sync::Arc;
use std::sync::atomic::AtomicBool;

/// The password that controllers are delivered with, as ABB's manuals print it.
const DELIVERED: &str = "robotics";

/// Environment variables that hold the login.
const PASSWORD: &str = "DRIFTPOST_LINK_PASSWORD";
const PASSWORD_COMMAND: &str = "DRIFTPOST_LINK_PASSWORD_COMMAND";
const PINCODE: &str = "DRIFTPOST_LINK_PINCODE";
const KNOWN: &str = "DRIFTPOST_LINK_KNOWN";

/// Options of all that ask a controller.
#[derive(Debug, clap::Args)]
pub struct Connection {
    /// The controller: NAME, NAME:PORT, http://NAME (IRC5) or https://NAME (OmniCore).
    #[arg(value_name = "HOST")]
    pub host: String,

    /// User at the controller. The password comes from DRIFTPOST_LINK_PASSWORD, from the command in
    /// DRIFTPOST_LINK_PASSWORD_COMMAND (a keyring's), or from a prompt; RobotWare 8's pin code from DRIFTPOST_LINK_PINCODE.
    #[arg(long, value_name = "USER", default_value = "Default User")]
    pub user: String,

    /// File of controllers as they were seen first; as a rule DRIFTPOST_LINK_KNOWN, or driftpost/known_controllers in the
    /// user's configuration.
    #[arg(long, value_name = "FILE")]
    pub known: Option<PathBuf>,
}

impl Connection {
    /// Logs in. From here on an interruption ends the session in order.
    ///
    /// # Errors
    /// [`LinkError`].
    pub fn open(&self, console: &mut Console) -> anyhow::Result<Session> {
        let host = Host::parse(&self.host)?;
        let credentials = Credentials::new(&self.user, self.password(&host)?);
        let mut pins = match self.known_file() {
            Some(path) => Pins::of_file(&path)?,
            None => Pins::in_memory(),
        };
        let stop = Arc::new(AtomicBool::new(false));
        interrupt::hand_over(&stop);
        let settings = Settings { stop, pincode: std::env::var(PINCODE).ok(), ..Settings::default() };
        let opened =
            console.while_busy("logging in", || Session::open(&host, &credentials, &mut pins, &settings));
        let mut session = opened?;
        session.notices().iter().for_each(|notice| console.note(format_args!("note: {notice}")));
        Ok(session)
    }

    fn known_file(&self) -> Option<PathBuf> {
        let set = |name: &str| std::env::var_os(name).filter(|value| !value.is_empty()).map(PathBuf::from);
        let configuration = || {
            set("XDG_CONFIG_HOME").or_else(|| set("APPDATA")).or_else(|| Some(set("HOME")?.join(".config")))
        };
        let own = || Some(configuration()?.join("driftpost").join("known_controllers"));
        self.known.clone().or_else(|| set(KNOWN)).or_else(own)
    }

    fn password(&self, host: &Host) -> anyhow::Result<String> {
        if let Ok(password) = std::env::var(PASSWORD) {
            return Ok(password);
        }
        if let Ok(command) = std::env::var(PASSWORD_COMMAND) {
            return of_command(&command);
        }
        if io::stdin().is_terminal() && io::stderr().is_terminal() {
            let asked = format!(
                "Password of {} at {host} (Enter for the one that controllers are delivered with): ",
                self.user
            );
            let typed = rpassword::prompt_password(asked)?;
            return Ok(if typed.is_empty() { DELIVERED.to_owned() } else { typed });
        }
        Ok(DELIVERED.to_owned())
    }
}

/// The first line that a command prints, `secret-tool lookup service cell3`, say.
fn of_command(command: &str) -> anyhow::Result<String> {
    let (shell, option) = if cfg!(windows) { ("cmd", "/C") } else { ("sh", "-c") };
    let output = Command::new(shell).args([option, command]).output()?;
    let text = String::from_utf8(output.stdout).unwrap_or_default();
    let line = text.lines().next().unwrap_or_default();
    if !output.status.success() || line.is_empty() {
        let why = format!("the command of {PASSWORD_COMMAND} gives no password ({})", output.status);
        return Err(LinkError::Value(why).into());
    }
    Ok(line.to_owned())
}
