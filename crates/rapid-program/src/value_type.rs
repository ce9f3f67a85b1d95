//! The type of what `SetDataVal` sets data to: it writes only data of that type.

use super::expressions::root_of;
use super::ids::DatumId;
use super::index::{Ctx, DatumKind, Index, Resolved};
use rapid_syntax::tree::{DataKind, Expr, ExprKind};

/// The type of a value where its text tells it: of a datum, an element of an array, a text or a truth value.
pub(super) fn type_of_value<'i>(index: &'i Index<'_>, ctx: Ctx, value: &Expr) -> Option<&'i str> {
    match &value.kind {
        ExprKind::Paren(inner) => type_of_value(index, ctx, inner),
        ExprKind::String => Some("string"),
        ExprKind::Bool(_) => Some("bool"),
        ExprKind::Name => {
            let (root, _) = root_of(value)?;
            match index.datum(root, ctx) {
                Resolved::Here(datum) | Resolved::Elsewhere(datum) => {
                    Some(index.type_text(index.data[datum].type_name))
                }
                Resolved::Twice(..) | Resolved::Nowhere => None,
            }
        }
        ExprKind::Index(element_of) => type_of_value(index, ctx, &element_of.base),
        _ => None,
    }
}

/// Whether a datum can be set to a value of this type by its name; a type that is not known may be any. Nothing sets a constant.
pub(super) fn can_be_set_to(index: &Index<'_>, datum: DatumId, type_text: Option<&str>) -> bool {
    let entry = &index.data[datum];
    entry.kind != DatumKind::Declared(DataKind::Const)
        && type_text.is_none_or(|set| index.type_text(entry.type_name) == set)
}
