//! Tables as Parquet.

use crate::columns::{Column, Values, encode};
use crate::outcome::{Data, Table};

/// A table as a Parquet file in memory. Its metadata carries `name` and `doc` of the table, and `columns`: unit and meaning of each.
///
/// # Errors
/// When the Parquet writer refuses.
pub fn parquet(table: &Table) -> Result<Vec<u8>, String> {
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
    encode(&columns, &[("name", table.name()), ("doc", table.doc().to_string().as_str())])
}
