//! What a controller has left, where it says: bytes of its disks, memory of RAPID.
//!
//! Disks are documented for RobotWare 6; 7 and 8 list their volumes without sizes. Memory of RAPID stands in the tree of devices,
//! whose shape is documented and whose names are not: the branches that are called after RAPID and after memory are followed, and
//! what stands there is shown as the controller calls it.

use crate::answer::Answer;
use crate::{LinkError, Session, names, requests};

/// A disk of the controller.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct DiskSpace {
    /// As the controller calls it, `hd0a`.
    pub name: String,
    /// Bytes that are free.
    pub free_bytes: u64,
    /// Bytes in all, where the controller says.
    pub total_bytes: Option<u64>,
}

/// A number that a controller shows of itself, in its own words.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct DeviceProperty {
    /// What it is called, `Free memory`.
    pub name: String,
    /// Its value as it is written.
    pub value: String,
    /// Its unit; empty where there is none.
    pub unit: String,
}

/// What a controller has left; empty lists where it does not say.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct FreeMemory {
    /// Of the program memory, as the controller shows it.
    pub rapid: Vec<DeviceProperty>,
    /// Of each disk that the file service lists.
    pub disks: Vec<DiskSpace>,
}

/// More branches of the tree than so many are not followed.
const MOST_BRANCHES: usize = 4;

impl Session {
    /// What is left of RAPID's memory and of the disks.
    ///
    /// # Errors
    /// No or an incomplete answer; that the controller does not offer it is none.
    pub fn free_memory(&mut self) -> Result<FreeMemory, LinkError> {
        let mut left = FreeMemory { rapid: self.rapid_memory()?, disks: Vec::new() };
        let Some(disks) = self.optional(requests::DISKS, &[])? else { return Ok(left) };
        for disk in disks.all("fs-device").filter(|disk| disk.optional("fs-free-space").is_some()) {
            let bytes = |text: &str| text.parse().ok();
            let free_bytes =
                bytes(disk.text("fs-free-space")?).ok_or_else(|| disks.without("number in fs-free-space"))?;
            let total_bytes = disk.optional("fs-total-space").and_then(bytes);
            left.disks.push(DiskSpace { name: disk.title().replace("%3a", ":"), free_bytes, total_bytes });
        }
        Ok(left)
    }

    fn rapid_memory(&mut self) -> Result<Vec<DeviceProperty>, LinkError> {
        let mut found = Vec::new();
        let Some(groups) = self.optional(requests::RESOURCES, &[])? else { return Ok(found) };
        for group in branches(&groups, "rapid") {
            let Some(inside) = self.optional(requests::RESOURCE, &[("device", &group)])? else { continue };
            found.extend(properties(&inside).into_iter().filter(|one| is_called(&one.name, "memory")));
            for part in branches(&inside, "memory") {
                let arguments = [("device", group.as_str()), ("part", part.as_str())];
                if let Some(leaf) = self.optional(requests::RESOURCE_PART, &arguments)? {
                    found.extend(properties(&leaf));
                }
            }
        }
        Ok(found)
    }
}

fn is_called(name: &str, word: &str) -> bool {
    name.to_ascii_lowercase().contains(word)
}

/// Branches of the tree whose name, or what stands for it, holds a word.
fn branches(answer: &Answer, word: &str) -> Vec<String> {
    let is =
        |title: &str, name: Option<&str>| is_called(title, word) || name.is_some_and(|n| is_called(n, word));
    answer
        .all("dev-id")
        .filter(|entry| is(entry.title(), entry.optional("name")))
        .filter_map(|entry| names::device(entry.title()).ok().map(str::to_owned))
        .take(MOST_BRANCHES)
        .collect()
}

/// The numbers that stand at a place of the tree.
fn properties(answer: &Answer) -> Vec<DeviceProperty> {
    let of = |class| answer.all(class);
    let entries = of("dev-propint").chain(of("dev-propstr"));
    let property = |entry: crate::answer::Entry<'_>| {
        Some(DeviceProperty {
            name: entry.optional("name").unwrap_or(entry.title()).to_owned(),
            value: entry.optional("value")?.to_owned(),
            unit: entry.optional("unit").unwrap_or_default().to_owned(),
        })
    };
    entries.filter_map(property).collect()
}
