//! RAPID data of a module, by a reader of the double's own: declarations, not code.

/// A RAPID datum as the module declares it.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Data {
    pub name: String,
    /// Storage class: `per`, `var` or `con`.
    pub kind: &'static str,
    pub data_type: String,
    pub dims: Vec<usize>,
    pub is_local: bool,
    pub is_task: bool,
    pub value: String,
}

/// The name behind `MODULE`.
pub(crate) fn module_name(text: &str) -> Option<String> {
    let line = text.lines().map(str::trim).find(|line| line.to_ascii_uppercase().starts_with("MODULE "))?;
    let name: String =
        line[7..].trim().chars().take_while(|c| c.is_ascii_alphanumeric() || *c == '_').collect();
    (!name.is_empty()).then_some(name)
}

/// Whether every MODULE, PROC, FUNC and TRAP ends: what a controller would find at the least.
pub(crate) fn is_whole(text: &str) -> bool {
    let count = |word: &str| {
        let starts = |line: &&str| {
            let upper = line.trim().to_ascii_uppercase();
            let upper = upper.strip_prefix("LOCAL ").unwrap_or(&upper);
            upper == word || upper.starts_with(&format!("{word} "))
        };
        text.lines().filter(starts).count()
    };
    module_name(text).is_some()
        && ["MODULE", "PROC", "FUNC", "TRAP"].iter().all(|word| count(word) == count(&format!("END{word}")))
}

/// All data that a module declares at its own level.
pub(crate) fn data(text: &str) -> Vec<Data> {
    let mut found = Vec::new();
    let mut pending = String::new();
    let mut depth = 0_u32;
    for line in text.lines().map(str::trim) {
        let upper = line.to_ascii_uppercase();
        let bare = upper.strip_prefix("LOCAL ").unwrap_or(&upper);
        if ["PROC ", "FUNC ", "TRAP "].iter().any(|w| bare.starts_with(w)) {
            depth += 1;
        } else if ["ENDPROC", "ENDFUNC", "ENDTRAP"].iter().any(|w| bare.starts_with(w)) {
            depth = depth.saturating_sub(1);
        }
        if depth > 0 || (pending.is_empty() && (line.starts_with('!') || !begins(&upper))) {
            continue;
        }
        pending.push_str(line);
        if let Some(end) = end_of_statement(&pending) {
            found.extend(declared(&pending[..end]));
            pending.clear();
        }
    }
    found
}

/// Names of the routines that a module declares for the whole task, in lower case.
pub(crate) fn global_routines(text: &str) -> Vec<String> {
    let name = |line: &str| {
        let mut words =
            line.split(|c: char| !c.is_ascii_alphanumeric() && c != '_').filter(|w| !w.is_empty());
        let kind = words.next()?.to_ascii_uppercase();
        // A function's type stands before its name.
        match kind.as_str() {
            "PROC" | "TRAP" => words.next(),
            "FUNC" => words.nth(1),
            _ => None,
        }
        .map(str::to_ascii_lowercase)
    };
    text.lines().filter_map(|line| name(line.trim())).collect()
}

fn begins(upper: &str) -> bool {
    let rest = upper.strip_prefix("LOCAL ").or(upper.strip_prefix("TASK ")).unwrap_or(upper);
    ["PERS ", "VAR ", "CONST "].iter().any(|word| rest.trim_start().starts_with(word))
}

/// Where the first `;` outside a text is.
fn end_of_statement(text: &str) -> Option<usize> {
    let mut is_text = false;
    text.char_indices().find_map(|(i, c)| {
        is_text ^= c == '"';
        (c == ';' && !is_text).then_some(i)
    })
}

fn declared(statement: &str) -> Option<Data> {
    let (head, value) = statement.split_once(":=").map_or((statement, ""), |(h, v)| (h, v.trim()));
    let mut words = head.split_whitespace().peekable();
    let is_local = words.next_if(|w| w.eq_ignore_ascii_case("LOCAL")).is_some();
    let is_task = words.next_if(|w| w.eq_ignore_ascii_case("TASK")).is_some();
    let kind = match words.next()?.to_ascii_uppercase().as_str() {
        "PERS" => "per",
        "VAR" => "var",
        _ => "con",
    };
    let data_type = words.next()?.to_owned();
    let name: String = words.collect();
    let (name, dims) = match name.split_once('{') {
        Some((name, dims)) => {
            (name.to_owned(), dims.trim_end_matches('}').split(',').filter_map(|d| d.parse().ok()).collect())
        }
        None => (name, Vec::new()),
    };
    let value = if value.is_empty() { empty(&data_type) } else { value.to_owned() };
    Some(Data { name, kind, data_type, dims, is_local, is_task, value })
}

