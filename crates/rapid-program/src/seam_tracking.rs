//! Welds that follow their seam (`\Track`): where the torch goes between and behind their targets a sensor says, not the program.

use super::index::Index;
use super::motion_site::MotionSites;
use super::move_instructions::Special;
use rapid_syntax::diagnostic::{Diagnostic, Span};

/// One warning for all welds of a program that follow their seam, at the first of them.
pub(super) fn warning(index: &Index<'_>, sites: &MotionSites<'_>) -> Option<Diagnostic> {
    let tracks = sites.motions.iter().filter(|site| {
        site.form.special == Special::Plain && site.form.has_seam() && site.args(index).has("track")
    });
    let mut found: Vec<(Span, &'static str)> = tracks
        .map(|site| (Span { file: site.ctx(index).file, range: site.stmt.range }, site.form.name))
        .collect();
    sorting::by_key(&mut found, |(at, _)| *at);
    let (at, name) = found.first()?;
    let more = match found.len() {
        1 => String::new(),
        2 => ", and one more weld does".to_owned(),
        n => format!(", and {} more welds do", n - 1),
    };
    let text = format!(
        "{name} follows its seam (\\Track){more}: the sensor moves the path, by the arm's drift too, and the figures hold for the targets alone"
    );
    let help = "the correction brings the torch to where the search for the seam begins; where the sensor's offsets are handed on to other \
                motion, keep these welds (--keep)";
    Some(Diagnostic::warning("path::seam-tracking", text).at(*at).help(help))
}
