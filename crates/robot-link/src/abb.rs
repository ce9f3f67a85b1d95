//! The controller's own numbers, as sentences: who holds what, which right is missing, which mode is needed.

/// What the controller answers where it refuses a request.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Refusal {
    /// Status of the HTTP answer.
    pub status: u16,
    /// ABB's number, which decides; `None` where the answer holds none.
    pub number: Option<i64>,
    /// The number within the message, where the first is a general one.
    pub inner: Option<i64>,
    /// The message, without the place in ABB's sources.
    pub message: String,
}

/// A group of numbers: stable code, sentence, what to do next.
struct Meaning {
    code: &'static str,
    sentence: &'static str,
    help: &'static str,
}

const fn meaning(code: &'static str, sentence: &'static str, help: &'static str) -> Meaning {
    Meaning { code, sentence, help }
}

const REPORT: &str = "please report it with the number";

const HELD: Meaning = meaning(
    "link::held",
    "someone else (the pendant, RobotStudio) holds the right to write",
    "end it there, then run again; `link info` says who holds it",
);
const STATION: Meaning = meaning(
    "link::station",
    "another station holds write access, or Remote Access is off on the pendant",
    "switch Remote Access on, or let the other station give it back",
);
const NO_RIGHT: Meaning = meaning(
    "link::no-right",
    "the right to write is missing or was taken away",
    "run again; someone at the pendant may have taken it",
);
const NOT_HELD: Meaning = meaning("link::not-held", "the right to write is not held", "nothing to do");
const ALREADY_HELD: Meaning =
    meaning("link::already-held", "the right to write is held already", "nothing to do");
const MODE: Meaning = meaning(
    "link::mode",
    "not allowed in this operating mode",
    "switch the controller to the other mode, then run again",
);
const OPERATOR: Meaning = meaning(
    "link::grant",
    "the operator, or the rights of this user, do not allow it",
    "in manual mode the operator must allow it on the pendant; in automatic the user needs the grants to write to disk, to load and to edit RAPID",
);
const STOPPED: Meaning = meaning(
    "link::execution",
    "the program runs, or its pointer stands where it cannot be replaced",
    "stop the program and set PP to Main on the pendant, then run again",
);
const NO_FILE: Meaning = meaning(
    "link::no-file",
    "no such file or volume on the controller",
    "see the list of files in `link push` without --yes",
);
const NO_SYMBOL: Meaning = meaning(
    "link::no-symbol",
    "no such module or data, or the name is taken",
    "`link info` lists the modules",
);
const FULL_DISK: Meaning = meaning(
    "link::no-space",
    "disk or RAPID memory of the controller is full, or the name is too long",
    "make room; use a shorter name",
);
const PERS_ONLY: Meaning = meaning(
    "link::rapid-value",
    "only PERS can be written, and RAPID does not accept this text or value",
    "give a value of the data's own type",
);
const PROTECTED: Meaning =
    meaning("link::protected", "the module is protected", "take the protection off in RobotStudio");
const BUSY: Meaning = meaning(
    "link::busy",
    "the controller is busy or has failed",
    "wait, read back what is there, then run again",
);
const REACH: Meaning =
    meaning("link::reach", "the pose cannot be reached in this configuration", "see the target in `inspect`");
const UNIT: Meaning =
    meaning("link::unit", "the mechanical unit or the tool is not as needed", "--unit names another");
const OPTION: Meaning = meaning(
    "link::option",
    "the controller lacks the option, or has it switched off",
    "`link info` lists the options",
);
const NO_REQUEST: Meaning = meaning(
    "link::expired",
    "the request to the operator expired",
    "run again, and answer on the pendant within a minute",
);
const LIMIT: Meaning =
    meaning("link::limit", "too many clients or subscriptions", "wait five minutes, or close other clients");
const LOGGED_OFF: Meaning = meaning("link::logged-off", "the session is no longer known", "run again");
const UNKNOWN_NAME: Meaning = meaning(
    "link::unknown-name",
    "the controller does not know this name or path",
    "is it spelled as on the controller?",
);
const GONE: Meaning = meaning("link::gone", "this RobotWare no longer has it", REPORT);
const OTHER: Meaning = meaning("link::refused", "the controller refused", REPORT);

