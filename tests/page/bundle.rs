//! What stands in every page is what its sources make.

use std::fs;
use std::path::Path;
use std::process::Command;

#[test]
#[ignore = "needs `npm ci` in assets"]
fn the_bundle_is_made_of_its_sources() {
    let assets = Path::new(env!("CARGO_MANIFEST_DIR")).join("assets");
    let folder = tempfile::tempdir().unwrap();
    let made =
        Command::new("node").arg("build.mjs").arg(folder.path()).current_dir(&assets).status().unwrap();
    assert!(made.success());
    for name in ["page.js", "page.css", "LICENSES.txt"] {
        let (old, new) =
            (fs::read(assets.join("dist").join(name)).unwrap(), fs::read(folder.path().join(name)).unwrap());
        assert!(old == new, "assets/dist/{name} is not what `npm run build` makes of assets/page");
    }
}

/// Read by whoever builds elsewhere: addresses of a registry would bind them to it.
#[test]
fn the_lock_names_no_registry() {
    let lock =
        fs::read_to_string(Path::new(env!("CARGO_MANIFEST_DIR")).join("assets/package-lock.json")).unwrap();
    assert!(lock.contains("\"integrity\"") && !lock.contains("\"resolved\"") && !lock.contains("://"));
}