fn empty(data_type: &str) -> String {
    match data_type {
        "bool" => "FALSE".to_owned(),
        "string" => "\"\"".to_owned(),
        _ => "0".to_owned(),
    }
}

/// A value as the controller would keep it, or what is wrong with it.
pub(crate) fn kept(data_type: &str, value: &str) -> Result<String, &'static str> {
    match data_type {
        "num" => {
            let x: f32 = value.trim().parse().map_err(|_| "no number")?;
            if x.is_finite() { Ok(number(f64::from(x))) } else { Err("no number") }
        }
        "bool" => match value.to_ascii_uppercase().as_str() {
            "TRUE" => Ok("TRUE".to_owned()),
            "FALSE" => Ok("FALSE".to_owned()),
            _ => Err("no bool"),
        },
        "string" => {
            let inner = value.strip_prefix('"').and_then(|v| v.strip_suffix('"')).ok_or("no string")?;
            if inner.replace("\"\"", "\"").len() > 80 { Err("longer than 80") } else { Ok(value.to_owned()) }
        }
        _ => Ok(value.to_owned()),
    }
}

/// A number in single precision, as the controller writes it.
pub(crate) fn number(x: f64) -> String {
    let x = x as f32;
    if x == 9e9 {
        return "9E+09".to_owned();
    }
    format!("{x}")
}

/// Elements of an aggregate `[a,b,[c,d]]`.
pub(crate) fn elements(value: &str) -> Option<Vec<String>> {
    let inner = value.trim().strip_prefix('[')?.strip_suffix(']')?;
    let (mut out, mut depth, mut start) = (Vec::new(), 0, 0);
    for (i, c) in inner.char_indices() {
        match c {
            '[' => depth += 1,
            ']' => depth -= 1,
            ',' if depth == 0 => {
                out.push(inner[start..i].trim().to_owned());
                start = i + 1;
            }
            _ => {}
        }
    }
    out.push(inner[start..].trim().to_owned());
    Some(out)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn declarations_are_read_and_code_is_not() {
        let text = "MODULE M\n  TASK PERS num tcMode:=-1;\n LOCAL PERS num tcState{2}:=\n [0,1]; ! ;\n VAR string s;\n\
                    PROC p()\n VAR num inner:=1;\n ENDPROC\nENDMODULE\n";
        let found = data(text);
        let names: Vec<&str> = found.iter().map(|d| d.name.as_str()).collect();
        assert_eq!(names, ["tcMode", "tcState", "s"]);
        assert_eq!((found[1].dims.as_slice(), found[1].value.as_str()), (&[2][..], "[0,1]"));
        assert!(found[0].is_task && found[1].is_local && found[2].kind == "var");
        assert!(is_whole(text) && !is_whole(&text[..text.len() - 12]));
        assert_eq!(module_name(text).as_deref(), Some("M"));
    }

    #[test]
    fn routines_of_the_whole_task_are_those_without_local() {
        let text = "MODULE M\nPROC Main()\nENDPROC\nLOCAL PROC own()\nENDPROC\n FUNC num Twice(num a)\nENDFUNC\nTRAP t1\nENDTRAP\nENDMODULE\n";
        assert_eq!(global_routines(text), ["main", "twice", "t1"]);
    }

    #[test]
    fn values_are_kept_in_single_precision() {
        assert_eq!(kept("num", "0.1234567891").unwrap(), "0.12345679");
        assert_eq!(kept("num", "9E9").unwrap(), "9E+09");
        assert!(kept("num", "TRUE").is_err() && kept("string", "a").is_err());
        assert_eq!(elements("[1,[2,3],4]").unwrap(), ["1", "[2,3]", "4"]);
    }
}
