//! What the folders promise: crates and modules use only what stands before them, files of one folder do not use each other in a
//! circle, and factors between units stand in `units` alone.

use std::collections::{BTreeMap, BTreeSet};
use std::fs;
use std::path::{Path, PathBuf};
use std::sync::LazyLock;
use syn::visit::{self, Visit};

/// Members of the workspace with those of them that each may use; the root package may use all.
const CRATES: [(&str, &[&str]); 15] = [
    ("parallel", &[]),
    ("sorting", &[]),
    ("statistics", &["sorting"]),
    ("rapid-syntax", &["sorting"]),
    ("robot-model", &["sorting", "rapid-syntax"]),
    ("rapid-program", &["sorting", "rapid-syntax", "robot-model"]),
    ("rapid-compensation", &["parallel", "sorting", "rapid-syntax", "robot-model", "rapid-program"]),
    ("virtual-controller", &["sorting", "rapid-syntax", "robot-model"]),
    ("measurements", &["sorting", "statistics", "rapid-syntax", "robot-model"]),
    ("inference", &["parallel", "sorting", "statistics", "robot-model", "measurements"]),
    ("warm-up", &["parallel", "sorting", "statistics", "rapid-syntax", "robot-model", "measurements"]),
    (
        "metrology",
        &[
            "parallel",
            "sorting",
            "statistics",
            "rapid-syntax",
            "robot-model",
            "measurements",
            "inference",
            "warm-up",
        ],
    ),
    ("exam", &["sorting", "robot-model"]),
    ("rws-double", &["robot-model"]),
    // The double for its tests alone.
    ("robot-link", &["rws-double"]),
];

/// Modules of each crate in the order of the data flow.
const MODULES: [(&str, &[&str]); 4] = [
    ("robot_model", &["units", "csv_lines", "robot", "kinematics", "deform"]),
    ("rapid_compensation", &["schedule", "compensate", "emit"]),
    ("metrology", &["admissible", "diagnose", "plan"]),
    ("driftpost", &["report", "application", "cli"]),
];

/// Modules that must not use another's although the crates would let them.
const APART: [(&str, &str); 6] = [
    ("rapid_program", "robot_model::deform"),
    ("rapid_compensation::schedule", "rapid_syntax"),
    ("exam", "robot_model::deform"),
    ("exam", "robot_model::kinematics"),
    ("rws_double", "robot_model::kinematics"),
    ("rws_double", "robot_model::robot"),
];

pub(crate) fn root() -> &'static Path {
    Path::new(env!("CARGO_MANIFEST_DIR"))
}

/// Folder of the sources of a crate, by the name it has in code.
fn source_folder(crate_name: &str) -> PathBuf {
    match crate_name {
        "driftpost" => root().join("src"),
        _ => root().join("crates").join(crate_name.replace('_', "-")).join("src"),
    }
}

fn crate_names() -> Vec<String> {
    CRATES.iter().map(|(name, _)| name.replace('-', "_")).chain(["driftpost".to_owned()]).collect()
}

/// A module of the product: a file, and all paths that its code names, without its tests.
#[derive(Default)]
struct Module {
    file: PathBuf,
    /// Absolute paths of what it uses, `crate::module::item`, as far as they lead into the workspace.
    uses: BTreeSet<Vec<String>>,
    /// Names that it holds by `use`, with what they stand for.
    imports: BTreeMap<String, Vec<String>>,
}

impl Module {
    /// Its text without comments and tests.
    fn code(&self) -> String {
        let text = fs::read_to_string(&self.file).unwrap();
        let product = text.split("#[cfg(test)]").next().unwrap_or("");
        product.lines().map(|line| line.split("//").next().unwrap_or("")).collect::<Vec<_>>().join("\n")
    }
}

/// All modules of the workspace by their path.
struct Modules(BTreeMap<Vec<String>, Module>);

