//! Tables as Parquet.

use crate::outcome::{Data, Table};
use arrow_array::{ArrayRef, BooleanArray, Float64Array, Int64Array, RecordBatch, StringArray};
use arrow_schema::{DataType, Field, Schema};
use parquet::arrow::ArrowWriter;
use parquet::basic::Compression;
use parquet::file::properties::WriterProperties;
use std::collections::HashMap;
use std::sync::Arc;

/// A table as a Parquet file in memory, compressed with zstd. Each column carries `unit` and `doc` in its field metadata, the schema
/// carries `name` and `doc` of the table.
///
/// # Errors
/// When the Parquet writer refuses.
pub fn parquet(table: &Table) -> Result<Vec<u8>, String> {
    let mut fields = Vec::new();
    let mut arrays: Vec<ArrayRef> = Vec::new();
    for c in table.columns() {
        let (kind, array): (DataType, ArrayRef) = match &c.data {
            Data::Float(v) => (DataType::Float64, Arc::new(Float64Array::from(v.clone()))),
            Data::Int(v) => (DataType::Int64, Arc::new(Int64Array::from(v.clone()))),
            Data::Text(v) => (DataType::Utf8, Arc::new(StringArray::from(v.clone()))),
            Data::Flag(v) => (DataType::Boolean, Arc::new(BooleanArray::from(v.clone()))),
        };
        let notes = HashMap::from([("unit".to_string(), c.unit.clone()), ("doc".to_string(), c.doc.clone())]);
        fields.push(Field::new(&c.name, kind, false).with_metadata(notes));
        arrays.push(array);
    }
    let notes = HashMap::from([("name".to_string(), table.name().to_string()), ("doc".to_string(), table.doc().to_string())]);
    let schema = Arc::new(Schema::new(fields).with_metadata(notes));
    let options = arrow_array::RecordBatchOptions::new().with_row_count(Some(table.rows()));
    let batch = RecordBatch::try_new_with_options(schema.clone(), arrays, &options).map_err(|e| e.to_string())?;
    let properties = WriterProperties::builder().set_compression(Compression::ZSTD(Default::default())).build();
    let mut out = Vec::new();
    let mut writer = ArrowWriter::try_new(&mut out, schema, Some(properties)).map_err(|e| e.to_string())?;
    writer.write(&batch).map_err(|e| e.to_string())?;
    writer.close().map_err(|e| e.to_string())?;
    Ok(out)
}

#[cfg(test)]
mod tests {
    use super::*;
    use parquet::arrow::arrow_reader::ParquetRecordBatchReaderBuilder;

    fn table() -> Table {
        Table::new("t", "Everything")
            .float("x", "m/s", "speed", vec![0.1, f64::NAN, f64::INFINITY])
            .int("n", "", "number", vec![1, -2, i64::MAX])
            .text("s", "word", vec!["a".into(), "".into(), "ü\"".into()])
            .flag("ok", "", vec![true, false, true])
            .build()
            .unwrap()
    }

    #[test]
    fn values_units_and_docs_come_back() {
        let builder = ParquetRecordBatchReaderBuilder::try_new(bytes(parquet(&table()).unwrap())).unwrap();
        // batches leave out the metadata of the schema
        let schema = builder.schema().clone();
        let batch = builder.build().unwrap().next().unwrap().unwrap();
        assert_eq!(schema.field(0).metadata()["unit"], "m/s");
        assert_eq!(schema.field(1).metadata()["doc"], "number");
        assert_eq!(schema.metadata()["doc"], "Everything");
        let x = batch.column(0).as_any().downcast_ref::<Float64Array>().unwrap();
        assert!(x.value(0) == 0.1 && x.value(1).is_nan() && x.value(2) == f64::INFINITY);
        let n = batch.column(1).as_any().downcast_ref::<Int64Array>().unwrap();
        assert_eq!(n.values().to_vec(), [1, -2, i64::MAX]);
        let s = batch.column(2).as_any().downcast_ref::<StringArray>().unwrap();
        assert_eq!(s.iter().flatten().collect::<Vec<_>>(), ["a", "", "ü\""]);
        assert!(!batch.column(3).as_any().downcast_ref::<BooleanArray>().unwrap().value(1));
    }

    fn bytes(v: Vec<u8>) -> std::fs::File {
        use std::io::Write;
        let path = std::env::temp_dir().join(format!("laval-parquet-{}-{:?}", std::process::id(), std::thread::current().id()));
        std::fs::File::create(&path).unwrap().write_all(&v).unwrap();
        let file = std::fs::File::open(&path).unwrap();
        std::fs::remove_file(&path).unwrap();
        file
    }

    #[test]
    fn same_bytes_every_time_and_empty_tables_work() {
        let first = parquet(&table()).unwrap();
        for _ in 0..8 {
            assert!(parquet(&table()).unwrap() == first);
        }
        assert!(parquet(&Table::new("e", "").build().unwrap()).is_ok());
        assert!(parquet(&Table::new("e", "").float("x", "", "", vec![]).build().unwrap()).is_ok());
    }
}
