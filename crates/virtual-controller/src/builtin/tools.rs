//! Tool, work object and load of a move, as they are at that moment.

use crate::code::{Expr, ExprKind, NameRef};
use crate::frame::{self, Setup};
use crate::interpreter::{Args, Interpreter};
use crate::machine::{Access, DataRoot, Machine};
use crate::outcome::{Fault, fatal};
use crate::predefined;
use crate::value::Value;
use nalgebra::{Isometry3, Point3, Vector3};
use robot_model::deform::Payload;
use robot_model::units::m_from_mm;

/// Tool and work object as values; both must be persistent data.
pub(super) fn tool_and_object(
    vm: &mut Interpreter<'_>,
    tool: &Expr,
    wobj: Option<&Expr>,
) -> Result<(Value, Value), Fault> {
    let tool = frame_data(vm, tool, "tool0")?;
    let wobj = match wobj {
        Some(e) => frame_data(vm, e, "wobj0")?,
        None => predefined::known(&vm.program.types, "wobj0"),
    };
    Ok((tool, wobj))
}

/// The value of a tool or work object argument; `plain` is what stands in for one that is declared nowhere.
fn frame_data(vm: &mut Interpreter<'_>, expr: &Expr, plain: &str) -> Result<Value, Fault> {
    let ty = match plain {
        "tool0" => vm.program.types.tooldata.clone(),
        _ => vm.program.types.wobjdata.clone(),
    };
    if let ExprKind::Name(named) = &expr.kind
        && let NameRef { name, spelt, .. } = named
        && vm.resolve_datum(named).is_none()
        && predefined::constant(&vm.program.types, name).is_none()
    {
        vm.report("controller", format!("{spelt} is declared nowhere; taken as {plain}"));
        return Ok(predefined::known(&vm.program.types, plain));
    }
    let place = vm.data_ref(expr)?.map(|(place, _)| place);
    if let Some(place) = &place
        && vm.access(place) != Access::Persistent
        && matches!(place.root, DataRoot::Data(_))
    {
        return fatal("a tool or work object must be PERS");
    }
    match place {
        // An index is worked out once: a function in it may count.
        Some(place) if !matches!(expr.kind, ExprKind::Name(_) | ExprKind::Local(_)) => vm.read(&place),
        _ => vm.eval_as(expr, &ty),
    }
}

/// Who holds what for a tool and a work object argument.
pub(super) fn setup_of(vm: &mut Interpreter<'_>, tool: &Expr, wobj: Option<&Expr>) -> Result<Setup, Fault> {
    let (tool, wobj) = tool_and_object(vm, tool, wobj)?;
    setup((&tool, None), &wobj, vm.machine)
}

/// What `\TLoad` of a move says: the numbers of the whole load on the flange, its centre in the flange's frame as a tool's own. It stands for the
/// tool's load and for what is gripped; `load0` counts as not given (ABB, RAPID reference manual, MoveL).
pub(super) fn total_load(vm: &mut Interpreter<'_>, args: &Args<'_>) -> Result<Option<Vec<f64>>, Fault> {
    let Some(load) = args.named("tload") else { return Ok(None) };
    let ty = vm.program.types.loaddata.clone();
    let load = vm.eval_as(load, &ty)?.numbers();
    Ok(Some(load).filter(|load| load.first().is_some_and(|mass_kg| *mass_kg > NO_LOAD_KG)))
}

/// Who holds what, by the values of tool and work object and what hangs on the flange of `machine`: where a move says so its total load.
pub(super) fn setup(
    (tool, total_load): (&Value, Option<Vec<f64>>),
    wobj: &Value,
    machine: &Machine,
) -> Result<Setup, Fault> {
    let object = wobj.numbers();
    let held = tool.numbers();
    let gripped = if total_load.is_some() { Payload::default() } else { machine.gripped };
    let load = total_load.as_deref().or(held.get(7..)).unwrap_or_default();
    let mut setup = Setup {
        payload: payload(load.get(..4).unwrap_or_default()),
        tool_held: tool.parts().first().and_then(Value::boolean).unwrap_or(true),
        frame_from_tcp: frame::isometry_of(&held)?,
        frame_from_object: frame::isometry_of(&object)?
            * frame::isometry_of(object.get(7..14).unwrap_or_default())?,
    };
    // What is gripped has its centre in the frame of the tool, or of the work object, that the robot holds.
    let flange_from_holder = if setup.tool_held { &setup.frame_from_tcp } else { &setup.frame_from_object };
    setup.payload = match machine.payload_kg {
        // Where the load's own centre is, however little it weighs.
        Some(mass_kg) => {
            let cog_mm = load.get(1..4).and_then(|cog| <[f64; 3]>::try_from(cog).ok()).unwrap_or_default();
            Payload { mass_kg, cog_m: cog_mm.map(m_from_mm) }
        }
        None => combined_load(setup.payload, gripped, flange_from_holder),
    };
    Ok(setup)
}

/// A tool of a gram, as tool0, or less is none.
const NO_LOAD_KG: f64 = 0.001_001;

/// A tool's own load with what is gripped, whose centre stands in the frame of what holds it.
fn combined_load(own: Payload, gripped: Payload, flange_from_holder: &Isometry3<f64>) -> Payload {
    if gripped.mass_kg <= 0.0 {
        return own;
    }
    let at_m = (flange_from_holder * Point3::from(gripped.cog_m)).coords;
    let mass_kg = own.mass_kg + gripped.mass_kg;
    let cog_m = (Vector3::from(own.cog_m) * own.mass_kg + at_m * gripped.mass_kg) / mass_kg;
    Payload { mass_kg, cog_m: cog_m.into() }
}

/// Load data's mass and centre of gravity.
pub(super) fn payload(load: &[f64]) -> Payload {
    match *load {
        [mass_kg, x, y, z] if mass_kg > NO_LOAD_KG => Payload { mass_kg, cog_m: [x, y, z].map(m_from_mm) },
        _ => Payload::default(),
    }
}
