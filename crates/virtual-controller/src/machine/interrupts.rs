//! Interrupts: which trap runs when.

use crate::ids::RoutineId;

/// An interrupt that is connected to a trap.
#[derive(Debug)]
pub(crate) struct Interrupt {
    pub number: f32,
    /// The routine to run.
    pub trap: RoutineId,
    /// Period and next time in steady seconds, for a timer.
    pub timer: Option<(f64, f64)>,
    pub single: bool,
    pub asleep: bool,
}

/// All interrupts that are connected.
#[derive(Debug, Default)]
pub(crate) struct Interrupts {
    pub list: Vec<Interrupt>,
    /// The number of the interrupt served last.
    pub intno: f32,
}

impl Interrupts {
    /// The number that the next interrupt gets.
    pub(crate) fn next_number(&self) -> f32 {
        self.list.iter().map(|i| i.number).fold(0.0, f32::max) + 1.0
    }

    /// Connects a trap to an interrupt.
    pub(crate) fn connect(&mut self, number: f32, trap: RoutineId) {
        self.list.push(Interrupt { number, trap, timer: None, single: false, asleep: false });
    }

    /// The trap of an interrupt that is due at `now_s` of the steady clock; its timer is set on.
    pub(crate) fn take_due(&mut self, now_s: f64) -> Option<RoutineId> {
        let due = |i: &&mut Interrupt| !i.asleep && i.timer.is_some_and(|(_, at_s)| at_s <= now_s);
        let interrupt = self.list.iter_mut().find(due)?;
        interrupt.timer = match interrupt.timer {
            // What fell due while a trap ran is served once.
            Some((period_s, at_s)) if !interrupt.single => {
                let missed = ((now_s - at_s) / period_s).floor().max(0.0);
                Some((period_s, at_s + (missed + 1.0) * period_s))
            }
            _ => None,
        };
        self.intno = interrupt.number;
        Some(interrupt.trap)
    }

    /// When a timer is due next, steady seconds; `None` where none is to come.
    pub(crate) fn next_due_s(&self) -> Option<f64> {
        let awake = self.list.iter().filter(|interrupt| !interrupt.asleep);
        awake.filter_map(|interrupt| Some(interrupt.timer?.1)).reduce(f64::min)
    }

    /// The trap of the interrupt that was due first up to `until_s` of the steady clock; its timer is set on by one period.
    pub(crate) fn take_first(&mut self, until_s: f64) -> Option<RoutineId> {
        let at_s = |interrupt: &Interrupt| interrupt.timer.map_or(f64::INFINITY, |(_, at_s)| at_s);
        let awake = self.list.iter_mut().filter(|interrupt| !interrupt.asleep && at_s(interrupt) <= until_s);
        let interrupt = awake.min_by(|a, b| at_s(a).total_cmp(&at_s(b)))?;
        let (period_s, at_s) = interrupt.timer?;
        interrupt.timer = (!interrupt.single).then_some((period_s, at_s + period_s));
        self.intno = interrupt.number;
        Some(interrupt.trap)
    }

    /// Lets interrupts of a number, or all, sleep or wake.
    pub(crate) fn set_asleep(&mut self, number: Option<f32>, asleep: bool) {
        for i in self.list.iter_mut().filter(|i| number.is_none_or(|n| i.number == n)) {
            i.asleep = asleep;
        }
    }
}
