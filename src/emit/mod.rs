//! A plan in, edits over the source and bytes out.
