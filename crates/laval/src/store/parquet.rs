//! One chunk as a Parquet file: the same cells give the same bytes.

use super::cells::{Cells, Column, Kind};
use arrow_array::{Array, ArrayRef, Float64Array, Int64Array, RecordBatch, StringArray};
use arrow_schema::{DataType, Field, Schema};
use parquet::arrow::ArrowWriter;
use parquet::arrow::arrow_reader::ParquetRecordBatchReaderBuilder;
use parquet::basic::Compression;
use parquet::file::properties::WriterProperties;
use std::collections::HashMap;
use std::fs::File;
use std::path::Path;
use std::sync::Arc;

/// Encodes a chunk; `mark` says which study and chunk it belongs to.
pub fn encode(columns: &[Column], cells: &[Cells], mark: &str) -> Result<Vec<u8>, String> {
    let mut fields = Vec::new();
    let mut arrays: Vec<ArrayRef> = Vec::new();
    for (c, x) in columns.iter().zip(cells) {
        let (kind, array): (DataType, ArrayRef) = match x {
            Cells::Float(v) => (DataType::Float64, Arc::new(Float64Array::from(v.clone()))),
            Cells::Int(v) => (DataType::Int64, Arc::new(Int64Array::from(v.clone()))),
            Cells::Text(v) => (DataType::Utf8, Arc::new(StringArray::from_iter(v.iter().map(Option::as_deref)))),
        };
        let notes = HashMap::from([("unit".to_string(), c.unit.clone()), ("doc".to_string(), c.doc.clone())]);
        fields.push(Field::new(&c.name, kind, c.kind != Kind::Float).with_metadata(notes));
        arrays.push(array);
    }
    let schema = Arc::new(Schema::new(fields).with_metadata(HashMap::from([("laval".to_string(), mark.to_string())])));
    let batch = RecordBatch::try_new(schema.clone(), arrays).map_err(|e| e.to_string())?;
    let properties = WriterProperties::builder().set_compression(Compression::ZSTD(Default::default())).build();
    let mut out = Vec::new();
    let mut writer = ArrowWriter::try_new(&mut out, schema, Some(properties)).map_err(|e| e.to_string())?;
    writer.write(&batch).map_err(|e| e.to_string())?;
    writer.close().map_err(|e| e.to_string())?;
    Ok(out)
}

/// Reads a chunk back, with its mark.
pub fn decode(path: &Path, columns: &[Column]) -> Result<(Vec<Cells>, String), String> {
    let file = File::open(path).map_err(|e| e.to_string())?;
    let builder = ParquetRecordBatchReaderBuilder::try_new(file).map_err(|e| e.to_string())?;
    let mark = builder.schema().metadata().get("laval").cloned().unwrap_or_default();
    let mut out: Vec<Cells> = columns
        .iter()
        .map(|c| match c.kind {
            Kind::Float => Cells::Float(Vec::new()),
            Kind::Int => Cells::Int(Vec::new()),
            Kind::Text => Cells::Text(Vec::new()),
        })
        .collect();
    for batch in builder.build().map_err(|e| e.to_string())? {
        let batch = batch.map_err(|e| e.to_string())?;
        if batch.num_columns() != columns.len() {
            return Err(format!("{} columns instead of {}", batch.num_columns(), columns.len()));
        }
        for (array, cells) in batch.columns().iter().zip(&mut out) {
            append(array, cells).ok_or("a column has another type")?;
        }
    }
    Ok((out, mark))
}

fn append(array: &ArrayRef, cells: &mut Cells) -> Option<()> {
    match cells {
        Cells::Float(v) => v.extend_from_slice(array.as_any().downcast_ref::<Float64Array>()?.values()),
        Cells::Int(v) => v.extend(array.as_any().downcast_ref::<Int64Array>()?.iter()),
        Cells::Text(v) => v.extend(array.as_any().downcast_ref::<StringArray>()?.iter().map(|t| t.map(str::to_string))),
    }
    Some(())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn cells_come_back_bit_for_bit_and_give_the_same_bytes() {
        let columns = [Column::float("x", "m", "place"), Column::int("n", "", "number"), Column::text("s", "word")];
        let odd = f64::from_bits(0x7ff8_0000_0000_1234);
        let x = vec![0.1, f64::NAN, odd, -0.0, f64::NEG_INFINITY];
        let n = vec![Some(1), None, Some(i64::MIN), None, Some(0)];
        let s = vec![Some("ü\"".to_string()), None, Some(String::new()), None, Some("a".into())];
        let cells = [Cells::Float(x.clone()), Cells::Int(n.clone()), Cells::Text(s.clone())];
        let bytes = encode(&columns, &cells, "here").unwrap();
        for _ in 0..8 {
            assert!(bytes == encode(&columns, &cells, "here").unwrap());
        }
        let path = std::env::temp_dir().join(format!("laval-chunk-{}", std::process::id()));
        std::fs::write(&path, &bytes).unwrap();
        let (back, mark) = decode(&path, &columns).unwrap();
        std::fs::remove_file(&path).unwrap();
        assert_eq!(mark, "here");
        let Cells::Float(y) = &back[0] else { panic!() };
        assert_eq!(y.iter().map(|v| v.to_bits()).collect::<Vec<_>>(), x.iter().map(|v| v.to_bits()).collect::<Vec<_>>());
        assert_eq!(back[1..], [Cells::Int(n), Cells::Text(s)]);
    }
}
