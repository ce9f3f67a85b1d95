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
mod comparison_rows;
mod controller_data;
mod cut_lines;
pub(crate) mod diagnosis;
mod diagnosis_sections;
mod diff;
pub(crate) mod fit;
mod inspect;
mod joints;
mod json;
mod message;
mod motion_rows;
mod notes;
mod page;
pub(crate) mod plan;
pub(crate) mod plots;
pub(crate) mod rapid_data;
#[cfg(feature = "mcap")]
mod recording;
pub(crate) mod restored;
mod review;
#[cfg(feature = "cli")]
mod short_diff;
pub(crate) mod simulation;
pub(crate) mod state;
mod svg;
mod table;
pub(crate) mod tabulation;
pub(crate) mod validation;

#[cfg(feature = "mcap")]
pub use self::recording::Recording;
pub use controller_data::{ControllerData, ControllerDataError, Declaration};
pub use message::{ColorMode, LocatedDiagnostic, write_messages};
pub use page::{Page, ResultPage, SourceReview, write_page};

pub(crate) use comparison::Compared;
#[cfg(all(feature = "cli", feature = "link"))]
pub(crate) use cut_lines::Cut;
#[cfg(feature = "cli")]
pub(crate) use diff::write_texts;
pub(crate) use diff::{write_created, write_edits};
pub(crate) use inspect::{inspection, write_inspection, write_inspection_csv};
pub(crate) use joints::{JointRow, JointTable};
pub(crate) use json::{CompensationJson, refusal, rounded, value, write_pretty};
#[cfg(feature = "cli")]
pub(crate) use json::{golden_json, messages};
pub(crate) use motion_rows::MotionRows;
pub(crate) use notes::notes;
#[cfg(all(feature = "cli", feature = "link"))]
pub(crate) use page::WatchPage;
pub(crate) use page::{CompensationPage, DiagnosisPage};
pub(crate) use rapid_syntax::diagnostic::{counted, plural};
#[cfg(feature = "mcap")]
pub(crate) use recording::{LoggedCorrection, RecordingMoment};
pub(crate) use review::{Review, auto_corrects, write_review, write_verdict};
#[cfg(feature = "cli")]
pub(crate) use short_diff::{ShortDiff, write_coloured};
pub(crate) use table::{Align, Table};
