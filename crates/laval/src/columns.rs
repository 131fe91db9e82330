//! Columns as a Parquet file and back: one row group, compressed with zstd. The same columns give the same bytes.
//!
//! Bytes of numbers of equal rank stand together (`BYTE_STREAM_SPLIT`): signs and exponents of neighbours are alike, and only they compress. A column that repeats few numbers has a
//! dictionary. Columns are encoded beside each other, a few at a time.
//!
//! Parquet has no place for the unit of a column. Units and meanings stand in the key-value metadata of the file under `columns`, as JSON:
//! `{"speed": {"unit": "rad/s", "doc": "spin speed"}, ..}`.

use bytes::Bytes;
use parquet::basic::{Compression, ConvertedType, Encoding, Repetition, Type as Physical};
use parquet::column::reader::{ColumnReader, ColumnReaderImpl};
use parquet::column::writer::{ColumnCloseResult, ColumnWriter, get_column_writer, get_typed_column_writer_mut};
use parquet::data_type::{BoolType, ByteArray, ByteArrayType, DataType, DoubleType, Int64Type};
use parquet::errors::ParquetError;
use parquet::file::metadata::KeyValue;
use parquet::file::properties::{EnabledStatistics, WriterProperties, WriterPropertiesPtr};
use parquet::file::reader::{FileReader, SerializedFileReader};
use parquet::file::writer::{SerializedFileWriter, SerializedPageWriter, TrackedWrite};
use parquet::schema::types::{ColumnDescPtr, ColumnPath, Type};
use rayon::prelude::*;
use serde_json::{Map, Value, json};
use std::collections::HashSet;
use std::fs::File;
use std::io::Write;
use std::sync::Arc;

