//! What a stranger's file calls the columns that a column map makes ours of: messages about it name its own.

use super::column_names::{POINT, QUATERNION};
use std::collections::BTreeMap;

/// Our columns by the names that they have in a file of another layout.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct OwnNames {
    /// Our name and the file's.
    columns: BTreeMap<String, String>,
    /// The file's three angles, where it has them in the place of a quaternion.
    angles: Option<String>,
}

impl OwnNames {
    /// Columns that the file calls otherwise; `angles` are those of an orientation.
    pub(super) fn new(
        columns: impl IntoIterator<Item = (String, String)>,
        angles: Option<[String; 3]>,
    ) -> Self {
        Self {
            columns: columns.into_iter().filter(|(ours, own)| ours != own).collect(),
            angles: angles.map(|names| names.join(", ")),
        }
    }

    /// The names of both files that are put together; of what both name this one's count.
    pub(super) fn and(&self, other: &Self) -> Self {
        let mut columns = other.columns.clone();
        columns.extend(self.columns.clone());
        Self { columns, angles: self.angles.clone().or_else(|| other.angles.clone()) }
    }

    /// `text` with the file's own names in the place of ours.
    #[must_use]
    pub fn rename(&self, text: &str) -> String {
        if self.columns.is_empty() && self.angles.is_none() {
            return text.to_owned();
        }
        let text = match &self.angles {
            Some(angles) => text.replace(&QUATERNION.join(", "), angles),
            None => text.to_owned(),
        };
        let is_of_name = |letter: char| letter.is_ascii_alphanumeric() || letter == '_';
        let mut out = String::with_capacity(text.len());
        let mut rest = text.as_str();
        while let Some(from) = rest.find(is_of_name) {
            let (before, word_on) = rest.split_at(from);
            let end = word_on.find(|letter| !is_of_name(letter)).unwrap_or(word_on.len());
            let (word, after) = word_on.split_at(end);
            out += before;
            out += self.own(word).unwrap_or(word);
            rest = after;
        }
        out + rest
    }

    /// What the file calls our column `name`; `None` too of names that are words of a sentence (id, target, kind).
    fn own(&self, name: &str) -> Option<&str> {
        let is_no_word = name.contains('_') || name.starts_with("dir") || QUATERNION.contains(&name);
        self.columns.get(name).filter(|_| is_no_word).map(String::as_str)
    }
}

/// Ours and theirs of a pose in six columns.
pub(super) fn of_pose(names: [String; 6]) -> (Vec<(String, String)>, [String; 3]) {
    let [x, y, z, a, b, c] = names;
    (POINT.iter().map(|&ours| ours.to_owned()).zip([x, y, z]).collect(), [a, b, c])
}

#[cfg(test)]
mod tests {
    use super::*;

    fn names(pairs: &[(&str, &str)]) -> Vec<(String, String)> {
        pairs.iter().map(|(ours, own)| ((*ours).to_owned(), (*own).to_owned())).collect()
    }

    #[test]
    fn whole_names_are_the_files_and_words_stay() {
        let own = OwnNames::new(
            names(&[("q1_deg", "J1"), ("q6_deg", "J6"), ("x_mm", "X [in]"), ("target", "SMR"), ("qw", "Q0")]),
            None,
        );
        assert_eq!(
            own.rename("columns q1_deg to q6_deg, x_mm (qw, qx); target A: q11_deg, sq1_deg"),
            "columns J1 to J6, X [in] (Q0, qx); target A: q11_deg, sq1_deg"
        );
        assert_eq!(OwnNames::default().rename("x_mm"), "x_mm");
    }

    #[test]
    fn angles_stand_for_the_quaternion_that_they_became() {
        let (columns, angles) = of_pose(["X", "Y", "Z", "A", "B", "C"].map(str::to_owned));
        let own = OwnNames::new(columns, Some(angles));
        assert_eq!(
            own.rename("leave the columns qw, qx, qy, qz out; z_mm"),
            "leave the columns A, B, C out; Z"
        );
    }
}
