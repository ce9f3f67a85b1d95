//! `.pgf`: the list of a program's modules, as RobotStudio and the controller write it.

use super::names::as_text;

/// The module paths that a `.pgf` lists, in order, `/` between folders, relative to the `.pgf`.
///
/// The file is XML of one shape: `<Module>path</Module>` elements; anything else in it is skipped. It
/// may be ISO 8859-1 or UTF-8.
#[must_use]
pub fn modules_of_pgf(bytes: &[u8]) -> Vec<String> {
    let text = as_text(bytes);
    let lower = text.to_ascii_lowercase();
    let mut out = Vec::new();
    let mut at = 0;
    while let Some(found) = lower[at..].find("<module>") {
        let start = at + found + "<module>".len();
        let Some(length) = lower[start..].find("</module>") else { break };
        let path = text[start..start + length].trim();
        if !path.is_empty() {
            out.push(unescape(path).replace('\\', "/"));
        }
        at = start + length;
    }
    out
}

fn unescape(text: &str) -> String {
    text.replace("&lt;", "<")
        .replace("&gt;", ">")
        .replace("&quot;", "\"")
        .replace("&apos;", "'")
        .replace("&amp;", "&")
}

#[cfg(test)]
mod tests {
    use super::modules_of_pgf;

    #[test]
    fn module_paths_in_order() {
        let pgf =
            b"<?xml version=\"1.0\" encoding=\"ISO-8859-1\" ?>\r\n<Program>\r\n\t<Module>A.mod</Module>\r\n\
            \t<Module> sub\\K\xFChn &amp; Co.mod </Module>\r\n\t<Module></Module>\r\n</Program>\r\n";
        assert_eq!(modules_of_pgf(pgf), ["A.mod", "sub/K\u{fc}hn & Co.mod"]);
        assert!(modules_of_pgf(b"").is_empty());
        assert!(modules_of_pgf(b"<Module>A.mod").is_empty());
    }
}
