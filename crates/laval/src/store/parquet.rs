//! One chunk as a Parquet file: the same cells give the same bytes, which hold their own checksum.

use super::cells::{Cells, Column, Kind};
use crate::columns;
use crate::hash::sha256;
use std::fs::File;
use std::ops::Range;
use std::path::Path;

fn values(cells: &Cells) -> columns::Values<'_> {
    match cells {
        Cells::Float(v) => columns::Values::Float(v),
        Cells::Int(v) => columns::Values::OptionalInt(v),
        Cells::Text(v) => columns::Values::OptionalText(v),
    }
}

/// What stands before the checksum, in the notes at the end of the file.
const SEAL: &[u8] = b"laval-sha256:";
/// Hexadecimal digits of a checksum.
const DIGITS: usize = 64;

/// Where the checksum of a file stands.
fn seal(bytes: &[u8]) -> Option<Range<usize>> {
    let at = bytes.windows(SEAL.len()).rposition(|w| w == SEAL)? + SEAL.len();
    (at + DIGITS <= bytes.len()).then_some(at..at + DIGITS)
}

/// Whether a file holds the checksum of its other bytes. A damaged file must not be decoded: the decoder need not survive it.
pub fn sealed(bytes: &[u8]) -> bool {
    let Some(place) = seal(bytes) else { return false };
    let mut blank = bytes.to_vec();
    blank[place.clone()].fill(b'0');
    bytes[place] == *sha256(&blank).as_bytes()
}

/// Encodes a chunk; `mark` says which study and chunk it belongs to.
pub fn encode(columns: &[Column], cells: &[Cells], mark: &str) -> Result<Vec<u8>, String> {
    let list: Vec<columns::Column> =
        columns.iter().zip(cells).map(|(c, x)| columns::Column { name: &c.name, unit: &c.unit, doc: &c.doc, values: values(x) }).collect();
    let blank = format!("{}{}", String::from_utf8_lossy(SEAL), "0".repeat(DIGITS));
    let mut out = columns::encode(&list, &[("laval", mark), ("checksum", &blank)])?;
    let place = seal(&out).ok_or("no place for the checksum")?;
    let sum = sha256(&out);
    out[place].copy_from_slice(sum.as_bytes());
    Ok(out)
}

/// Reads a chunk back, with its mark.
pub fn decode(path: &Path, columns: &[Column]) -> Result<(Vec<Cells>, String), String> {
    let file = File::open(path).map_err(|e| e.to_string())?;
    let kind = |c: &Column| match c.kind {
        Kind::Float => columns::Kind::Float,
        Kind::Int => columns::Kind::Int,
        Kind::Text => columns::Kind::Text,
    };
    let kinds: Vec<columns::Kind> = columns.iter().map(kind).collect();
    let (read, mark) = columns::decode(file, &kinds, "laval")?;
    let cells = read.into_iter().map(|x| match x {
        columns::Read::Float(v) => Cells::Float(v),
        columns::Read::Int(v) => Cells::Int(v),
        columns::Read::Text(v) => Cells::Text(v),
    });
    Ok((cells.collect(), mark))
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
        assert!(sealed(&bytes) && !sealed(&bytes[..bytes.len() / 2]) && !sealed(&[&bytes[..], b" "].concat()));
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
