//! Tables as Parquet.

use crate::columns::{Column, Values, encode_into};
use crate::outcome::{Data, Table};
use std::io::Write;

/// A table as a Parquet file in memory. Its metadata carries `name` and `doc` of the table, and `columns`: unit and meaning of each.
///
/// # Errors
/// When the Parquet writer refuses.
pub fn parquet(table: &Table) -> Result<Vec<u8>, String> {
    let mut out = Vec::new();
    write_parquet(table, &mut out)?;
    Ok(out)
}

/// The same, column by column: a table of many rows needs no second copy in memory.
pub(super) fn write_parquet(table: &Table, out: &mut (dyn Write + Send)) -> Result<(), String> {
    let docs: Vec<String> = table.columns().iter().map(|c| c.doc.to_string()).collect();
    let columns: Vec<Column> = table
        .columns()
        .iter()
        .zip(&docs)
        .map(|(c, doc)| {
            let values = match &c.data {
                Data::Float(v) => Values::Float(v),
                Data::Int(v) => Values::Int(v),
                Data::Text(v) => Values::Text(v),
                Data::Flag(v) => Values::Flag(v),
            };
            Column { name: &c.name, unit: &c.unit, doc, values }
        })
        .collect();
    encode_into(&columns, &[("name", table.name()), ("doc", table.doc().to_string().as_str())], out)
}
