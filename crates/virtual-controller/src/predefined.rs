//! What a controller has before any module is loaded: record types, constants, error numbers.

use super::code::Name;
use super::value::{RecordType, Type, Value};
use std::collections::BTreeMap;
use std::rc::Rc;

/// Record types as `name: component type, ...` in the order in which they build on one another.
const RECORDS: &[(&str, &[(&str, &str)])] = &[
    ("pos", &[("x", "num"), ("y", "num"), ("z", "num")]),
    ("orient", &[("q1", "num"), ("q2", "num"), ("q3", "num"), ("q4", "num")]),
    ("pose", &[("trans", "pos"), ("rot", "orient")]),
    ("confdata", &[("cf1", "num"), ("cf4", "num"), ("cf6", "num"), ("cfx", "num")]),
    (
        "extjoint",
        &[
            ("eax_a", "num"),
            ("eax_b", "num"),
            ("eax_c", "num"),
            ("eax_d", "num"),
            ("eax_e", "num"),
            ("eax_f", "num"),
        ],
    ),
    (
        "robjoint",
        &[
            ("rax_1", "num"),
            ("rax_2", "num"),
            ("rax_3", "num"),
            ("rax_4", "num"),
            ("rax_5", "num"),
            ("rax_6", "num"),
        ],
    ),
    ("robtarget", &[("trans", "pos"), ("rot", "orient"), ("robconf", "confdata"), ("extax", "extjoint")]),
    ("jointtarget", &[("robax", "robjoint"), ("extax", "extjoint")]),
    (
        "loaddata",
        &[("mass", "num"), ("cog", "pos"), ("aom", "orient"), ("ix", "num"), ("iy", "num"), ("iz", "num")],
    ),
    ("tooldata", &[("robhold", "bool"), ("tframe", "pose"), ("tload", "loaddata")]),
    (
        "wobjdata",
        &[
            ("robhold", "bool"),
            ("ufprog", "bool"),
            ("ufmec", "string"),
            ("uframe", "pose"),
            ("oframe", "pose"),
        ],
    ),
    ("speeddata", &[("v_tcp", "num"), ("v_ori", "num"), ("v_leax", "num"), ("v_reax", "num")]),
    (
        "zonedata",
        &[
            ("finep", "bool"),
            ("pzone_tcp", "num"),
            ("pzone_ori", "num"),
            ("pzone_eax", "num"),
            ("zone_ori", "num"),
            ("zone_leax", "num"),
            ("zone_reax", "num"),
        ],
    ),
    ("progdisp", &[("pdisp", "pose"), ("eoffs", "extjoint")]),
];

/// Types that are another type by a second name.
const ALIASES: &[(&str, &str)] = &[
    ("errnum", "num"),
    ("intnum", "num"),
    ("dionum", "num"),
    ("byte", "num"),
    ("switch", "bool"),
    ("symnum", "num"),
    ("opnum", "num"),
    ("stoppoint", "num"),
    ("loadsession", "num"),
    ("errstr", "string"),
    ("triggios", "num"),
];

/// All built-in types by lower-case name.
pub(super) fn types() -> BTreeMap<Name, Type> {
    let mut types: BTreeMap<Name, Type> = [
        ("num", Type::Num),
        ("dnum", Type::Dnum),
        ("bool", Type::Bool),
        ("string", Type::Str),
        ("clock", Type::Clock),
    ]
    .into_iter()
    .map(|(n, t)| (n.into(), t))
    .collect();
    for (name, fields) in RECORDS {
        let fields = fields
            .iter()
            .filter_map(|(field, ty)| types.get(*ty).map(|ty| (Rc::from(*field), ty.clone())))
            .collect();
        let record = RecordType { name: (*name).into(), fields };
        types.insert((*name).into(), Type::Record(Rc::new(record)));
    }
    for (name, of) in ALIASES {
        if let Some(ty) = types.get(*of).cloned() {
            types.insert((*name).into(), ty);
        }
    }
    types
}

/// Built-in types by name, made once for the instructions that need them.
#[derive(Clone, Debug)]
pub(super) struct Types {
    pub robtarget: Type,
    pub jointtarget: Type,
    pub tooldata: Type,
    pub loaddata: Type,
    pub wobjdata: Type,
    pub speeddata: Type,
    pub zonedata: Type,
    pub pose: Type,
    pub extjoint: Type,
    pub progdisp: Type,
    pub pos: Type,
    pub orient: Type,
}

