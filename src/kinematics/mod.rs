//! Forward and inverse kinematics of a six-axis arm, its Jacobian, configuration and singularities.
//!
//! Pure functions over constant models; knows nothing of RAPID or of files.
