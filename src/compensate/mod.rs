//! Motions, a deformed model and buckets in; a plan out: which target becomes what, when.
