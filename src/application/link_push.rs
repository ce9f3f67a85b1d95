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

/// What became of one module.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct PushedModule {
    /// What HOME had under its file's name.
    pub home: HomeFile,
    /// Its file was written, and read back the same.
    pub is_written: bool,
    /// The task has it from this run.
    pub is_loaded: bool,
}

/// What was sent, where it was found, and what became of it.
#[derive(Debug, Default)]
pub struct PushReport {
    /// One for each module that HOME was asked for, in their order.
    pub modules: Vec<PushedModule>,
    /// Minute of the warm-up clock in the modules that went.
    pub minute_before: Option<String>,
    /// Something was asked of the controller that changes it: from then on it may be another than it was found.
    pub has_begun: bool,
    /// Why the run ended early.
    pub error: Option<PushFailure>,
}

/// Why a run ended early.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct PushFailure {
    /// The message's code, where it has one.
    pub code: Option<&'static str>,
    /// The message in words.
    pub message: String,
}

impl PushReport {
    /// Counts in a module for which HOME had `home`.
    pub fn add(&mut self, home: HomeFile) {
        self.modules.push(PushedModule { home, is_written: false, is_loaded: false });
    }

    /// Whether HOME had all of the files, byte for byte.
    #[must_use]
    pub fn is_same(&self) -> bool {
        self.modules.iter().all(|module| module.home == HomeFile::Same)
    }

    /// What scripts read; `loading`: what the task was found to have, where it was asked.
    #[must_use]
    pub fn json(&self, modules: &[ModuleUpload], loading: Option<&Loading>) -> Value {
        let one = |(position, (module, pushed)): (usize, (&ModuleUpload, &PushedModule))| {
            let in_home = match pushed.home {
                HomeFile::New => "new",
                HomeFile::Same => "same",
                HomeFile::Other => "other",
            };
            json!({
                "file": module.file,
                "module": module.module,
                "bytes": module.bytes.len(),
                "home": in_home,
                "written": pushed.is_written,
                "load": loading.and_then(|loading| loading.outcome(position)),
                "loaded": pushed.is_loaded,
            })
        };
        let all: Vec<Value> = modules.iter().zip(&self.modules).enumerate().map(one).collect();
        json!({
            "task": loading.map(|loading| &loading.task),
            "modules": all,
            "warm_up_minute_before": self.minute_before.as_ref().and_then(|minute| minute.parse::<f64>().ok()),
            "error": self.error.as_ref().map(|error| json!({"code": error.code, "message": error.message})),
        })
    }
}
