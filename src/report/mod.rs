//! Diffs, tables, JSON: what people and scripts read. Computes nothing.
