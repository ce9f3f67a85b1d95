//! RAPID's reserved words and how names compare: without regard to case, over ASCII and ISO 8859-1.

/// A reserved word of RAPID.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[allow(missing_docs, reason = "each is the word it is named for")]
pub enum Word {
    Alias,
    And,
    Backward,
    Case,
    Connect,
    Const,
    Default,
    Div,
    Do,
    Else,
    ElseIf,
    EndFor,
    EndFunc,
    EndIf,
    EndModule,
    EndProc,
    EndRecord,
    EndTest,
    EndTrap,
    EndWhile,
    Error,
    Exit,
    False,
    For,
    From,
    Func,
    Goto,
    If,
    InOut,
    Local,
    Mod,
    Module,
    NoStepIn,
    Not,
    NoView,
    Or,
    Pers,
    Proc,
    Raise,
    ReadOnly,
    Record,
    Retry,
    Return,
    Step,
    SysModule,
    Test,
    Then,
    To,
    Trap,
    True,
    TryNext,
    Undo,
    Var,
    ViewOnly,
    While,
    With,
    Xor,
}

/// Where in [`WORDS`] the one word stands that a name with this [`mark`] can be; past its end where none can.
static PLACES: [u8; 256] = {
    let mut places = [u8::MAX; 256];
    let mut n = 0;
    while n < WORDS.len() {
        let place = &mut places[mark(WORDS[n].0) as usize];
        assert!(*place == u8::MAX, "two reserved words have the same mark");
        *place = n as u8;
        n += 1;
    }
    places
};

/// Made of a name's length and of its first, middle and last byte, in any case; with these factors no two reserved words have the
/// same.
#[inline(always)]
const fn mark(name: &[u8]) -> u8 {
    let [first, .., last] = name else { return 0 };
    let factors = [
        (*first | 0x20, 53),
        (name[name.len() / 2] | 0x20, 17),
        (*last | 0x20, 31),
        (name.len() as u8, 13_u8),
    ];
    let mut sum = 0_u8;
    let mut n = 0;
    while n < factors.len() {
        sum = sum.wrapping_add(factors[n].0.wrapping_mul(factors[n].1));
        n += 1;
    }
    sum
}

const WORDS: [(&[u8], Word); 57] = {
    use Word::*;
    [
        (b"alias", Alias),
        (b"and", And),
        (b"backward", Backward),
        (b"case", Case),
        (b"connect", Connect),
        (b"const", Const),
        (b"default", Default),
        (b"div", Div),
        (b"do", Do),
        (b"else", Else),
        (b"elseif", ElseIf),
        (b"endfor", EndFor),
        (b"endfunc", EndFunc),
        (b"endif", EndIf),
        (b"endmodule", EndModule),
        (b"endproc", EndProc),
        (b"endrecord", EndRecord),
        (b"endtest", EndTest),
        (b"endtrap", EndTrap),
        (b"endwhile", EndWhile),
        (b"error", Error),
        (b"exit", Exit),
        (b"false", False),
        (b"for", For),
        (b"from", From),
        (b"func", Func),
        (b"goto", Goto),
        (b"if", If),
        (b"inout", InOut),
        (b"local", Local),
        (b"mod", Mod),
        (b"module", Module),
        (b"nostepin", NoStepIn),
        (b"not", Not),
        (b"noview", NoView),
        (b"or", Or),
        (b"pers", Pers),
        (b"proc", Proc),
        (b"raise", Raise),
        (b"readonly", ReadOnly),
        (b"record", Record),
        (b"retry", Retry),
        (b"return", Return),
        (b"step", Step),
        (b"sysmodule", SysModule),
        (b"test", Test),
        (b"then", Then),
        (b"to", To),
        (b"trap", Trap),
        (b"true", True),
        (b"trynext", TryNext),
        (b"undo", Undo),
        (b"var", Var),
        (b"viewonly", ViewOnly),
        (b"while", While),
        (b"with", With),
        (b"xor", Xor),
    ]
};

impl Word {
    /// How many words end or divide a block inside a routine.
    pub(super) const BLOCK_SLOTS: usize = 8;