impl Modules {
    /// Read once for all tests.
    fn all() -> &'static Self {
        static ALL: LazyLock<Modules> = LazyLock::new(Modules::read);
        &ALL
    }

    fn read() -> Self {
        let mut modules = BTreeMap::new();
        for name in crate_names() {
            read_folder(&source_folder(&name), std::slice::from_ref(&name), &mut modules);
        }
        let known: BTreeSet<Vec<String>> = modules.keys().cloned().collect();
        for (path, module) in &mut modules {
            let text = fs::read_to_string(&module.file).unwrap();
            let file = syn::parse_file(&text).unwrap_or_else(|e| panic!("{}: {e}", module.file.display()));
            let mut uses = Uses { at: path, known: &known, found: module };
            uses.visit_file(&file);
        }
        Self(modules)
    }

    /// The module that `path` leads to, through what is exported again.
    fn module_of(&self, path: &[String]) -> Option<Vec<String>> {
        let mut path = path.to_vec();
        for _ in 0..8 {
            let end = (1..=path.len()).rev().find(|&n| self.0.contains_key(&path[..n]))?;
            let again = path.get(end).and_then(|name| self.0[&path[..end]].imports.get(name));
            match again {
                Some(target) => path = target.iter().chain(&path[end + 1..]).cloned().collect(),
                None => return Some(path[..end].to_vec()),
            }
        }
        None
    }

    /// For each module the other modules that it uses.
    fn edges(&self) -> BTreeMap<&Vec<String>, BTreeSet<Vec<String>>> {
        self.0
            .iter()
            .map(|(path, module)| {
                let mut used: BTreeSet<_> = module.uses.iter().filter_map(|u| self.module_of(u)).collect();
                used.remove(path);
                (path, used)
            })
            .collect()
    }
}

/// The files of a folder: `mod.rs`, `lib.rs` and `main.rs` stand for the folder itself.
fn read_folder(folder: &Path, at: &[String], modules: &mut BTreeMap<Vec<String>, Module>) {
    let mut entries: Vec<PathBuf> = fs::read_dir(folder).unwrap().map(|e| e.unwrap().path()).collect();
    entries.sort();
    for entry in entries {
        let stem = entry.file_stem().unwrap().to_string_lossy().into_owned();
        let inner: Vec<String> = at.iter().cloned().chain([stem.clone()]).collect();
        if entry.is_dir() {
            if stem != "tests" {
                read_folder(&entry, &inner, modules);
            }
        } else if entry.extension().is_some_and(|e| e == "rs") && stem != "tests" && stem != "main" {
            let path = if stem == "mod" || stem == "lib" { at.to_vec() } else { inner };
            modules.insert(path, Module { file: entry, ..Module::default() });
        }
    }
}

/// The files of the members, without those of tests.
pub(crate) fn files_of_members() -> Vec<PathBuf> {
    let mut modules = BTreeMap::new();
    for name in CRATES.map(|(name, _)| name.replace('-', "_")) {
        read_folder(&source_folder(&name), std::slice::from_ref(&name), &mut modules);
    }
    modules.into_values().map(|module| module.file).collect()
}

struct Uses<'a> {
    at: &'a [String],
    known: &'a BTreeSet<Vec<String>>,
    found: &'a mut Module,
}

impl Uses<'_> {
    /// The absolute path of one written here; `None` where it leads out of the workspace.
    fn absolute(&self, written: &[String]) -> Option<Vec<String>> {
        let (mut base, mut rest) = (self.at.to_vec(), written);
        match written.first()?.as_str() {
            "crate" => {
                base.truncate(1);
                rest = &written[1..];
            }
            "self" => rest = &written[1..],
            "super" => {
                while rest.first().is_some_and(|s| s == "super") {
                    base.pop();
                    rest = &rest[1..];
                }
            }
            first => {
                base.push(first.to_owned());
                let local = self.known.contains(&base);
                base.pop();
                if !local {
                    self.known.contains(&[first.to_owned()][..]).then_some(())?;
                    base.clear();
                }
            }
        }
        base.extend(rest.iter().cloned());
        Some(base)
    }

    fn tree(&mut self, tree: &syn::UseTree, before: &mut Vec<String>) {
        match tree {
            syn::UseTree::Path(path) => {
                before.push(path.ident.to_string());
                self.tree(&path.tree, before);
                before.pop();
            }
            syn::UseTree::Group(group) => group.items.iter().for_each(|item| self.tree(item, before)),
            syn::UseTree::Glob(_) => self.take_use(before.clone(), None),
            syn::UseTree::Name(name) => {
                let ident = name.ident.to_string();
                let mut path = before.clone();
                if ident != "self" {
                    path.push(ident);
                }
                let held = path.last().cloned();
                self.take_use(path, held);
            }
            syn::UseTree::Rename(name) => {
                let mut path = before.clone();
                path.push(name.ident.to_string());
                self.take_use(path, Some(name.rename.to_string()));
            }
        }
    }

    fn take_use(&mut self, written: Vec<String>, held: Option<String>) {
        let Some(path) = self.absolute(&written) else { return };
        if let Some(held) = held {
            self.found.imports.insert(held, path.clone());
        }
        self.found.uses.insert(path);
    }
}

