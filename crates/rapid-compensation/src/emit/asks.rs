//! What motions ask with: which correction goes with which target, so that one that was exchanged since is told.

use super::checksum;
use super::names::is_name;

/// A checksum of what a motion asks: the function, the target where it is a name, and what corrects it, `arguments`. `None` of a target
/// that is written out, which has a fingerprint together with its correction. A name that the motion's routine has itself, `is_own`, is
/// another one than the module's.
#[must_use]
pub(super) fn ask(function: &[u8], (target, is_own): (&[u8], bool), arguments: &[u8]) -> Option<[u8; 3]> {
    let target = target.trim_ascii();
    let name = if is_name(target) { target } else { b"" };
    let whose: &[u8] = if is_own && !name.is_empty() { b"own " } else { b"" };
    let of_all = || checksum::of_code(&[whose, function, b"(", name, arguments].concat());
    (target.first() != Some(&b'[')).then(of_all)
}

/// Checksums of all that motions ask, each once and in order, as the comment block holds them.
#[must_use]
pub(super) fn record(mut asks: Vec<[u8; 3]>) -> Vec<u8> {
    sorting::ascending(&mut asks);
    asks.dedup();
    asks.concat()
}

/// Whether a motion asked so when the module was made; so it is with all of an older module, which has no such record.
#[must_use]
pub(super) fn was_asked(recorded: &[u8], ask: [u8; 3]) -> bool {
    let (all, _) = recorded.as_chunks::<3>();
    all.is_empty() || all.binary_search(&ask).is_ok()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn another_correction_is_not_what_was_asked() {
        let by = |correction: &[u8]| ask(b"tcAt", (b"p1", false), correction).unwrap();
        let recorded =
            record(vec![by(b",tcP1"), ask(b"tcAt", (b"p2", false), b",tcP2").unwrap(), by(b",tcP1")]);
        assert_eq!(recorded.len(), 6);
        // As a controller may write it.
        assert!(was_asked(&recorded, ask(b"TCAT", (b"p1 ", false), b" , tcp1").unwrap()));
        for other in [&b",tcP2"[..], b",[[80,0,0],[1,0,0,0]]", b",tcP1{1}"] {
            assert!(!was_asked(&recorded, by(other)), "{}", String::from_utf8_lossy(other));
        }
        assert!(!was_asked(&recorded, ask(b"tcAtSame", (b"p1", false), b",tcP1").unwrap()));
        assert_eq!(
            ask(b"tcAt", (b"[[500,0,600],[1,0,0,0],[0,0,0,0],[9E9,9E9,9E9,9E9,9E9,9E9]]", false), b",tc5"),
            None
        );
        // The one of that name which a routine has itself.
        assert!(!was_asked(&recorded, ask(b"tcAt", (b"p1", true), b",tcP1").unwrap()));
        assert!(was_asked(b"", by(b",tcP2")));
    }
}
