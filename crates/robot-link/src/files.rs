//! Files in HOME: read, and written whole; nothing is deleted, and no folder is entered.

use crate::form::Filling;
use crate::requests;
use crate::{Dialect, LinkError, Session, names};

/// A file in HOME.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct RemoteFile {
    /// Its name, without the folder.
    pub name: String,
    /// Bytes, where the controller says.
    pub size: Option<u64>,
}

/// What HOME may be called in an address.
const HOMES: [&str; 2] = ["$HOME", "HOME"];

impl Session {
    /// What HOME is called here; RobotWare 7 and 8 differ, so it is asked once.
    pub(crate) fn home(&mut self) -> Result<&'static str, LinkError> {
        if let Some(home) = self.home {
            return Ok(home);
        }
        let mut last = None;
        let candidates = if self.dialect == Dialect::Rw6 { &HOMES[..1] } else { &HOMES[..] };
        for home in candidates {
            match self.ask(requests::LIST, &[("home", home)]) {
                Ok(_) => {
                    self.home = Some(home);
                    return Ok(home);
                }
                Err(error) if error.is_not_there() => last = Some(error),
                Err(error) => return Err(error),
            }
        }
        Err(last.unwrap_or(LinkError::Value("the controller has no HOME".to_owned())))
    }

    /// The files directly in HOME.
    ///
    /// # Errors
    /// No or an incomplete answer.
    pub fn files(&mut self) -> Result<Vec<RemoteFile>, LinkError> {
        let home = self.home()?;
        let mut found = Vec::new();
        for page in self.pages(requests::LIST, &[("home", home)])? {
            for file in page.all("fs-file") {
                let size = file.optional("fs-size").and_then(|size| size.parse().ok());
                found.push(RemoteFile { name: file.title().to_owned(), size });
            }
        }
        Ok(found)
    }

    /// The bytes of a file in HOME; `None` where there is none.
    ///
    /// # Errors
    /// No or an incomplete answer.
    pub fn file(&mut self, name: &str) -> Result<Option<Vec<u8>>, LinkError> {
        let home = self.home()?;
        match self.ask(requests::FILE, &[("home", home), ("file", names::file(name)?)]) {
            Ok(answer) => Ok(Some(answer.body)),
            Err(error) if error.is_not_there() => Ok(None),
            Err(error) => Err(error),
        }
    }

    /// Writes a file into HOME and reads it back.
    ///
    /// # Errors
    /// A refusal; [`LinkError::Different`] where what is there is not what was sent, [`LinkError::Uncertain`] where that cannot be
    /// read.
    pub fn write_file(&mut self, name: &str, bytes: &[u8]) -> Result<(), LinkError> {
        let home = self.home()?;
        let filling = Filling {
            arguments: &[("home", home), ("file", names::file(name)?)],
            file: Some(bytes),
            ..Filling::default()
        };
        let written = self.send(requests::WRITE_FILE, filling).map(drop);
        if let Err(error @ LinkError::Refused { .. }) = written {
            return Err(error);
        }
        match (written, self.file(name)) {
            (_, Ok(Some(found))) if found == bytes => Ok(()),
            (_, Ok(Some(found))) => {
                let same = found.iter().zip(bytes).take_while(|(a, b)| a == b).count();
                let found = format!("{} bytes, the first {same} as sent, of {}", found.len(), bytes.len());
                Err(LinkError::Different { what: name.to_owned(), found })
            }
            (_, Ok(None)) => {
                Err(LinkError::Different { what: name.to_owned(), found: "there is no such file".to_owned() })
            }
            (Err(error), Err(_)) => Err(error),
            (Ok(()), Err(cause)) => {
                Err(LinkError::Uncertain { request: requests::WRITE_FILE.name, cause: cause.to_string() })
            }
        }
    }
}
