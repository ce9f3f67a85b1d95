//! The corrections of a motion that goes to one of a few targets: beside each of them the pose by which it is known.

use super::checksum;
use super::correction::write_correction;
use super::insertion::LayoutStyle;
use super::row_hash::RowHash;
use super::target::MAX_LINE;
use crate::compensate::plan::Correction;
use crate::emit::record_text::{write_orient, write_pos};
use nalgebra::Isometry3;

/// An array of poses: a row a target, its own pose first, then its correction at the node of each function of time.
#[derive(Clone, Debug)]
pub(super) struct ChoiceData {
    /// The name of the data.
    pub name: String,
    /// The name of the hash that tells a target's row.
    pub hash_name: String,
    /// Where each target stands in its work object, and its corrections.
    pub rows: Vec<(Isometry3<f64>, Vec<Correction>)>,
}

impl ChoiceData {
    /// Which row a target is.
    #[must_use]
    pub(super) fn hash(&self) -> RowHash {
        let poses: Vec<Isometry3<f64>> = self.rows.iter().map(|(pose, _)| *pose).collect();
        RowHash::of(&poses)
    }

    /// Whether it is the same under another name.
    #[must_use]
    pub(super) fn is_same(&self, other: &Self) -> bool {
        self.rows == other.rows
    }

    /// Appends the declaration; gives what it is recognised by.
    #[must_use]
    pub(super) fn write(&self, out: &mut Vec<u8>, style: &LayoutStyle) -> Vec<u8> {
        let columns = self.rows.first().map_or(0, |(_, corrections)| corrections.len()) + 1;
        out.extend_from_slice(&style.indent);
        let head = format!("LOCAL CONST pose {}{{{},{columns}}}:=[", self.name, self.rows.len());
        out.extend_from_slice(head.as_bytes());
        let mut value = vec![b'['];
        for (k, (object_from_tcp, corrections)) in self.rows.iter().enumerate() {
            let mut parts: Vec<Vec<u8>> = vec![b"[[".to_vec()];
            let q = object_from_tcp.rotation.quaternion();
            write_pos(&mut parts[0], object_from_tcp.translation.vector.into());
            parts[0].push(b',');
            write_orient(&mut parts[0], [q.w, q.i, q.j, q.k]);
            parts[0].push(b']');
            for correction in corrections {
                let mut text = Vec::new();
                write_correction(&mut text, correction);
                parts.push(text);
            }
            let last = parts.len() - 1;
            let end: &[u8] = if k + 1 < self.rows.len() { b"]," } else { b"]];" };
            let mut column = MAX_LINE;
            for (n, mut part) in parts.into_iter().enumerate() {
                part.extend_from_slice(if n < last { b"," } else { end });
                style.push_part(out, &mut column, &part, MAX_LINE - 1);
                value.extend_from_slice(&part);
            }
        }
        value.truncate(value.len().saturating_sub(1));
        out.extend_from_slice(style.eol);
        checksum::of_numbers(&value).to_vec()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_row_is_a_target_with_its_correction() {
        let correction = Correction::Pose { shift_m: [1e-4, 0.0, 0.0], turn: [0.0, 0.0, -0.001] };
        let at = |x_m: f64| (Isometry3::translation(x_m, 0.0, 0.25), vec![correction]);
        let data =
            ChoiceData { name: "tcP".into(), hash_name: "tcPRow".into(), rows: vec![at(0.4), at(0.5)] };
        let style = LayoutStyle { eol: b"\n", indent: b"  ".to_vec(), unit: b"  ".to_vec() };
        let mut out = Vec::new();
        let checksums = data.write(&mut out, &style);
        let text = "  LOCAL CONST pose tcP{2,2}:=[
    [[[400,0,250],[1,0,0,0]],[[0.1,0,0],[1,0,0,-1E-3]]],
    [[[500,0,250],[1,0,0,0]],[[0.1,0,0],[1,0,0,-1E-3]]]];
";
        assert_eq!(String::from_utf8(out).unwrap(), text);
        let value = text.split_once(":=").unwrap().1.trim_end().trim_end_matches(';');
        assert_eq!(checksums, checksum::of_numbers(value.as_bytes()));
    }
}
