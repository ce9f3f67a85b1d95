//! What was found, as RAPID to paste: tool, work object and load data, and each axis's offset with its warning.

use super::controller_data::{ControllerData, Declaration, elements};
use nalgebra::{Isometry3, Vector3};
use rapid_compensation::emit::{write_orient, write_pos};
use rapid_syntax::write_num;
use robot_model::deform::EffectKind;
use robot_model::deform::identified::{Identified, PayloadScaling};
use robot_model::robot::Axis;
use robot_model::units::{deg_from_rad, mm_from_m};
use std::fmt::Write as _;

/// Name of the module that the data stand in.
pub const MODULE: &str = "DriftpostFound";

/// Before anyone touches calibration offsets.
pub const WARNING: [&str; 6] = [
    "WARNING: do not type these into the calibration offsets of the controller before you have",
    "  - noted the present values and driven to the synchronisation marks,",
    "  - checked that the offset is the only cause: beside others it takes part of them,",
    "  - understood that EVERY program on this robot moves with a calibration offset,",
    "    also those whose points were touched up to fit the robot as it is.",
    "driftpost compensate --model corrects programs one by one and leaves the robot alone.",
];

/// By how much an axis stands further than the controller shows.
struct AxisOffset {
    axis: Axis,
    offset_rad: f64,
    /// One standard deviation, where it is known.
    sigma_rad: Option<f64>,
}

fn axis_offsets(model: &Identified) -> Vec<AxisOffset> {
    let of = |t: &robot_model::deform::identified::Term| {
        let value = t.values.first()?;
        Some(AxisOffset { axis: t.joint?, offset_rad: value.value, sigma_rad: value.sigma })
    };
    model.terms.iter().filter(|t| t.kind == EffectKind::JointOffset).filter_map(of).collect()
}

/// Each axis's offset in degrees and radians, with the warning; empty where none was found.
#[must_use]
pub fn axis_table(model: &Identified) -> String {
    let offsets = axis_offsets(model);
    let mut out = String::new();
    if offsets.is_empty() {
        return out;
    }
    out.push_str("axis offsets: the axis stands so much further than the controller shows\n");
    for AxisOffset { axis, offset_rad: rad, sigma_rad } in offsets {
        let sigma = sigma_rad.map_or_else(String::new, |s| format!(" (+- {:.5} deg)", deg_from_rad(s)));
        // a String takes everything
        let _ = writeln!(out, "  axis {axis}: {:+.5} deg = {rad:+.7} rad{sigma}", deg_from_rad(rad));
    }
    out.push_str("  axes 1 and 6: never seen, they lie in the base and the tool\n");
    for line in WARNING {
        let _ = writeln!(out, "{line}");
    }
    out
}

/// The RAPID; `None` where the model does not say how it was measured.
#[must_use]
pub fn rapid(model: &Identified, written: &ControllerData) -> Option<String> {
    let mounting = model.mounting.as_ref()?;
    let target_m = *mounting.tools_m.first()?;
    let mut out = format!("MODULE {MODULE}\n");
    let comment = |out: &mut String, text: &str| {
        let _ = writeln!(out, "  ! {}", ascii(text));
    };
    comment(
        &mut out,
        &format!("Found by driftpost {} in {} of {}", env!("CARGO_PKG_VERSION"), model.data, model.robot),
    );
    comment(
        &mut out,
        "Goes with programs compensated by the same model. Paste what you need, keep the old values.",
    );
    out.push('\n');
    tool(&mut out, written, target_m);
    wobj(&mut out, written, &mounting.instrument_from_base.inverse());
    load(&mut out, written, model);
    for line in axis_table(model).lines() {
        comment(&mut out, line);
    }
    out.push_str("ENDMODULE\n");
    Some(out)
}

fn tool(out: &mut String, written: &ControllerData, target_m: Vector3<f64>) {
    let [x, y, z] = [target_m.x, target_m.y, target_m.z].map(mm_from_m);
    let _ = writeln!(out, "  ! The measured target on the flange: {x:.3}, {y:.3}, {z:.3} mm.");
    let parts = written.tool.as_ref().and_then(|Declaration { name, value }| {
        let [held, frame, load] = <[&str; 3]>::try_from(elements(value)?).ok()?;
        let [place, turn] = <[&str; 2]>::try_from(elements(frame)?).ok()?;
        let numbers: Vec<f64> = elements(place)?.iter().map(|n| n.parse().ok()).collect::<Option<_>>()?;
        let [x, y, z] = numbers[..] else { return None };
        Some((name, held, Vector3::new(x, y, z).map(robot_model::units::m_from_mm), turn, load))
    });
    let Some((name, held, tcp_m, turn, load)) = parts else {
        out.push_str(
            "  ! Its load is a stand-in: put in your tool's own. --tooldata NAME=[...] keeps yours.\n",
        );
        let value = pos(target_m);
        let _ = writeln!(
            out,
            "  PERS tooldata tMeasured:=[TRUE,[{value},[1,0,0,0]],[1,[0,0,1],[1,0,0,0],0,0,0]];\n"
        );
        return;
    };
    let (corrected_m, why) = match written.tool_m {
        Some(believed_m) => {
            (tcp_m + target_m - believed_m, "moved as the target has, from where --tool put it")
        }
        None => (target_m, "put where the target is: give --tool where they are not the same"),
    };
    let _ = writeln!(out, "  ! {}: {why}.", ascii(name));
    let _ = writeln!(out, "  PERS tooldata {name}:=[{held},[{},{turn}],{load}];\n", pos(corrected_m));
}