fn is_test(attributes: &[syn::Attribute]) -> bool {
    attributes.iter().any(|a| {
        a.path().is_ident("cfg") && a.parse_args::<syn::Path>().is_ok_and(|path| path.is_ident("test"))
    })
}

impl<'ast> Visit<'ast> for Uses<'_> {
    fn visit_item_mod(&mut self, item: &'ast syn::ItemMod) {
        if !is_test(&item.attrs) {
            visit::visit_item_mod(self, item);
        }
    }

    fn visit_item_use(&mut self, item: &'ast syn::ItemUse) {
        if !is_test(&item.attrs) {
            self.tree(&item.tree, &mut Vec::new());
        }
    }

    fn visit_path(&mut self, path: &'ast syn::Path) {
        if path.segments.len() > 1 {
            let written: Vec<String> = path.segments.iter().map(|s| s.ident.to_string()).collect();
            if let Some(path) = self.absolute(&written) {
                self.found.uses.insert(path);
            }
        }
        visit::visit_path(self, path);
    }
}

#[test]
fn members_depend_only_on_what_stands_before_them() {
    let members: Vec<&str> = CRATES.iter().map(|(name, _)| *name).collect();
    let folders: BTreeSet<String> = fs::read_dir(root().join("crates"))
        .unwrap()
        .map(|e| e.unwrap().file_name().to_string_lossy().into_owned())
        .collect();
    assert_eq!(folders, members.iter().map(|m| (*m).to_owned()).collect());
    for (name, may_use) in CRATES {
        let manifest = fs::read_to_string(root().join("crates").join(name).join("Cargo.toml")).unwrap();
        let manifest: toml::Table = manifest.parse().unwrap();
        for section in ["dependencies", "dev-dependencies", "build-dependencies"] {
            let Some(section) = manifest.get(section).and_then(toml::Value::as_table) else { continue };
            let wrong: Vec<_> = section
                .keys()
                .filter(|d| members.contains(&d.as_str()) && !may_use.contains(&d.as_str()))
                .collect();
            assert!(wrong.is_empty(), "{name} may use {may_use:?}, and uses {wrong:?}");
        }
    }
}

/// Work is shared among cores in one place, so that results stand in one order: see `crates/parallel`.
#[test]
fn one_member_alone_depends_on_what_shares_work_among_cores() {
    let folders = CRATES.iter().map(|(name, _)| root().join("crates").join(name));
    let manifests = folders.chain([root().to_owned()]).map(|folder| folder.join("Cargo.toml"));
    let asks = |path: &PathBuf| {
        let manifest: toml::Table = fs::read_to_string(path).unwrap().parse().unwrap();
        manifest.get("dependencies").is_some_and(|all| all.get("rayon").is_some())
    };
    let asking: Vec<PathBuf> = manifests.filter(asks).collect();
    assert_eq!(asking, [root().join("crates/parallel/Cargo.toml")]);
}

