//! Modules loaded and unloaded while the program runs.

use super::Known;
use crate::call::Args;
use crate::controller::Controller;
use crate::outcome::{Fault, fatal, raise};
use crate::value::{Type, Value};

/// The last part of a path in lower case: the disk of this controller has no folders.
pub(crate) fn file_name(path: &str) -> String {
    path.rsplit(['/', '\\', ':']).next().unwrap_or(path).to_lowercase()
}

impl Controller {
    fn path_argument(&mut self, args: &Args<'_>, at: usize) -> Result<String, Fault> {
        let path = self.eval_as(args.at(at)?, &Type::Str)?;
        let file = match args.named("file") {
            Some(e) => Some(self.eval_as(e, &Type::Str)?),
            None => None,
        };
        let whole = file.as_ref().unwrap_or(&path);
        Ok(file_name(whole.string().unwrap_or_default()))
    }

    fn load_file(&mut self, file: &str) -> Result<(), Fault> {
        let Some(bytes) = self.disk.get(file).cloned() else {
            return raise("err_filnotfnd", format!("there is no file {file}"));
        };
        if self.memory.modules.iter().any(|m| m.loaded && m.dynamic.as_deref() == Some(file)) {
            return raise("err_loaded", format!("{file} is loaded already"));
        }
        match self.load_as(file, &bytes, Some(file)) {
            Ok(_) => Ok(()),
            Err(why) => raise("err_syntax", format!("{file} does not load: {why}")),
        }
    }

    fn unload_file(&mut self, file: &str) -> Result<(), Fault> {
        let loaded: Vec<usize> = self
            .memory
            .modules
            .iter()
            .enumerate()
            .filter(|(_, m)| m.loaded && m.dynamic.as_deref() == Some(file))
            .map(|(id, _)| id)
            .collect();
        if loaded.is_empty() || self.frames.iter().any(|f| loaded.contains(&f.module)) {
            return raise("err_unload", format!("{file} cannot be unloaded: not loaded, or in execution"));
        }
        loaded.into_iter().for_each(|id| self.memory.unload(id));
        Ok(())
    }

    pub(crate) fn module_instruction(&mut self, name: &str, args: &Args<'_>) -> Known<()> {
        match name {
            "load" => {
                let file = self.path_argument(args, 0)?;
                self.load_file(&file)?;
            }
            "startload" => {
                let file = self.path_argument(args, 0)?;
                if !self.disk.contains_key(&file) {
                    return raise("err_filnotfnd", format!("there is no file {file}"));
                }
                let Some((place, _)) = self.place(args.at(1)?)? else {
                    return fatal("StartLoad wants a variable of type loadsession");
                };
                self.sessions.push(Some(file));
                let session = Value::num(self.sessions.len() as f64);
                self.write(&place, session)?;
            }
            "waitload" => {
                if let Some(e) = args.named("unloadfile").or_else(|| args.named("unloadpath")) {
                    let old = self.eval_as(e, &Type::Str)?;
                    self.unload_file(&file_name(old.string().unwrap_or_default()))?;
                }
                let session = self.eval_num(args.at(0)?)?;
                let file = self.sessions.get_mut((session as usize).wrapping_sub(1)).and_then(Option::take);
                match file {
                    Some(file) => self.load_file(&file)?,
                    None => return raise("err_loadno_nouse", "WaitLoad of a session that is not in use"),
                }
            }
            "cancelload" => {
                let session = self.eval_num(args.at(0)?)?;
                let file = self.sessions.get_mut((session as usize).wrapping_sub(1)).and_then(Option::take);
                if file.is_none() {
                    return raise("err_loadno_nouse", "CancelLoad of a session that is not in use");
                }
            }
            "unload" => {
                let file = self.path_argument(args, 0)?;
                self.unload_file(&file)?;
            }
            "checkprogref" => {}
            _ => return Ok(None),
        }
        Ok(Some(()))
    }

    pub(crate) fn module_function(&mut self, name: &str, args: &Args<'_>) -> Known<Value> {
        match name {
            "isfile" => {
                let file = self.path_argument(args, 0)?;
                Ok(Some(Value::Bool(self.disk.contains_key(&file))))
            }
            "modexist" => {
                let module = self.eval_as(args.at(0)?, &Type::Str)?;
                let module = module.string().unwrap_or_default().to_owned();
                let loaded =
                    self.memory.modules.iter().any(|m| m.loaded && m.name.eq_ignore_ascii_case(&module));
                Ok(Some(Value::Bool(loaded)))
            }
            _ => Ok(None),
        }
    }
}
