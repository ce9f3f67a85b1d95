//! Files of characters that a program writes: opened, added to, closed.
//!
//! Files that are read, and devices that are none (`com1:`), this controller does not have: what is asked of them is listed as
//! unknown and passed over.

use super::data::with_option;
use super::parameter::{Data, Instruction, Parameter, instruction, string};
use crate::interpreter::{Args, Interpreter};
use crate::machine::{Disk, MOST_FILE_BYTES};
use crate::outcome::{Fault, fatal, raise};
use crate::value::Value;

pub(super) const INSTRUCTIONS: &[Instruction] = &[
    instruction!("open", (object: String, device: Data), |vm, args| open(vm, args, &object, device)),
    instruction!("write", (device: f32, text: String), |vm, args| {
        let mut line = with_option(vm, args, text)?;
        if !args.has("nonewline") {
            line.push('\n');
        }
        let Some(file) = channel(vm, args, device) else { return Ok(()) };
        match file {
            Some(file) if !vm.machine.disk.protected => {
                // A string holds a character for each byte of the controller's text.
                if vm.machine.disk.written + line.len() > MOST_FILE_BYTES {
                    return vm.over_limit(format!("more than {MOST_FILE_BYTES} bytes are written to files"));
                }
                vm.machine.disk.written += line.len();
                let bytes = line.chars().map(|c| u8::try_from(c).unwrap_or(b'?'));
                vm.machine.disk.files.entry(file).or_default().extend(bytes);
                Ok(())
            }
            _ => raise("err_fileacc", "a file that cannot be written to"),
        }
    }),
    instruction!("close", (device: f32), |vm, args| {
        match channel(vm, args, device) {
            None => Ok(()),
            Some(Some(_)) => {
                let open = vm.machine.disk.channels.get_mut((device as usize).wrapping_sub(1));
                open.into_iter().for_each(|open| *open = None);
                Ok(())
            }
            Some(None) => raise("err_fileacc", "a file that is not open"),
        }
    }),
];

/// Open with `\Append` or `\Write`: what follows is added to the file, or takes the place of what it holds.
fn open(vm: &mut Interpreter<'_>, args: &Args<'_>, object: &str, device: Data) -> Result<(), Fault> {
    let Some((place, _)) = device else { return fatal("Open expects a variable of type iodev") };
    let name = match args.named("file") {
        Some(file) => string(vm, file)?,
        None => object.to_owned(),
    };
    let file = Disk::file_name(&name);
    if file.is_empty() || !(args.has("append") || args.has("write")) {
        vm.machine.log.unknown.insert(args.callee.to_string());
        return Ok(());
    }
    if vm.machine.disk.protected {
        return raise("err_fileopen", format!("{name} cannot be opened"));
    }
    let held = vm.machine.disk.files.entry(file.clone()).or_default();
    if args.has("write") {
        held.clear();
    }
    vm.machine.disk.channels.push(Some(file));
    let number = vm.machine.disk.channels.len();
    vm.write(&place, Value::num(number as f64))
}

/// The file of a device that a program has opened, `Some(None)` where it is closed; `None` for a device that this controller does
/// not have, which is listed.
fn channel(vm: &mut Interpreter<'_>, args: &Args<'_>, device: f32) -> Option<Option<String>> {
    let open = (device as usize).checked_sub(1).and_then(|at| vm.machine.disk.channels.get(at).cloned());
    if open.is_none() {
        vm.machine.log.unknown.insert(args.callee.to_string());
    }
    open
}