impl Types {
    pub(crate) fn new() -> Self {
        let all = types();
        let get = |name: &str| all.get(name).cloned().unwrap_or(Type::Num);
        Self {
            robtarget: get("robtarget"),
            jointtarget: get("jointtarget"),
            tooldata: get("tooldata"),
            loaddata: get("loaddata"),
            wobjdata: get("wobjdata"),
            speeddata: get("speeddata"),
            zonedata: get("zonedata"),
            pose: get("pose"),
            extjoint: get("extjoint"),
            progdisp: get("progdisp"),
            pos: get("pos"),
            orient: get("orient"),
        }
    }
}

/// Error numbers a program may meet; the numbers are this controller's own.
const ERRORS: &[&str] = &[
    "err_divzero",
    "err_roblimit",
    "err_outside_reach",
    "err_filnotfnd",
    "err_loaded",
    "err_unload",
    "err_prgmemfull",
    "err_ioerror",
    "err_loadno_inuse",
    "err_loadno_nouse",
    "err_reffault",
    "err_refunkdat",
    "err_refunkprc",
    "err_refunkfun",
    "err_callproc",
    "err_sigsupsearch",
    "err_norununit",
    "err_no_aliasio_def",
    "err_signal_undef",
    "err_wait_maxtime",
    "err_negarg",
    "err_strtoolng",
    "err_illraise",
    "err_pid_movestop",
    "err_whlsearch",
    "err_argvalerr",
    "err_argnotper",
    "err_argnotvar",
    "err_argname",
    "err_namespace",
    "err_alrdy_moving",
    "err_alrdycnt",
    "err_cnvnotct",
    "err_inomax",
    "err_robot_limit",
    "err_fnccnv",
    "err_overflow",
    "err_syntax",
    "err_path",
    "err_invdim",
    "err_bound",
    "err_orient_value",
    "err_movesup",
    "err_tp_dibreak",
    "err_tp_maxtime",
    "err_axis_in",
    "err_maxretry",
    "err_notequal",
    "err_unkino",
    "err_fileopen",
    "err_fileacc",
];

/// The number of an error name.
pub(super) fn error_number(name: &str) -> Option<f32> {
    ERRORS.iter().position(|e| *e == name).map(|i| 1001.0 + i as f32)
}

/// The name of an error number, in lower case.
pub(super) fn error_name(number: f32) -> Option<&'static str> {
    ERRORS.iter().enumerate().find(|(i, _)| 1001.0 + *i as f32 == number).map(|(_, n)| *n)
}

/// `v100`, `vmax` ...: `[v_tcp, v_ori, v_leax, v_reax]`.
const SPEEDS: &[u32] = &[
    5, 10, 20, 30, 40, 50, 60, 80, 100, 150, 200, 300, 400, 500, 600, 800, 1000, 1500, 2000, 2500, 3000,
    4000, 5000, 6000, 7000,
];

/// `z10` ...: `[pzone_tcp, pzone_ori, pzone_eax, zone_ori, zone_leax, zone_reax]`.
const ZONES: &[(&str, [f32; 6])] = &[
    ("z0", [0.3, 0.3, 0.3, 0.03, 0.3, 0.03]),
    ("z1", [1.0, 1.0, 1.0, 0.1, 1.0, 0.1]),
    ("z5", [5.0, 8.0, 8.0, 0.8, 8.0, 0.8]),
    ("z10", [10.0, 15.0, 15.0, 1.5, 15.0, 1.5]),
    ("z15", [15.0, 23.0, 23.0, 2.3, 23.0, 2.3]),
    ("z20", [20.0, 30.0, 30.0, 3.0, 30.0, 3.0]),
    ("z30", [30.0, 45.0, 45.0, 4.5, 45.0, 4.5]),
    ("z40", [40.0, 60.0, 60.0, 6.0, 60.0, 6.0]),
    ("z50", [50.0, 75.0, 75.0, 7.5, 75.0, 7.5]),
    ("z60", [60.0, 90.0, 90.0, 9.0, 90.0, 9.0]),
    ("z80", [80.0, 120.0, 120.0, 12.0, 120.0, 12.0]),
    ("z100", [100.0, 150.0, 150.0, 15.0, 150.0, 15.0]),
    ("z150", [150.0, 225.0, 225.0, 23.0, 225.0, 23.0]),
    ("z200", [200.0, 300.0, 300.0, 30.0, 300.0, 30.0]),
];

