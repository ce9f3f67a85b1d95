//! Straight-line RAPID: sums of products without what is zero or one.

use rapid_syntax::write_num;

/// A number as RAPID text.
pub(super) fn num(value: f64) -> String {
    let mut out = Vec::new();
    write_num(&mut out, value);
    String::from_utf8_lossy(&out).into_owned()
}

/// What a number as RAPID text would be is nothing.
pub(super) fn is_nothing(value: f64) -> bool {
    num(value) == "0"
}

/// A summand: a constant times a factor; an empty factor is 1.
pub(super) type Summand = (f64, String);

/// `a*x+b*y-z`; empty where nothing is left.
pub(super) fn sum(summands: &[Summand]) -> String {
    let mut text = String::new();
    for (by, factor) in summands {
        if is_nothing(*by) {
            continue;
        }
        if *by < 0.0 {
            text.push('-');
        } else if !text.is_empty() {
            text.push('+');
        }
        let size = num(by.abs());
        match (factor.as_str(), size.as_str()) {
            ("", _) => text.push_str(&size),
            (factor, "1") => text.push_str(factor),
            (factor, _) => text.push_str(&format!("{size}*{factor}")),
        }
    }
    text
}

/// Summands in one statement, so that no line grows long.
const IN_A_LINE: usize = 4;

/// Statements of a routine's body.
#[derive(Debug, Default)]
pub(super) struct Body {
    lines: Vec<String>,
}

/// Three numbers that are variables, or known to be zero and not yet written.
#[derive(Clone, Debug)]
pub(super) struct Triple {
    names: [String; 3],
    written: [bool; 3],
    /// What is zero now has been something: its variable still holds that.
    stale: [bool; 3],
}

impl Triple {
    /// Zero, in variables of these names with x, y and z at the end.
    pub(super) fn zero(stem: &str) -> Self {
        Self {
            names: ["x", "y", "z"].map(|axis| format!("{stem}{axis}")),
            written: [false; 3],
            stale: [false; 3],
        }
    }

    /// A component, where it is not known to be zero.
    pub(super) fn get(&self, k: usize) -> Option<&str> {
        self.written[k].then_some(self.names[k].as_str())
    }

    /// Whether all are known to be zero.
    pub(super) fn is_zero(&self) -> bool {
        self.written == [false; 3]
    }

    /// A component of the vector product with a constant.
    pub(super) fn cross(&self, by: &[f64; 3], k: usize) -> Vec<Summand> {
        let (i, j) = ((k + 1) % 3, (k + 2) % 3);
        [self.times(i, by[j]), self.times(j, -by[i])].into_iter().flatten().collect()
    }

    /// A component times a constant, as a summand.
    pub(super) fn times(&self, k: usize, by: f64) -> Option<Summand> {
        self.get(k).map(|name| (by, name.to_owned()))
    }
}

impl Body {
    /// The statements, each indented as in a routine.
    pub(super) fn into_lines(self) -> Vec<String> {
        self.lines
    }

    /// A line as it is.
    pub(super) fn line(&mut self, text: impl AsRef<str>) {
        self.lines.push(format!("    {}", text.as_ref()));
    }

    /// Assigns a sum: `to := summands`.
    pub(super) fn set(&mut self, to: &str, summands: &[Summand]) {
        self.add(to, false, summands);
    }

    /// The same where nothing may be left: then zero.
    pub(super) fn set_always(&mut self, to: &str, summands: &[Summand]) {
        if !self.add(to, false, summands) {
            self.line(format!("{to}:=0;"));
        }
    }

    /// Assigns a sum in one statement, over as many lines as it takes.
    pub(super) fn set_at_once(&mut self, to: &str, summands: &[Summand]) {
        let parts: Vec<String> =
            summands.chunks(IN_A_LINE).map(sum).filter(|part| !part.is_empty()).collect();
        for (k, part) in parts.iter().enumerate() {
            let before = match k {
                0 => format!("{to}:="),
                _ if part.starts_with('-') => "  ".to_owned(),
                _ => "  +".to_owned(),
            };
            let end = if k + 1 == parts.len() { ";" } else { "" };
            self.line(format!("{before}{part}{end}"));
        }
    }

    /// `to := [to +] summands`, in statements that are not long; whether anything was written.
    pub(super) fn add(&mut self, to: &str, mut has: bool, summands: &[Summand]) -> bool {
        let kept: Vec<Summand> = summands.iter().filter(|(by, _)| !is_nothing(*by)).cloned().collect();
        for some in kept.chunks(IN_A_LINE) {
            let text = sum(some);
            let own = match (has, text.starts_with('-')) {
                (false, _) => "",
                (true, true) => to,
                (true, false) => &format!("{to}+"),
            };
            self.line(format!("{to}:={own}{text};"));
            has = true;
        }
        has
    }

    /// Adds summands to a component.
    pub(super) fn increase(&mut self, to: &mut Triple, k: usize, summands: &[Summand]) {
        to.written[k] = self.add(&to.names[k].clone(), to.written[k], summands);
    }