fn wobj(out: &mut String, written: &ControllerData, base_from_instrument: &Isometry3<f64>) {
    out.push_str("  ! The instrument's frame in the robot's base: points measured in it are targets in this work object.\n");
    let frame = frame(base_from_instrument);
    let parts = written.wobj.as_ref().and_then(|Declaration { name, value }| {
        let [held, fixed, unit, _, object] = <[&str; 5]>::try_from(elements(value)?).ok()?;
        Some((name, held, fixed, unit, object))
    });
    let _ = match parts {
        Some((name, held, fixed, unit, object)) => {
            writeln!(out, "  PERS wobjdata {name}:=[{held},{fixed},{unit},{frame},{object}];\n")
        }
        None => {
            writeln!(out, "  PERS wobjdata wInstrument:=[FALSE,TRUE,\"\",{frame},[[0,0,0],[1,0,0,0]]];\n")
        }
    };
}

fn load(out: &mut String, written: &ControllerData, model: &Identified) {
    let of = |scaling: PayloadScaling| -> f64 {
        let terms =
            model.terms.iter().filter(|t| t.kind == EffectKind::PayloadMass && t.payload_scaling == scaling);
        terms.map(|t| t.value(0)).sum()
    };
    let (tool_kg, heavier_kg, share) =
        (of(PayloadScaling::Always), of(PayloadScaling::WhereLoaded), of(PayloadScaling::PerKilogram));
    if tool_kg != 0.0 {
        let _ = writeln!(
            out,
            "  ! The tool itself pulls as {tool_kg:+.3} kg more than its tooldata says: weigh it."
        );
    }
    if heavier_kg == 0.0 && share == 0.0 {
        out.push_str("  ! No wrong load was found.\n");
        if let Some(Declaration { name, value }) = &written.load {
            let _ = writeln!(out, "  PERS loaddata {name}:={value};");
        }
        out.push('\n');
        return;
    }
    let kilograms = (heavier_kg != 0.0).then(|| format!("{heavier_kg:+.3} kg"));
    let per_cent = (share != 0.0).then(|| format!("{:+.1} %", 100.0 * share));
    let more: Vec<String> = kilograms.into_iter().chain(per_cent).collect();
    let _ = writeln!(
        out,
        "  ! What hangs there pulls as {} more than was declared would, or with its centre of gravity elsewhere:\n  \
         ! weigh it and balance it; the centre of gravity below is the one that was declared.",
        more.join(" and ")
    );
    let parts = written.load.as_ref().and_then(|Declaration { name, value }| {
        let all = elements(value)?;
        let declared_kg: f64 = all.first()?.parse().ok()?;
        Some((name, declared_kg + heavier_kg + share * declared_kg, all[1..].join(",")))
    });
    if let Some((name, mass_kg, rest)) = parts.filter(|(_, mass_kg, _)| *mass_kg > 0.0) {
        let _ = writeln!(out, "  PERS loaddata {name}:=[{},{rest}];", number(mass_kg));
    } else {
        out.push_str("  ! --loaddata NAME=[...] writes your load data with the corrected mass.\n");
    }
    out.push('\n');
}

fn ascii(text: &str) -> String {
    text.chars().map(|c| if c.is_ascii_graphic() || c == ' ' { c } else { '?' }).take(200).collect()
}

fn text<T>(write: impl FnOnce(&mut Vec<u8>) -> T) -> String {
    let mut out = Vec::new();
    write(&mut out);
    String::from_utf8_lossy(&out).into_owned()
}

fn number(value: f64) -> String {
    text(|out| write_num(out, value))
}

fn pos(at_m: Vector3<f64>) -> String {
    text(|out| write_pos(out, at_m.into()))
}

fn frame(of: &Isometry3<f64>) -> String {
    let q = of.rotation;
    let turn = text(|out| write_orient(out, [q.w, q.i, q.j, q.k]));
    format!("[{},{turn}]", pos(of.translation.vector))
}

#[cfg(test)]
mod tests {
    use super::*;
    use nalgebra::Isometry3;
    use robot_model::deform::identified::{Estimate, Mounting, Term};

    /// Six kilograms of which a seventh too little is declared are 6.857; half a kilogram wherever something hangs is half of one; what the
    /// tool weighs is no matter of the load.
    #[test]
    fn a_load_is_corrected_by_kilograms_or_by_its_share() {
        let written = |value: f64, payload_scaling: PayloadScaling| {
            let values = vec![Estimate { value, sigma: None }];
            let term = Term { payload_scaling, ..Term::plain(EffectKind::PayloadMass, None, values) };
            let mounting = Mounting {
                instrument_from_base: Isometry3::identity(),
                tools_m: vec![Vector3::zeros()],
                payload_m: None,
            };
            let model = Identified { terms: vec![term], mounting: Some(mounting), ..Identified::default() };
            let load = Declaration::load("myLoad=[6,[0,0,50],[1,0,0,0],0,0,0]").unwrap();
            let data = ControllerData { tool: None, wobj: None, load: Some(load), tool_m: None };
            rapid(&model, &data).unwrap()
        };
        let seventh = written(1.0 / 7.0, PayloadScaling::PerKilogram);
        assert!(seventh.contains("myLoad:=[6.857") && seventh.contains("as +14.3 % more"), "{seventh}");
        let half = written(0.5, PayloadScaling::WhereLoaded);
        assert!(half.contains("myLoad:=[6.5,") && half.contains("as +0.500 kg more"), "{half}");
        let tool = written(0.5, PayloadScaling::Always);
        assert!(tool.contains("myLoad:=[6,") && tool.contains("No wrong load"), "{tool}");
        assert!(tool.contains("The tool itself pulls as +0.500 kg more"), "{tool}");
    }
}
