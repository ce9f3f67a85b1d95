//! driftpost for Python: arrays, tables, text and exceptions on one side, the library's front door on the other. No decisions.

mod arrays;
mod command;
mod compensation;
mod errors;
mod table;

use pyo3::prelude::*;

#[pymodule]
fn _driftpost(module: &Bound<'_, PyModule>) -> PyResult<()> {
    module.add_class::<arrays::Robot>()?;
    module.add_class::<table::Table>()?;
    module.add_function(wrap_pyfunction!(compensation::compensate, module)?)?;
    module.add_function(wrap_pyfunction!(command::command, module)?)?;
    module.add_function(wrap_pyfunction!(command::main, module)?)?;
    module.add_function(wrap_pyfunction!(table::csv_of, module)?)?;
    module.add("__version__", env!("CARGO_PKG_VERSION"))
}
