//! Diffs, tables, messages, JSON: what people and scripts read of a plan.
//!
//! Computes nothing: every figure comes from the plan; here it gets its unit and its place. Knows nothing
//! of files and terminals: everything is written to a [`std::io::Write`].

pub mod accuracy;
mod cause_rows;
pub mod changed;
mod comparison;
mod comparison_figures;
mod comparison_lines;
pub mod diagnosis;
mod diff;
pub mod fit;
mod inspect;
mod joints;
mod json;
mod message;
mod motion_rows;
mod page;
pub mod plan;
pub mod plots;
pub mod rapid_data;
#[cfg(feature = "mcap")]
mod recording;
pub mod restored;
mod review;
mod short_diff;
pub mod simulation;
pub mod state;
mod svg;
mod table;
pub mod tabulation;
pub mod validation;

pub(crate) use comparison::Compared;
pub use diff::{Cut, write_created, write_edits, write_texts};
pub use inspect::{inspection, write_inspection, write_inspection_csv};
pub use joints::{JointRow, JointTable};
pub use json::{CompensationJson, messages, refusal, rounded};
pub use message::{ColorMode, LocatedDiagnostic, write_message, write_messages};
pub use motion_rows::MotionRows;
#[cfg(feature = "link")]
pub use page::WatchPage;
pub use page::{CompensationPage, DiagnosisPage, Page, ResultPage, SourceReview, write_page};
pub use rapid_syntax::diagnostic::{counted, plural};
#[cfg(feature = "mcap")]
pub use recording::{LoggedCorrection, Recording, RecordingMoment, urdf};
pub use review::{Review, write_review, write_verdict};
pub use short_diff::{ShortDiff, write_coloured};
pub use table::{Align, Table};