/// What is taken from elsewhere is listed with what it is for.
#[test]
fn every_dependency_has_its_reason_in_the_documentation() {
    let manifest = fs::read_to_string(root().join("Cargo.toml")).unwrap();
    let page = fs::read_to_string(root().join("docs/ARCHITECTURE.md")).unwrap();
    let (_, reasons) = page.split_once("\n## Dependencies\n").unwrap();
    let (_, listed) = manifest.split_once("[workspace.dependencies]\n").unwrap();
    let (listed, _) = listed.split_once("\n\n").unwrap();
    let names = listed.lines().filter(|line| !line.contains("path = ")).filter_map(|l| l.split(' ').next());
    let missing: Vec<&str> = names.clone().filter(|name| !reasons.contains(&format!("`{name}`"))).collect();
    assert!(names.count() > 30, "the list of dependencies was not found");
    assert!(missing.is_empty(), "no reason in docs/ARCHITECTURE.md for {missing:?}");
}

#[test]
fn python_uses_the_front_door() {
    let manifest = fs::read_to_string(root().join("python/Cargo.toml")).unwrap();
    let manifest: toml::Table = manifest.parse().unwrap();
    let used: Vec<&String> = manifest["dependencies"].as_table().unwrap().keys().collect();
    assert!(used.iter().any(|name| *name == "driftpost"));
    let members = CRATES.map(|(name, _)| name);
    assert!(!used.iter().any(|name| members.contains(&name.as_str())), "{used:?}");
    let root_manifest: toml::Table = fs::read_to_string(root().join("Cargo.toml")).unwrap().parse().unwrap();
    let default = root_manifest["workspace"]["default-members"].as_array().unwrap();
    assert!(default.iter().all(|member| member.as_str() != Some("python")), "cargo test needs no Python");
}

#[test]
fn the_library_has_one_front_door() {
    let text = fs::read_to_string(root().join("src/lib.rs")).unwrap();
    let public = syn::parse_file(&text).unwrap().items.into_iter().filter_map(|item| match item {
        syn::Item::Mod(module) if matches!(module.vis, syn::Visibility::Public(_)) => {
            Some(module.ident.to_string())
        }
        _ => None,
    });
    assert_eq!(public.collect::<Vec<_>>(), ["application", "parts", "command_line"]);
}

#[test]
fn a_module_uses_only_what_stands_to_its_left() {
    let modules = Modules::all();
    let mut wrong = Vec::new();
    let mut checked = 0;
    for (path, used) in modules.edges() {
        for used in used {
            checked += 1;
            let place = |path: &[String]| {
                let (_, order) = MODULES.iter().find(|(name, _)| *name == path[0])?;
                order.iter().position(|m| Some(*m) == path.get(1).map(String::as_str))
            };
            if path[0] == used[0] && place(path) < place(&used) && place(path).is_some() {
                wrong.push(format!("{} uses {}", path.join("::"), used.join("::")));
            }
            for (module, other) in APART {
                let below = |path: &[String], module: &str| {
                    format!("{}::", path.join("::")).starts_with(&format!("{module}::"))
                };
                if below(path, module) && below(&used, other) {
                    wrong.push(format!("{} uses {}", path.join("::"), used.join("::")));
                }
            }
        }
    }
    assert!(checked > 500, "only {checked} uses found");
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
}

#[test]
fn every_module_of_a_crate_stands_in_the_order() {
    let modules = Modules::all();
    for (name, order) in MODULES {
        let declared: BTreeSet<&str> = modules
            .0
            .keys()
            .filter(|path| path.len() == 2 && path[0] == name)
            .map(|path| path[1].as_str())
            .collect();
        assert_eq!(declared, order.iter().copied().collect(), "modules of {name}");
    }
}

