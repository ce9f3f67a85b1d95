//! Diffs, tables, messages, JSON: what people and scripts read of a plan.
//!
//! Jobs write themselves ([`application`](crate::application)). What else is shown stands here: messages, differences of texts, what a
//! program holds, plans of measurements, data to paste into a controller, pages of results.
//!
//! Computes nothing: every figure comes from the plan; here it gets its unit and its place. Knows nothing
//! of files and terminals: everything is written to a [`std::io::Write`].

pub(crate) mod accuracy;
mod cause_rows;
pub(crate) mod changed;
mod comparison;
mod comparison_figures;
mod comparison_lines;
pub(crate) mod diagnosis;
mod diff;
pub(crate) mod fit;
mod inspect;
mod joints;
mod json;
mod message;
mod motion_rows;
mod page;
pub mod plan;
pub(crate) mod plots;
pub mod rapid_data;
#[cfg(feature = "mcap")]
mod recording;
pub(crate) mod restored;
mod review;
mod short_diff;
pub(crate) mod simulation;
pub(crate) mod state;
mod svg;
mod table;
pub(crate) mod tabulation;
pub(crate) mod validation;

#[cfg(feature = "mcap")]
pub use self::recording::{Recording, urdf};
pub use diff::{Cut, write_texts};
pub use inspect::{inspection, write_inspection, write_inspection_csv};
pub use json::golden_json;
pub use message::{ColorMode, LocatedDiagnostic, write_messages};
#[cfg(feature = "link")]
pub use page::WatchPage;
pub use page::{Page, ResultPage, SourceReview, write_page};
pub use short_diff::{ShortDiff, write_coloured};

pub(crate) use comparison::Compared;
pub(crate) use diff::{write_created, write_edits};
pub(crate) use joints::{JointRow, JointTable};
pub(crate) use json::{CompensationJson, refusal, rounded};
pub(crate) use motion_rows::MotionRows;
pub(crate) use page::{CompensationPage, DiagnosisPage};
pub(crate) use rapid_syntax::diagnostic::{counted, plural};
#[cfg(feature = "mcap")]
pub(crate) use recording::{LoggedCorrection, RecordingMoment};
pub(crate) use review::{Review, write_review, write_verdict};
pub(crate) use table::{Align, Table};