    /// The reserved word these bytes spell, in any case.
    #[must_use]
    #[inline]
    pub fn of(name: &[u8]) -> Option<Self> {
        let &(spelled, word) = WORDS.get(usize::from(PLACES[usize::from(mark(name))]))?;
        name.eq_ignore_ascii_case(spelled).then_some(word)
    }

    /// Which of the words that end or divide a block this is.
    pub(super) fn block_slot(self) -> Option<usize> {
        Some(match self {
            Self::ElseIf => 0,
            Self::Else => 1,
            Self::EndIf => 2,
            Self::EndFor => 3,
            Self::EndWhile => 4,
            Self::Case => 5,
            Self::Default => 6,
            Self::EndTest => 7,
            _ => return None,
        })
    }

    /// Ends a routine's statements wherever it stands.
    pub(super) fn ends_statements(self) -> bool {
        matches!(
            self,
            Self::EndProc
                | Self::EndFunc
                | Self::EndTrap
                | Self::EndModule
                | Self::Proc
                | Self::Func
                | Self::Trap
                | Self::Local
                | Self::Record
                | Self::Alias
                | Self::Module
                | Self::Error
                | Self::Undo
                | Self::Backward
        )
    }

    /// Stands inside a statement and never begins one.
    pub(super) fn inside_statement(self) -> bool {
        use Word::*;
        matches!(
            self,
            And | Div | Do | False | From | InOut | Mod | Not | Or | Step | Then | To | True | With | Xor
        )
    }
}

/// Whether `name` is a reserved word, in any case.
#[must_use]
pub fn is_reserved(name: &[u8]) -> bool {
    Word::of(name).is_some()
}

/// A name as it is compared: ASCII, ISO 8859-1 and (for RobotWare 7) the same letters in UTF-8 in lower case.
#[must_use]
pub fn fold(name: &[u8]) -> Vec<u8> {
    folded(name).collect()
}

/// Whether two names are the same to RAPID.
#[must_use]
pub fn same_name(a: &[u8], b: &[u8]) -> bool {
    a.len() == b.len() && folded(a).eq(folded(b))
}

fn folded(name: &[u8]) -> impl Iterator<Item = u8> + '_ {
    name.iter().enumerate().map(|(i, &b)| {
        let before = i.checked_sub(1).and_then(|p| name.get(p)).copied();
        let after = name.get(i + 1).copied();
        match b {
            // À..Þ in UTF-8 are C3 80..9E; in ISO 8859-1 no letter follows 'Ã' as 80..BF
            0xC3 if after.is_some_and(|a| (0x80..=0xBF).contains(&a)) => b,
            0x80..=0x9E if before == Some(0xC3) && b != 0x97 => b + 0x20,
            0xC0..=0xDE if b != 0xD7 => b + 0x20,
            _ => b.to_ascii_lowercase(),
        }
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn reserved_words_are_known_in_any_case_and_only_they() {
        assert_eq!(Word::of(b"EndProc"), Some(Word::EndProc));
        assert!(WORDS.iter().all(|(w, word)| Word::of(&w.to_ascii_uppercase()) == Some(*word)));
        assert_eq!(Word::of(b"VIEWONLY"), Some(Word::ViewOnly));
        for no in [&b"MoveL"[..], b"z1", b"", b"endprocs", b"d_", b"I\x06", b"ENDMODULES"] {
            assert!(!is_reserved(no), "{no:?}");
        }
    }

    #[test]
    fn names_compare_without_case_in_ascii_latin1_and_utf8() {
        assert!(same_name(b"Tool_1", b"tOOL_1"));
        assert!(!same_name(b"tool1", b"tool2"));
        assert!(same_name(b"Gr\xD6\xDFe", b"gr\xF6\xDFe"), "Latin-1 Größe");
        assert!(same_name("GRÖSSE".as_bytes(), "größe".replace('ß', "ss").as_bytes()), "UTF-8");
        assert_eq!(fold(b"\xD7\xF7A"), b"\xD7\xF7a", "the signs of times and division are no letters");
        assert_eq!(fold("ÀÞ".as_bytes()), "àþ".as_bytes());
    }
}