/// Values of a column to write.
#[derive(Clone, Copy)]
pub enum Values<'a> {
    /// Real numbers, kept bit for bit.
    Float(&'a [f64]),
    /// Whole numbers.
    Int(&'a [i64]),
    /// Texts.
    Text(&'a [String]),
    /// Flags.
    Flag(&'a [bool]),
    /// Whole numbers that may be missing.
    OptionalInt(&'a [Option<i64>]),
    /// Texts that may be missing.
    OptionalText(&'a [Option<String>]),
}

/// A column to write.
pub struct Column<'a> {
    /// Name.
    pub name: &'a str,
    /// SI unit; empty for a pure number or text.
    pub unit: &'a str,
    /// What it holds.
    pub doc: &'a str,
    /// Values.
    pub values: Values<'a>,
}

fn field(c: &Column) -> Result<Arc<Type>, ParquetError> {
    let (physical, converted, repetition) = match c.values {
        Values::Float(_) => (Physical::DOUBLE, ConvertedType::NONE, Repetition::REQUIRED),
        Values::Int(_) => (Physical::INT64, ConvertedType::NONE, Repetition::REQUIRED),
        Values::Text(_) => (Physical::BYTE_ARRAY, ConvertedType::UTF8, Repetition::REQUIRED),
        Values::Flag(_) => (Physical::BOOLEAN, ConvertedType::NONE, Repetition::REQUIRED),
        Values::OptionalInt(_) => (Physical::INT64, ConvertedType::NONE, Repetition::OPTIONAL),
        Values::OptionalText(_) => (Physical::BYTE_ARRAY, ConvertedType::UTF8, Repetition::OPTIONAL),
    };
    Type::primitive_type_builder(c.name, physical).with_converted_type(converted).with_repetition(repetition).build().map(Arc::new)
}

fn text(s: &str) -> ByteArray {
    ByteArray::from(s.as_bytes().to_vec())
}

fn present<T>(values: &[Option<T>]) -> Vec<i16> {
    values.iter().map(|v| i16::from(v.is_some())).collect()
}

fn write(column: &mut ColumnWriter, values: Values) -> Result<(), ParquetError> {
    match values {
        Values::Float(v) => typed::<DoubleType>(column).write_batch(v, None, None),
        Values::Int(v) => typed::<Int64Type>(column).write_batch(v, None, None),
        Values::Flag(v) => typed::<BoolType>(column).write_batch(v, None, None),
        Values::Text(v) => typed::<ByteArrayType>(column).write_batch(&v.iter().map(|s| text(s)).collect::<Vec<_>>(), None, None),
        Values::OptionalInt(v) => {
            let given: Vec<i64> = v.iter().flatten().copied().collect();
            typed::<Int64Type>(column).write_batch(&given, Some(&present(v)), None)
        }
        Values::OptionalText(v) => {
            let given: Vec<ByteArray> = v.iter().flatten().map(|s| text(s)).collect();
            typed::<ByteArrayType>(column).write_batch(&given, Some(&present(v)), None)
        }
    }
    .map(|_| ())
}

fn typed<'a, 'b: 'a, T: DataType>(column: &'a mut ColumnWriter<'b>) -> &'a mut parquet::column::writer::ColumnWriterImpl<'b, T> {
    get_typed_column_writer_mut::<T>(column)
}

/// Numbers looked at to see whether a column repeats few of them, and their share that may differ then.
const LOOKED_AT: usize = 1024;
const FEW: usize = 8;

/// A column repeats few numbers.
fn repeats(v: &[f64]) -> bool {
    let step = v.len().div_ceil(LOOKED_AT).max(1);
    let looked_at: Vec<u64> = v.iter().step_by(step).map(|x| x.to_bits()).collect();
    looked_at.iter().collect::<HashSet<_>>().len() * FEW <= looked_at.len()
}

/// Columns encoded beside each other: so many stand in memory.
const BESIDE: usize = 4;
/// Values between two looks at the size of a page.
const BATCH: usize = 8192;

/// A column as the bytes of its pages.
fn encoded(c: &Column, descr: ColumnDescPtr, properties: WriterPropertiesPtr) -> Result<(Bytes, ColumnCloseResult), ParquetError> {
    let mut sink = TrackedWrite::new(Vec::new());
    let mut column = get_column_writer(descr, properties, Box::new(SerializedPageWriter::new(&mut sink)));
    write(&mut column, c.values)?;
    let closed = column.close()?;
    Ok((sink.into_inner()?.into(), closed))
}

/// The file in memory; `notes` are further entries of its key-value metadata.
///
/// # Errors
/// When the Parquet writer refuses.
pub fn encode(columns: &[Column], notes: &[(&str, &str)]) -> Result<Vec<u8>, String> {
    let mut out = Vec::new();
    encode_into(columns, notes, &mut out)?;
    Ok(out)
}

/// The same, written while it is made: of a file larger than a page only pages are in memory.
///
/// # Errors
/// When the Parquet writer refuses or `out` cannot be written.
pub fn encode_into(columns: &[Column], notes: &[(&str, &str)], out: &mut (dyn Write + Send)) -> Result<(), String> {
    encode_columns(columns, notes, out).map_err(|e| e.to_string())
}

fn encode_columns(columns: &[Column], notes: &[(&str, &str)], out: &mut (dyn Write + Send)) -> Result<(), ParquetError> {
    let fields = columns.iter().map(field).collect::<Result<Vec<_>, _>>()?;
    let schema = Arc::new(Type::group_type_builder("schema").with_fields(fields).build()?);
    let about: Map<String, Value> = columns.iter().map(|c| (c.name.to_string(), json!({ "unit": c.unit, "doc": c.doc }))).collect();
    let mut entries: Vec<KeyValue> = notes.iter().map(|(k, v)| KeyValue::new(k.to_string(), v.to_string())).collect();
    entries.push(KeyValue::new("columns".to_string(), Value::Object(about).to_string()));
    // one set of statistics for a column: its pages are read in order
    let mut properties = WriterProperties::builder()
        .set_compression(Compression::ZSTD(Default::default()))
        .set_statistics_enabled(EnabledStatistics::Chunk)
        .set_write_batch_size(BATCH)
        .set_key_value_metadata(Some(entries));
    for c in columns {
        if let Values::Float(v) = c.values {
            let path = ColumnPath::new(vec![c.name.to_string()]);
            properties =
                properties.set_column_dictionary_enabled(path.clone(), repeats(v)).set_column_encoding(path, Encoding::BYTE_STREAM_SPLIT);
        }
    }
    let properties = Arc::new(properties.build());
    let mut writer = SerializedFileWriter::new(out, schema, properties.clone())?;
    let places: Vec<(&Column, ColumnDescPtr)> = columns.iter().zip(writer.schema_descr().columns().iter().cloned()).collect();
    if !columns.is_empty() {
        let mut group = writer.next_row_group()?;
        for some in places.chunks(BESIDE) {
            let made: Vec<_> = some.par_iter().map(|(c, descr)| encoded(c, descr.clone(), properties.clone())).collect();
            for column in made {
                let (bytes, closed) = column?;
                group.append_column(&bytes, closed)?;
            }
        }
        group.close()?;
    }
    writer.close()?;
    Ok(())
}

/// Type of the values of a column.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Kind {
    /// Real numbers.
    Float,
    /// Whole numbers that may be missing.
    Int,
    /// Texts that may be missing.
    Text,
}

/// Values that were read.
#[derive(Debug, PartialEq)]
pub enum Read {
    /// Real numbers.
    Float(Vec<f64>),
    /// Whole numbers or none.
    Int(Vec<Option<i64>>),
    /// Texts or none.
    Text(Vec<Option<String>>),
}

/// Reads the columns of a file, which must have these types, and one entry of its metadata ("" when it has none of that key).
///
/// # Errors
/// A damaged file, or one with other columns.
pub fn decode(file: File, kinds: &[Kind], key: &str) -> Result<(Vec<Read>, String), String> {
    let reader = SerializedFileReader::new(file).map_err(|e| e.to_string())?;
    let about = reader.metadata().file_metadata();
    let entry = about.key_value_metadata().and_then(|list| list.iter().find(|e| e.key == key)).and_then(|e| e.value.clone());
    let found = about.schema_descr().num_columns();
    if found != kinds.len() {
        return Err(format!("{found} columns instead of {}", kinds.len()));
    }
    let mut out: Vec<Read> = kinds
        .iter()
        .map(|k| match k {
            Kind::Float => Read::Float(Vec::new()),
            Kind::Int => Read::Int(Vec::new()),
            Kind::Text => Read::Text(Vec::new()),
        })
        .collect();
    for g in 0..reader.num_row_groups() {
        let group = reader.get_row_group(g).map_err(|e| e.to_string())?;
        let rows = usize::try_from(group.metadata().num_rows()).map_err(|e| e.to_string())?;
        for (k, into) in out.iter_mut().enumerate() {
            let column = group.get_column_reader(k).map_err(|e| e.to_string())?;
            match (column, into) {
                (ColumnReader::DoubleColumnReader(c), Read::Float(v)) => {
                    v.extend(values(c, rows)?.into_iter().map(|x| x.unwrap_or(f64::NAN)))
                }
                (ColumnReader::Int64ColumnReader(c), Read::Int(v)) => v.extend(values(c, rows)?),
                (ColumnReader::ByteArrayColumnReader(c), Read::Text(v)) => {
                    for x in values(c, rows)? {
                        v.push(x.map(|b| b.as_utf8().map(str::to_string)).transpose().map_err(|e| e.to_string())?);
                    }
                }
                _ => return Err("a column has another type".into()),
            }
        }
    }
    Ok((out, entry.unwrap_or_default()))
}

/// All values of a column in one row group, in order.
fn values<T: DataType>(mut column: ColumnReaderImpl<T>, rows: usize) -> Result<Vec<Option<T::T>>, String> {
    let (mut levels, mut given, mut read) = (Vec::new(), Vec::new(), 0);
    while read < rows {
        let (records, _, _) = column.read_records(rows - read, Some(&mut levels), None, &mut given).map_err(|e| e.to_string())?;
        if records == 0 {
            return Err(format!("{read} rows instead of {rows}"));
        }
        read += records;
    }
    let mut given = given.into_iter();
    // a column whose values are all required has no levels
    let out: Vec<_> = if levels.is_empty() {
        given.map(Some).collect()
    } else {
        levels.iter().map(|&l| if l > 0 { given.next() } else { None }).collect()
    };
    if out.len() == rows { Ok(out) } else { Err(format!("{} values instead of {rows}", out.len())) }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn file(bytes: &[u8]) -> File {
        let path = std::env::temp_dir().join(format!("laval-columns-{}-{:?}", std::process::id(), std::thread::current().id()));
        std::fs::write(&path, bytes).unwrap();
        let file = File::open(&path).unwrap();
        std::fs::remove_file(&path).unwrap();
        file
    }

    #[test]
    fn values_come_back_bit_for_bit_and_give_the_same_bytes() {
        let x = [0.1, f64::NAN, f64::from_bits(0x7ff8_0000_0000_1234), -0.0, f64::NEG_INFINITY];
        let n = [Some(1), None, Some(i64::MIN), None, Some(0)];
        let s = [Some("ü\"".to_string()), None, Some(String::new()), None, Some("a".into())];
        let columns = [
            Column { name: "x.y", unit: "m/s", doc: "speed", values: Values::Float(&x) },
            Column { name: "n", unit: "", doc: "number", values: Values::OptionalInt(&n) },
            Column { name: "s", unit: "", doc: "word", values: Values::OptionalText(&s) },
        ];
        let bytes = encode(&columns, &[("laval", "here")]).unwrap();
        for _ in 0..8 {
            assert!(bytes == encode(&columns, &[("laval", "here")]).unwrap());
        }
        let kinds = [Kind::Float, Kind::Int, Kind::Text];
        let (back, mark) = decode(file(&bytes), &kinds, "laval").unwrap();
        assert_eq!(mark, "here");
        let Read::Float(y) = &back[0] else { panic!() };
        assert_eq!(y.iter().map(|v| v.to_bits()).collect::<Vec<_>>(), x.iter().map(|v| v.to_bits()).collect::<Vec<_>>());
        assert_eq!(back[1..], [Read::Int(n.to_vec()), Read::Text(s.to_vec())]);
        let (_, about) = decode(file(&bytes), &kinds, "columns").unwrap();
        assert_eq!(serde_json::from_str::<Value>(&about).unwrap()["x.y"], json!({ "unit": "m/s", "doc": "speed" }));
        assert!(decode(file(&bytes), &kinds[..2], "laval").unwrap_err().contains("3 columns instead of 2"));
        assert!(decode(file(&bytes), &[Kind::Int, Kind::Int, Kind::Text], "laval").is_err());
    }

    #[test]
    fn required_values_flags_and_empty_tables() {
        let (n, s, f) = ([1, -2, i64::MAX], ["a".to_string(), String::new(), "ü\"".into()], [true, false, true]);
        let columns = [
            Column { name: "n", unit: "", doc: "", values: Values::Int(&n) },
            Column { name: "s", unit: "", doc: "", values: Values::Text(&s) },
        ];
        let (back, _) = decode(file(&encode(&columns, &[]).unwrap()), &[Kind::Int, Kind::Text], "").unwrap();
        assert_eq!(back[0], Read::Int(n.iter().map(|&x| Some(x)).collect()));
        assert_eq!(back[1], Read::Text(s.iter().map(|x| Some(x.clone())).collect()));
        let flags = encode(&[Column { name: "f", unit: "", doc: "", values: Values::Flag(&f) }], &[]).unwrap();
        let reader = SerializedFileReader::new(file(&flags)).unwrap();
        let read: Vec<String> = reader.get_row_iter(None).unwrap().map(|r| r.unwrap().to_string()).collect();
        assert_eq!(read, ["{f: true}", "{f: false}", "{f: true}"]);
        assert!(encode(&[], &[]).is_ok());
        let none = encode(&[Column { name: "x", unit: "", doc: "", values: Values::Float(&[]) }], &[]).unwrap();
        assert_eq!(decode(file(&none), &[Kind::Float], "").unwrap().0, [Read::Float(vec![])]);
    }
}
