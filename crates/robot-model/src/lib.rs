//! Six-axis arms: the constructive model, its kinematics, and how it deforms with time, temperature and load.
//!
//! Nothing here knows RAPID. SI inside; mm and deg exist where files are read and written.

pub mod csv_lines;
pub mod deform;
pub mod kinematics;
pub mod robot;
pub mod units;