/// Groups of entries of one folder that use each other round in a circle.
fn circles(modules: &Modules) -> Vec<String> {
    let mut between: BTreeMap<Vec<String>, BTreeMap<String, BTreeSet<String>>> = BTreeMap::new();
    for (path, used) in modules.edges() {
        for used in used {
            let same = path.iter().zip(&used).take_while(|(a, b)| a == b).count();
            if let (Some(from), Some(to)) = (path.get(same), used.get(same)) {
                let folder = between.entry(path[..same].to_vec()).or_default();
                folder.entry(from.clone()).or_default().insert(to.clone());
            }
        }
    }
    let mut found = Vec::new();
    for (folder, uses) in &between {
        let reached = |from: &String| {
            let (mut reached, mut open) = (BTreeSet::new(), vec![from]);
            while let Some(next) = open.pop() {
                for to in uses.get(next).into_iter().flatten() {
                    if reached.insert(to.clone()) {
                        open.push(to);
                    }
                }
            }
            reached
        };
        let all: BTreeMap<&String, BTreeSet<String>> = uses.keys().map(|k| (k, reached(k))).collect();
        let mut reported = BTreeSet::new();
        for (name, reached) in &all {
            if !reached.contains(*name) || reported.contains(*name) {
                continue;
            }
            let ring: Vec<&String> = all
                .iter()
                .filter(|(other, back)| reached.contains(**other) && back.contains(*name))
                .map(|(other, _)| *other)
                .collect();
            reported.extend(ring.iter().copied());
            found.push(format!("{}: {ring:?}", folder.join("::")));
        }
    }
    found
}

#[test]
fn files_of_a_folder_do_not_use_each_other_in_a_circle() {
    let found = circles(Modules::all());
    assert!(found.is_empty(), "{}", found.join("\n"));
}

#[test]
fn a_circle_is_seen_through_what_is_exported_again() {
    let name = |parts: &[&str]| parts.iter().map(|p| (*p).to_owned()).collect::<Vec<_>>();
    let folder = tempfile::tempdir().unwrap();
    fs::create_dir(folder.path().join("m")).unwrap();
    for (file, text) in [
        ("lib.rs", "mod m;"),
        ("m/mod.rs", "mod a; mod b; mod c; pub use b::Thing;"),
        ("m/a.rs", "use super::{Thing, c::f}; // use crate::g;"),
        ("m/b.rs", "pub struct Thing; fn x() { crate::m::a::y() }"),
        ("m/c.rs", "#[cfg(test)] mod tests { use super::super::a; }"),
    ] {
        fs::write(folder.path().join(file), text).unwrap();
    }
    let mut modules = BTreeMap::new();
    read_folder(folder.path(), &name(&["k"]), &mut modules);
    let known: BTreeSet<_> = modules.keys().cloned().collect();
    for (path, module) in &mut modules {
        let file = syn::parse_file(&fs::read_to_string(&module.file).unwrap()).unwrap();
        Uses { at: path, known: &known, found: module }.visit_file(&file);
    }
    let modules = Modules(modules);
    assert_eq!(modules.module_of(&name(&["k", "m", "Thing"])), Some(name(&["k", "m", "b"])));
    assert_eq!(circles(&modules), [r#"k::m: ["a", "b"]"#]);
}

/// Ways to write a conversion between mm and m, degrees and radians, minutes and seconds.
const WORDS: [&str; 17] = [
    "1e3 *",
    "* 1e3",
    "/ 1e3",
    "to_radians",
    "to_degrees",
    "* 1000.0",
    "/ 1000.0",
    "180.0 /",
    "/ 180.0",
    "* 60.0",
    "/ 60.0",
    "* 60 ",
    "/ 60 ",
    "1440",
    "86_400",
    "* 3600",
    "/ 3600",
];

#[test]
fn conversion_factors_stand_in_units_alone() {
    let mut wrong = Vec::new();
    for (path, module) in &Modules::all().0 {
        if path.ends_with(&["units".to_owned()]) {
            continue;
        }
        let code = module.code();
        for word in WORDS.iter().filter(|word| code.contains(**word)) {
            wrong.push(format!("{} holds `{word}`: use robot_model::units", module.file.display()));
        }
    }
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
}

/// The standard library's sorting is compiled anew for each kind of item and each comparison: see `crates/sorting`.
#[test]
fn one_member_alone_sorts() {
    let sorts = |module: &&Module| {
        let code = module.code();
        [".sort(", ".sort_by", ".sort_unstable"].iter().any(|call| code.contains(call))
    };
    let sorting: Vec<&PathBuf> = Modules::all().0.values().filter(sorts).map(|module| &module.file).collect();
    assert_eq!(sorting, [&root().join("crates/sorting/src/lib.rs")]);
}