fn of_number(number: i64) -> Option<&'static Meaning> {
    // ABB's numbers begin with -10734; the rest tells them apart.
    Some(match -number - 1_073_400_000 {
        45862 => &HELD,
        35870 | 35871 => &STATION,
        45859 => &NO_RIGHT,
        35873 | 45872 => &NOT_HELD,
        35872 | 45880 => &ALREADY_HELD,
        45860 => &MODE,
        45863 | 45881 | 45867 => &OPERATOR,
        42783 | 42808 | 42809 => &STOPPED,
        38708 | 38713 | 38716 => &NO_FILE,
        42813 | 42816 => &NO_SYMBOL,
        38706 | 38719 | 42782 | 42804 | 38707 => &FULL_DISK,
        42786 | 42802 | 42803 => &PERS_ONLY,
        42810 | 42811 => &PROTECTED,
        45835 | 45858 | 45869 | 45851 => &BUSY,
        36648 | 36653 | 36654 => &REACH,
        36668 | 36670 | 36672 => &UNIT,
        35901 | 45861 => &OPTION,
        45870 => &NO_REQUEST,
        45871 => &LIMIT,
        45873 => &LOGGED_OFF,
        45866 | 45879 | 45883 => &UNKNOWN_NAME,
        _ => return None,
    })
}

impl Refusal {
    fn meaning(&self) -> &'static Meaning {
        let by_number = self.inner.and_then(of_number).or_else(|| self.number.and_then(of_number));
        by_number.unwrap_or(match self.status {
            // -1073414146: a general refusal, on RobotWare 6 also an unknown name.
            404 => &NO_FILE,
            410 => &GONE,
            400 if self.number == Some(-1_073_414_146) => &UNKNOWN_NAME,
            503 => &BUSY,
            _ => &OTHER,
        })
    }

    /// Stable code of the message.
    #[must_use]
    pub fn code(&self) -> &'static str {
        self.meaning().code
    }

    /// What to do next.
    #[must_use]
    pub fn help(&self) -> &'static str {
        self.meaning().help
    }

    /// What it means, with what the controller said where the number is not known.
    #[must_use]
    pub fn sentence(&self) -> String {
        let meaning = self.meaning();
        if meaning.code == OTHER.code && !self.message.is_empty() {
            return format!("{}: {}", meaning.sentence, self.message);
        }
        meaning.sentence.to_owned()
    }

    /// Whether the name, file or path is merely not there.
    #[must_use]
    pub fn is_not_there(&self) -> bool {
        [NO_FILE.code, NO_SYMBOL.code, UNKNOWN_NAME.code].contains(&self.code())
    }

    /// Whether a right that was to be given back is not held any more, or is another's by now.
    #[must_use]
    pub fn is_not_held(&self) -> bool {
        [NOT_HELD.code, HELD.code, NO_RIGHT.code].contains(&self.code())
    }

    /// Whether it is the refusal to take what is held already.
    #[must_use]
    pub fn is_held_already(&self) -> bool {
        self.code() == ALREADY_HELD.code
    }

    /// Whether the controller has no such kinematics request.
    #[must_use]
    pub fn is_not_offered(&self) -> bool {
        matches!(self.status, 404 | 405 | 410 | 501) || self.code() == OPTION.code
    }
}

/// The message without the place in ABB's sources (`..\file.cpp[547] `) and the numbers behind it; the last number of the form
/// `0xc004841d` in it.
pub(crate) fn tidy(message: &str) -> (String, Option<i64>) {
    let text = message.trim();
    let text = match (text.find(".cpp["), text.find("] ")) {
        (Some(at), Some(end)) if at < end => &text[end + 2..],
        _ => text,
    };
    let inner = text.rsplit_once("0xc0").and_then(|(_, hex)| {
        let digits: String = hex.chars().take_while(char::is_ascii_hexdigit).collect();
        let number = u32::from_str_radix(&format!("c0{digits}"), 16).ok()?;
        Some(i64::from(number) - (1 << 32))
    });
    let text = text.split(" code:").next().unwrap_or(text);
    (text.trim().to_owned(), inner)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn refusal(status: u16, number: i64, inner: Option<i64>) -> Refusal {
        Refusal { status, number: Some(number), inner, message: String::new() }
    }

    #[test]
    fn the_number_decides_and_not_the_status() {
        assert_eq!(refusal(403, -1_073_445_862, None).code(), "link::held");
        assert_eq!(refusal(403, -1_073_445_881, None).code(), "link::grant");
        assert_eq!(refusal(400, -1_073_442_816, None).code(), "link::no-symbol");
        assert_eq!(refusal(404, -1_073_438_713, None).code(), "link::no-file");
    }

    #[test]
    fn the_number_inside_a_message_is_read() {
        let (message, inner) =
            tidy(r"..\rapid\symbol.cpp[812] RAPID refused, new_code: 0xc004841d code:-1073414146 icode:-1");
        assert_eq!(message, "RAPID refused, new_code: 0xc004841d");
        assert_eq!(inner, Some(-1_073_445_859));
        assert_eq!(refusal(400, -1_073_414_146, inner).code(), "link::no-right");
    }
}