    /// `of := rotation * of`, rows first.
    pub(super) fn rotate(&mut self, of: &mut Triple, rotation: &[[f64; 3]; 3]) {
        let rows: [Vec<Summand>; 3] = rotation.map(|row| {
            let all = row.iter().enumerate().filter(|(_, by)| !is_nothing(**by));
            all.filter_map(|(j, by)| of.times(j, *by)).collect()
        });
        let was = of.clone();
        let same = |k: usize| rows[k].len() == 1 && num(rows[k][0].0) == "1" && rows[k][0].1 == was.names[k];
        let changed: Vec<usize> =
            (0..3).filter(|&k| !same(k) && (was.written[k] || !rows[k].is_empty())).collect();
        // A new value may stand in place of the old one at once where no other row still needs it.
        let mut late = Vec::new();
        for (at, &k) in changed.iter().enumerate() {
            of.written[k] = !rows[k].is_empty();
            of.stale[k] |= was.written[k];
            let needed =
                changed[at + 1..].iter().any(|&i| rows[i].iter().any(|(_, name)| *name == was.names[k]));
            if !of.written[k] {
                continue;
            }
            if needed {
                let name = format!("tc{}", ["A", "B", "C"][k]);
                self.set(&name, &rows[k]);
                late.push((k, name));
            } else {
                self.set(&was.names[k], &rows[k]);
            }
        }
        for (k, name) in late {
            self.line(format!("{}:={name};", was.names[k]));
        }
    }

    /// Has the variables of what is zero hold zero, where what follows reads all three.
    pub(super) fn zero_stale(&mut self, of: &Triple) {
        for k in (0..3).filter(|&k| of.stale[k] && !of.written[k]) {
            self.line(format!("{}:=0;", of.names[k]));
        }
    }

    /// `of := Rot(axis, angle) * of` about x, y or z; `sin` and `cos` are names, `sign` is the sign of the angle.
    pub(super) fn turn(&mut self, of: &mut Triple, axis: usize, sign: f64, [sin, cos]: [&str; 2]) {
        let (b, c) = ((axis + 1) % 3, (axis + 2) % 3);
        let product =
            |factor: &str, k: usize, by: f64| of.get(k).map(|name| (by, format!("{factor}*{name}")));
        let new_b: Vec<Summand> =
            [product(cos, b, 1.0), product(sin, c, -sign)].into_iter().flatten().collect();
        let new_c: Vec<Summand> =
            [product(cos, c, 1.0), product(sin, b, sign)].into_iter().flatten().collect();
        if new_b.is_empty() {
            return;
        }
        // Where one of the two is zero, the other's old value gives both.
        let (first, second, news) =
            if of.written[b] && !of.written[c] { (c, b, [new_c, new_b]) } else { (b, c, [new_b, new_c]) };
        let (one, two) = (of.names[first].clone(), of.names[second].clone());
        if of.written[first] {
            self.set("tcA", &news[0]);
            self.set(&two, &news[1]);
            self.line(format!("{one}:=tcA;"));
        } else {
            self.set(&one, &news[0]);
            self.set(&two, &news[1]);
        }
        of.written[first] = true;
        of.written[second] = true;
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn lines(body: Body) -> Vec<String> {
        body.into_lines().iter().map(|line| line.trim().to_owned()).collect()
    }

    #[test]
    fn sums_leave_out_what_is_nothing_or_one() {
        let x = |by: f64| (by, "tcX".to_owned());
        assert_eq!(sum(&[x(1.0), (0.0, "tcY".to_owned()), (-1.0, "tcZ".to_owned())]), "tcX-tcZ");
        assert_eq!(sum(&[x(-0.5), (2.0, String::new())]), "-0.5*tcX+2");
        assert_eq!(sum(&[x(1e-12)]), "");
    }

    #[test]
    fn a_turn_writes_nothing_of_what_is_zero() {
        let (mut body, mut of) = (Body::default(), Triple::zero("tcU"));
        body.increase(&mut of, 2, &[(1.0, String::new())]);
        body.turn(&mut of, 2, 1.0, ["tcS", "tcC"]);
        body.turn(&mut of, 1, -1.0, ["tcS", "tcC"]);
        assert_eq!(lines(body), ["tcUz:=1;", "tcUx:=-tcS*tcUz;", "tcUz:=tcC*tcUz;"]);
    }

    /// A quarter turn about y of what has a z alone: z is zero then, and its variable is told so before it is read.
    #[test]
    fn what_has_become_zero_is_written_before_it_is_read() {
        let (mut body, mut of) = (Body::default(), Triple::zero("tcD"));
        body.increase(&mut of, 2, &[(5.0, String::new())]);
        body.rotate(&mut of, &[[0.0, 0.0, -1.0], [0.0, 1.0, 0.0], [1.0, 0.0, 0.0]]);
        body.zero_stale(&of);
        assert_eq!(lines(body), ["tcDz:=5;", "tcDx:=-tcDz;", "tcDz:=0;"]);
    }

    #[test]
    fn a_quarter_turn_is_an_exchange_that_loses_nothing() {
        let (mut body, mut of) = (Body::default(), Triple::zero("tcD"));
        body.increase(&mut of, 0, &[(3.0, String::new())]);
        body.increase(&mut of, 2, &[(5.0, String::new())]);
        body.rotate(&mut of, &[[0.0, 0.0, -1.0], [0.0, 1.0, 0.0], [1.0, 0.0, 0.0]]);
        assert_eq!(lines(body), ["tcDx:=3;", "tcDz:=5;", "tcA:=-tcDz;", "tcDz:=tcDx;", "tcDx:=tcA;"]);
        assert_eq!(of.get(1), None);
    }
}
