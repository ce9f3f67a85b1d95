//! What `link push` has done, or would do, as scripts read it.

use super::loading::Loading;
use super::module_upload::ModuleUpload;
use serde_json::{Value, json};

/// What stands in the controller's HOME under a file's name.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum HomeFile {
    /// HOME has no file of the name.
    New,
    /// The file is there, byte for byte.
    Same,
    /// A file of the name is there and holds something else.
    Other,
}

/// What was sent, where it was found, and what became of it.
#[derive(Debug, Default)]
pub struct PushReport {
    /// For each module what HOME had under its file's name.
    pub home: Vec<HomeFile>,
    /// The files that were not there already are written.
    pub is_written: bool,
    /// The task has the modules.
    pub is_loaded: bool,
    /// Minute of the warm-up clock in the modules that went.
    pub minute_before: Option<String>,
}

impl PushReport {
    /// Whether HOME had all of the files, byte for byte.
    #[must_use]
    pub fn is_same(&self) -> bool {
        self.home.iter().all(|home| *home == HomeFile::Same)
    }

    /// What scripts read; `loading`: what the task was found to have, where it was asked.
    #[must_use]
    pub fn json(&self, modules: &[ModuleUpload], loading: Option<&Loading>) -> Value {
        let one = |(position, (module, home)): (usize, (&ModuleUpload, &HomeFile))| {
            let in_home = match home {
                HomeFile::New => "new",
                HomeFile::Same => "same",
                HomeFile::Other => "other",
            };
            json!({
                "file": module.file,
                "module": module.module,
                "bytes": module.bytes.len(),
                "home": in_home,
                "written": self.is_written && *home != HomeFile::Same,
                "load": loading.and_then(|loading| loading.outcome(position)),
                "loaded": self.is_loaded,
            })
        };
        let all: Vec<Value> = modules.iter().zip(&self.home).enumerate().map(one).collect();
        json!({
            "task": loading.map(|loading| &loading.task),
            "modules": all,
            "warm_up_minute_before": self.minute_before.as_ref().and_then(|minute| minute.parse::<f64>().ok()),
        })
    }
}
