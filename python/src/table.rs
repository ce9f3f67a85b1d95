//! Tables in and out through the Arrow PyCapsule interface.

use crate::errors::one;
use arrow_array::{ArrayRef, BooleanArray, Float64Array, Int64Array, RecordBatch, StringArray};
use arrow_cast::display::{ArrayFormatter, FormatOptions};
use arrow_schema::{ArrowError, DataType, Field, Schema};
use driftpost::Diagnostic;
use pyo3::exceptions::PyValueError;
use pyo3::prelude::*;
use pyo3::types::{PyCapsule, PyDict};
use pyo3_arrow::PyTable;
use serde_json::Value;
use std::sync::Arc;

/// Rows and named columns, for whatever reads Arrow.
#[pyclass(frozen, module = "driftpost._driftpost")]
pub struct Table {
    batch: RecordBatch,
    /// What it was made of, a list of JSON objects.
    json: String,
}

#[pymethods]
impl Table {
    /// From a list of JSON objects: a column for each name, numbers and truth values as such, all else as text.
    #[staticmethod]
    fn from_json(text: &str) -> PyResult<Self> {
        let rows: Vec<serde_json::Map<String, Value>> =
            serde_json::from_str(text).map_err(|error| PyValueError::new_err(error.to_string()))?;
        let mut names: Vec<&String> = Vec::new();
        for name in rows.iter().flat_map(serde_json::Map::keys) {
            if !names.contains(&name) {
                names.push(name);
            }
        }
        let columns: Vec<(&String, ArrayRef)> = names
            .into_iter()
            .map(|name| (name, column(&rows.iter().map(|row| row.get(name)).collect::<Vec<_>>())))
            .collect();
        let fields = columns.iter().map(|(name, array)| Field::new(*name, array.data_type().clone(), true));
        let schema = Arc::new(Schema::new(fields.collect::<Vec<_>>()));
        let arrays = columns.iter().map(|(_, array)| Arc::clone(array)).collect();
        let options = arrow_array::RecordBatchOptions::new().with_row_count(Some(rows.len()));
        let batch = RecordBatch::try_new_with_options(schema, arrays, &options).map_err(python_error)?;
        Ok(Self { batch, json: text.to_owned() })
    }

    #[getter]
    fn column_names(&self) -> Vec<String> {
        self.batch.schema().fields().iter().map(|field| field.name().clone()).collect()
    }

    fn __len__(&self) -> usize {
        self.batch.num_rows()
    }

    /// A dict for each row, None where a cell is missing.
    fn rows<'py>(&self, py: Python<'py>) -> PyResult<Vec<Bound<'py, PyDict>>> {
        let names = self.column_names();
        let rows: Vec<Bound<'py, PyDict>> =
            py.import("json")?.call_method1("loads", (&self.json,))?.extract()?;
        let whole = |row: Bound<'py, PyDict>| {
            let all = PyDict::new(py);
            for name in &names {
                all.set_item(name, row.get_item(name)?)?;
            }
            Ok(all)
        };
        rows.into_iter().map(whole).collect()
    }

    fn __repr__(&self) -> String {
        let rows = match self.batch.num_rows() {
            1 => "1 row".to_owned(),
            rows => format!("{rows} rows"),
        };
        format!("<driftpost.Table, {rows}: {}>", self.column_names().join(", "))
    }

    fn __reduce__<'py>(&self, py: Python<'py>) -> PyResult<(Bound<'py, PyAny>, (&str,))> {
        Ok((py.get_type::<Self>().getattr("from_json")?, (&self.json,)))
    }

    #[pyo3(signature = (requested_schema=None))]
    fn __arrow_c_stream__<'py>(
        &self,
        py: Python<'py>,
        requested_schema: Option<Bound<'py, PyCapsule>>,
    ) -> PyResult<Bound<'py, PyAny>> {
        let table = PyTable::try_new(vec![self.batch.clone()], self.batch.schema())?;
        let table = table.into_pyobject(py)?;
        table.call_method1("__arrow_c_stream__", (requested_schema,))
    }
}

fn python_error(error: ArrowError) -> PyErr {
    PyValueError::new_err(error.to_string())
}

/// The narrowest type that all cells of a column fit.
fn column(cells: &[Option<&Value>]) -> ArrayRef {
    let cells: Vec<Option<&Value>> = cells.iter().map(|cell| cell.filter(|value| !value.is_null())).collect();
    let are = |is: fn(&Value) -> bool| cells.iter().flatten().all(|value| is(value));
    if are(Value::is_i64) {
        Arc::new(Int64Array::from_iter(cells.iter().map(|cell| cell.and_then(Value::as_i64))))
    } else if are(Value::is_number) {
        Arc::new(Float64Array::from_iter(cells.iter().map(|cell| cell.and_then(Value::as_f64))))
    } else if are(Value::is_boolean) {
        Arc::new(BooleanArray::from_iter(cells.iter().map(|cell| cell.and_then(Value::as_bool))))
    } else {
        let text = |value: &Value| value.as_str().map_or_else(|| value.to_string(), str::to_owned);
        Arc::new(StringArray::from_iter(cells.iter().map(|cell| cell.map(text))))
    }
}

/// A table of numbers, text and truth values as CSV, numbers with all their digits; missing cells are empty.
#[pyfunction]
pub(crate) fn csv_of(py: Python<'_>, table: PyTable) -> PyResult<String> {
    let (batches, schema) = table.into_inner();
    let mut text = schema.fields().iter().map(|field| quoted(field.name())).collect::<Vec<_>>().join(",");
    text.push('\n');
    for field in schema.fields() {
        let is_plain = matches!(field.data_type(), DataType::Utf8 | DataType::LargeUtf8 | DataType::Utf8View);
        let is_cell = is_plain
            || field.data_type().is_numeric()
            || field.data_type().is_temporal()
            || matches!(field.data_type(), DataType::Boolean | DataType::Null | DataType::Dictionary(..));
        if !is_cell {
            let text =
                format!("column {} holds {}, which is no cell of a table", field.name(), field.data_type());
            return Err(one(py, Diagnostic::error("table::type", text)));
        }
    }
    let options = FormatOptions::default();
    for batch in &batches {
        let columns: Vec<ArrayFormatter<'_>> = batch
            .columns()
            .iter()
            .map(|column| ArrayFormatter::try_new(column.as_ref(), &options))
            .collect::<Result<_, _>>()
            .map_err(python_error)?;
        for row in 0..batch.num_rows() {
            let cell =
                |column: &ArrayFormatter<'_>| column.value(row).try_to_string().map(|cell| quoted(&cell));
            let cells: Vec<String> =
                columns.iter().map(cell).collect::<Result<_, _>>().map_err(python_error)?;
            text.push_str(&cells.join(","));
            text.push('\n');
        }
    }
    Ok(text)
}

fn quoted(cell: &str) -> String {
    if cell.contains([',', '"', '\n', '\r', '#']) {
        format!("\"{}\"", cell.replace('"', "\"\""))
    } else {
        cell.to_owned()
    }
}