/// Fill a type with numbers in order; booleans FALSE, strings "".
pub(super) fn filled(ty: &Type, numbers: &mut impl Iterator<Item = f32>) -> Value {
    match ty {
        Type::Num => Value::Num(numbers.next().unwrap_or(0.0)),
        Type::Record(r) => {
            Value::Record(r.clone(), r.fields.iter().map(|(_, ty)| filled(ty, numbers)).collect())
        }
        other => other.initial(),
    }
}

/// The value of a name, where it is one that every controller knows.
pub(super) fn constant(types: &Types, name: &str) -> Option<Value> {
    let fill = |ty: &Type, numbers: &[f32]| filled(ty, &mut numbers.iter().copied());
    let with_flags = |value: Value, flags: &[(usize, bool)]| match value {
        Value::Record(r, mut parts) => {
            for (at, flag) in flags {
                if let Some(part) = parts.get_mut(*at) {
                    *part = Value::Bool(*flag);
                }
            }
            Value::Record(r, parts)
        }
        v => v,
    };
    Some(match name {
        "pi" => Value::num(std::f64::consts::PI),
        "tool0" => {
            let numbers = [0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 0.001, 0.0, 0.0, 0.001, 1.0, 0.0, 0.0, 0.0];
            with_flags(fill(&types.tooldata, &numbers), &[(0, true)])
        }
        "wobj0" => {
            let numbers = [0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0];
            with_flags(fill(&types.wobjdata, &numbers), &[(1, true)])
        }
        "load0" => match constant(types, "tool0")? {
            Value::Record(_, mut parts) => parts.pop()?,
            _ => return None,
        },
        "fine" => with_flags(fill(&types.zonedata, &[]), &[(0, true)]),
        "vmax" => fill(&types.speeddata, &[5000.0, 500.0, 5000.0, 1e3]),
        "str_digit" => Value::text("0123456789"),
        "str_upper" => Value::text("ABCDEFGHIJKLMNOPQRSTUVWXYZ"),
        "str_lower" => Value::text("abcdefghijklmnopqrstuvwxyz"),
        "str_white" => Value::text(" \t\r\n"),
        "diskhome" => Value::text("HOME:"),
        "low" => Value::Num(0.0),
        "high" => Value::Num(1.0),
        "eof_num" => Value::Num(1e10),
        "monday" => Value::Num(1.0),
        "tuesday" => Value::Num(2.0),
        "wednesday" => Value::Num(3.0),
        "thursday" => Value::Num(4.0),
        "friday" => Value::Num(5.0),
        "saturday" => Value::Num(6.0),
        "sunday" => Value::Num(7.0),
        _ => {
            if let Some(number) = error_number(name) {
                return Some(Value::Num(number));
            }
            if let Some((_, zone)) = ZONES.iter().find(|(n, _)| *n == name) {
                return Some(fill(&types.zonedata, zone));
            }
            let v: u32 = name.strip_prefix('v')?.parse().ok()?;
            if !SPEEDS.contains(&v) {
                return None;
            }
            fill(&types.speeddata, &[v as f32, 500.0, 5000.0, 1e3])
        }
    })
}

/// The value of a name that every controller knows: `pi`, `tool0`, `v100` ...
pub(super) fn known(types: &Types, name: &str) -> Value {
    constant(types, name).unwrap_or(Value::Num(0.0))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn built_in_records_have_their_components() {
        let types = Types::new();
        let robtarget = types.robtarget.initial();
        assert_eq!(robtarget.numbers().len(), 3 + 4 + 4 + 6);
        assert_eq!(constant(&types, "tool0").unwrap().numbers().len(), 7 + 1 + 3 + 4 + 3);
        assert_eq!(constant(&types, "v83"), None);
        assert_eq!(constant(&types, "v100").unwrap().numbers(), [100.0, 500.0, 5000.0, 1e3]);
    }
}
