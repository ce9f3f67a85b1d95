//! Instructions and functions of the controller, one theme a file; each theme says whether a name is its own.

pub(super) mod clock;
pub(super) mod data;
pub(super) mod geometry;
pub(super) mod math;
pub(super) mod modules;
pub(super) mod moves;
pub(super) mod signals;
pub(super) mod text;

use super::call::Args;
use super::controller::Controller;
use super::ir::{Call, Name};
use super::outcome::Fault;
use super::value::{Type, Value};

/// What a theme answers: `None` where the name is not its own.
pub(super) type Known<T> = Result<Option<T>, Fault>;
/// The instructions or functions of one theme.
type Theme<T> = fn(&mut Controller, &str, &Args<'_>) -> Known<T>;

impl Controller {
    /// An instruction of the controller; one it does not know is listed and passed over.
    pub(super) fn instruction(&mut self, name: &Name, spelt: &str, call: &Call) -> Result<(), Fault> {
        let args = self.args(call);
        let themes: [Theme<()>; 5] = [
            Self::move_instruction,
            Self::data_instruction,
            Self::clock_instruction,
            Self::signal_instruction,
            Self::module_instruction,
        ];
        for theme in themes {
            if theme(self, name, &args)?.is_some() {
                return Ok(());
            }
        }
        self.unknown.insert(spelt.to_owned());
        Ok(())
    }

    /// A function of the controller; one it does not know is listed and gives 0, FALSE or "".
    pub(super) fn function(
        &mut self,
        name: &Name,
        spelt: &str,
        call: &Call,
        want: Option<&Type>,
    ) -> Result<Value, Fault> {
        let args = self.args(call);
        // With each theme, whether its functions calculate.
        let themes: [(Theme<Value>, bool); 7] = [
            (Self::math_function, true),
            (Self::data_function, false),
            (Self::clock_function, false),
            (Self::text_function, false),
            (Self::geometry_function, true),
            (Self::signal_function, false),
            (Self::module_function, false),
        ];
        for (theme, calculates) in themes {
            if let Some(value) = theme(self, name, &args)? {
                if calculates {
                    self.effort.count_function(name);
                }
                return Ok(value);
            }
        }
        self.unknown.insert(spelt.to_owned());
        Ok(want.map_or(Value::Num(0.0), Type::initial))
    }
}
