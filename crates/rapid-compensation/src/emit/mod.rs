//! A plan in, edits over the source and bytes out; and the way back.
//!
//! What an emitted program keeps to: every token that is not the target of a compensated motion stays as
//! it is. Added are one comment block after the MODULE line, data after the module's last data, and routines
//! before ENDMODULE; no statement. The motion asks for its target: a function in its argument knows the time.
//! Declarations of the source are never edited. Knows nothing of how the plan was found.

mod added;
mod aggregate;
mod array_reader;
mod asks;
mod change;
mod checksum;
mod choice;
mod clock;
mod context;
mod core_module;
mod correction;
mod declarations;
mod digest;
mod elements;
mod emission;
mod header;
mod header_text;
mod here;
mod hidden;
mod identity;
mod insertion;
pub mod live;
mod mentions;
mod mode;
mod module;
mod names;
mod not_written;
mod options;
mod originals;
mod point;
mod record_text;
mod restore;
mod row_hash;
mod scale;
mod scopes;
mod six_digits;
mod target;
mod touch;

pub use digest::is_as_written;
pub use emission::{compensated_at, emit, emit_each};
pub use header::{CommonModule, common_module, made_with, renamed};
pub use identity::{Difference, Undeclared, WithoutAdded};
pub use mode::HeldMode;
pub use not_written::NotWritten;
pub use options::{
    Clock, Core, DriftGrowth, EmitError, EmitOptions, EmittedFile, Provenance, Sensor, routines_to_call,
};
pub use record_text::{write_orient, write_pos};
pub use restore::{
    AddedToProgram, Altered, ModifiedIn, ModifiedTarget, RestoreError, Restored, altered_core, core_names,
    restore, restore_beside,
};
pub use touch::{MAX_AMOUNT, Touch, TouchBy, TouchFrames};
