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

/// A `.pgf` with one more module behind its last one, written as that one is; as it was where it lists none,
/// or lists `module` already.
#[must_use]
pub fn pgf_with_module(bytes: &[u8], module: &str) -> Vec<u8> {
    if modules_of_pgf(bytes).iter().any(|listed| listed.eq_ignore_ascii_case(module)) {
        return bytes.to_vec();
    }
    let lower = bytes.to_ascii_lowercase();
    let begin = memchr::memmem::rfind(&lower, b"<module>");
    let end = memchr::memmem::rfind(&lower, b"</module>").map(|at| at + b"</module>".len());
    let (Some(begin), Some(end)) = (begin, end) else { return bytes.to_vec() };
    let line = bytes[..begin].iter().rposition(|b| *b == b'\n').unwrap_or(begin);
    let crlf = line > 0 && line < begin && bytes[line - 1] == b'\r';
    let before = &bytes[if crlf { line - 1 } else { line }..begin];
    let element = format!("<Module>{}</Module>", escape(module));
    [&bytes[..end], before, element.as_bytes(), &bytes[end..]].concat()
}

/// A `.pgf` without a module that [`pgf_with_module`] has added: as it was before, byte for byte.
#[must_use]
pub fn pgf_without_module(bytes: &[u8], module: &str) -> Vec<u8> {
    let element = format!("<Module>{}</Module>", escape(module));
    let Some(begin) = memchr::memmem::rfind(bytes, element.as_bytes()) else { return bytes.to_vec() };
    let before = bytes[..begin].trim_ascii_end();
    [before, &bytes[begin + element.len()..]].concat()
}

fn escape(text: &str) -> String {
    text.replace('&', "&amp;").replace('<', "&lt;").replace('>', "&gt;").replace('"', "&quot;")
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
    use super::{modules_of_pgf, pgf_with_module, pgf_without_module};

    #[test]
    fn module_paths_in_order() {
        let pgf =
            b"<?xml version=\"1.0\" encoding=\"ISO-8859-1\" ?>\r\n<Program>\r\n\t<Module>A.mod</Module>\r\n\
            \t<Module> sub\\K\xFChn &amp; Co.mod </Module>\r\n\t<Module></Module>\r\n</Program>\r\n";
        assert_eq!(modules_of_pgf(pgf), ["A.mod", "sub/K\u{fc}hn & Co.mod"]);
        assert!(modules_of_pgf(b"").is_empty());
        assert!(modules_of_pgf(b"<Module>A.mod").is_empty());
    }

    #[test]
    fn one_more_module_is_written_as_the_last_one_is() {
        let pgf = b"<Program>\r\n\t<Module>A.mod</Module>\r\n</Program>\r\n";
        let more = pgf_with_module(pgf, "tcCore.mod");
        assert_eq!(
            String::from_utf8_lossy(&more),
            "<Program>\r\n\t<Module>A.mod</Module>\r\n\t<Module>tcCore.mod</Module>\r\n</Program>\r\n"
        );
        assert_eq!(pgf_with_module(&more, "TCCORE.mod"), more);
        let one_line = b"<Program><module>A.mod</module></Program>";
        assert_eq!(modules_of_pgf(&pgf_with_module(one_line, "B & C.mod")), ["A.mod", "B & C.mod"]);
        assert_eq!(pgf_with_module(b"<Program/>", "A.mod"), b"<Program/>");
        for before in [&pgf[..], &one_line[..]] {
            assert_eq!(pgf_without_module(&pgf_with_module(before, "B & C.mod"), "B & C.mod"), before);
            assert_eq!(pgf_without_module(before, "B & C.mod"), before);
        }
    }
}
