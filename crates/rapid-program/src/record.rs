//! The components of RAPID's own records, by type name in lower case.

/// The types that have components, and those of the components.
pub(super) const TYPES: &[&str] = &[
    "num",
    "bool",
    "string",
    "pos",
    "orient",
    "pose",
    "confdata",
    "extjoint",
    "robjoint",
    "robtarget",
    "jointtarget",
    "loaddata",
    "tooldata",
    "wobjdata",
    "speeddata",
    "zonedata",
];

/// Component names and types of a predefined record.
pub(super) fn components(type_name: &str) -> Option<&'static [(&'static str, &'static str)]> {
    Some(match type_name {
        "pos" => &[("x", "num"), ("y", "num"), ("z", "num")],
        "orient" => &[("q1", "num"), ("q2", "num"), ("q3", "num"), ("q4", "num")],
        "pose" => &[("trans", "pos"), ("rot", "orient")],
        "confdata" => &[("cf1", "num"), ("cf4", "num"), ("cf6", "num"), ("cfx", "num")],
        "extjoint" => &[
            ("eax_a", "num"),
            ("eax_b", "num"),
            ("eax_c", "num"),
            ("eax_d", "num"),
            ("eax_e", "num"),
            ("eax_f", "num"),
        ],
        "robjoint" => &[
            ("rax_1", "num"),
            ("rax_2", "num"),
            ("rax_3", "num"),
            ("rax_4", "num"),
            ("rax_5", "num"),
            ("rax_6", "num"),
        ],
        "robtarget" => &[("trans", "pos"), ("rot", "orient"), ("robconf", "confdata"), ("extax", "extjoint")],
        "jointtarget" => &[("robax", "robjoint"), ("extax", "extjoint")],
        "loaddata" => {
            &[("mass", "num"), ("cog", "pos"), ("aom", "orient"), ("ix", "num"), ("iy", "num"), ("iz", "num")]
        }
        "tooldata" => &[("robhold", "bool"), ("tframe", "pose"), ("tload", "loaddata")],
        "wobjdata" => &[
            ("robhold", "bool"),
            ("ufprog", "bool"),
            ("ufmec", "string"),
            ("uframe", "pose"),
            ("oframe", "pose"),
        ],
        "speeddata" => &[("v_tcp", "num"), ("v_ori", "num"), ("v_leax", "num"), ("v_reax", "num")],
        "zonedata" => &[
            ("finep", "bool"),
            ("pzone_tcp", "num"),
            ("pzone_ori", "num"),
            ("pzone_eax", "num"),
            ("zone_ori", "num"),
            ("zone_leax", "num"),
            ("zone_reax", "num"),
        ],
        _ => return None,
    })
}
