//! Warm-up time buckets from a tolerance.
