//! Tables as CSV.

use crate::outcome::{Data, Table};
use crate::plain;
use rayon::prelude::*;
use std::io::{self, Write};

/// Rows that are written as text together, and such blocks made beside each other.
const ROWS: usize = 2048;
const BLOCKS: usize = 16;

/// A table as CSV (RFC 4180, UTF-8): comment lines with what the table and its columns hold, a header with units
/// (`speed [rad/s]`), then the rows. Floats are written so that reading gives the same bits; missing ones as `NaN`.
///
/// `pandas.read_csv(file, comment="#")` reads it. Every word that could be taken for something else (comma, quote, line end,
/// `#`) is quoted; control characters other than line ends and tabs are written as in a machine file, `\\u001b`.
///
/// ```
/// use laval::outcome::Table;
/// let t = Table::new("t", "A rise").float("x", "s", "time", vec![0.1, f64::NAN]).flag("ok", "", vec![true, false]).build().unwrap();
/// assert_eq!(laval::report::csv(&t), "# t: A rise\n# x [s]: time\nx [s],ok\n0.1,true\nNaN,false\n");
/// ```
pub fn csv(table: &Table) -> String {
    let mut out = Vec::new();
    // nothing fails in memory
    let _ = write_csv(table, &mut out);
    String::from_utf8(out).unwrap_or_default()
}

/// The same, block of rows by block of rows: a table of many rows needs no text of its own.
pub(super) fn write_csv(table: &Table, out: &mut dyn Write) -> io::Result<()> {
    let mut comment = |name: &str, doc: &str| match doc {
        "" => Ok(()),
        _ => writeln!(out, "{}", plain::line(&format!("# {name}: {doc}"))),
    };
    comment(table.name(), &table.doc().to_string())?;
    table.columns().iter().try_for_each(|c| comment(&c.heading(), &c.doc.to_string()))?;
    let header: Vec<String> = table.columns().iter().map(|c| quoted(&c.heading())).collect();
    writeln!(out, "{}", header.join(","))?;
    let starts: Vec<usize> = (0..table.rows()).step_by(ROWS).collect();
    for some in starts.chunks(BLOCKS) {
        let blocks: Vec<Vec<u8>> = some.par_iter().map(|&i| rows(table, i..(i + ROWS).min(table.rows()))).collect();
        blocks.iter().try_for_each(|text| out.write_all(text))?;
    }
    Ok(())
}

/// Rows as text.
fn rows(table: &Table, range: std::ops::Range<usize>) -> Vec<u8> {
    let mut out = Vec::with_capacity(range.len() * table.columns().len() * 20);
    let mut digits = zmij::Buffer::new();
    for i in range {
        for (k, c) in table.columns().iter().enumerate() {
            if k > 0 {
                out.push(b',');
            }
            match &c.data {
                Data::Float(v) => float(v[i], &mut digits, &mut out),
                Data::Int(v) => out.extend_from_slice(v[i].to_string().as_bytes()),
                Data::Text(v) => out.extend_from_slice(quoted(&v[i]).as_bytes()),
                Data::Flag(v) => out.extend_from_slice(if v[i] { b"true" } else { b"false" }),
            }
        }
        out.push(b'\n');
    }
    out
}

/// The shortest digits that give the same bits, in the form of `{:?}`.
fn float(x: f64, digits: &mut zmij::Buffer, out: &mut Vec<u8>) {
    let size = x.abs();
    // large numbers have a sign of the power of ten here and none there
    if !(x.is_finite() && size < 1e16) {
        return out.extend_from_slice(format!("{x:?}").as_bytes());
    }
    let text = digits.format_finite(x);
    let (sign, plain) = text.strip_prefix('-').map_or(("", text), |plain| ("-", plain));
    // numbers from 1e-5 to 1e-4, tens of micrometres, have a power of ten there and none here
    let after_zeros = if (1e-5..1e-4).contains(&size) { plain.strip_prefix("0.0000") } else { None };
    match after_zeros.and_then(|digits| digits.split_at_checked(1)) {
        None => out.extend_from_slice(text.as_bytes()),
        Some((first, others)) => {
            let point = if others.is_empty() { "" } else { "." };
            [sign, first, point, others, "e-5"].iter().for_each(|s| out.extend_from_slice(s.as_bytes()));
        }
    }
}

fn quoted(text: &str) -> String {
    let text = plain::lines(text);
    let bare = !text.is_empty() && !text.contains([',', '"', '\n', '\r', '#']) && text.trim() == text;
    if bare { text.into() } else { format!("\"{}\"", text.replace('"', "\"\"")) }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn floats_come_back_bit_by_bit() {
        let values = vec![0.1 + 0.2, 1e-300, -1.0 / 3.0, f64::MAX, 5e-324, 1e16, -0.0, f64::INFINITY];
        let t = Table::new("t", "").float("v", "", "", values.clone()).build().unwrap();
        let back: Vec<f64> = csv(&t).lines().skip(1).map(|l| l.parse().unwrap()).collect();
        assert_eq!(back.iter().map(|v| v.to_bits()).collect::<Vec<_>>(), values.iter().map(|v| v.to_bits()).collect::<Vec<_>>());
    }

    #[test]
    fn digits_are_as_few_as_those_of_the_standard_library() {
        let mut digits = zmij::Buffer::new();
        let mut bits = 0x9e37_79b9_7f4a_7c15u64;
        let mut same = |x: f64| {
            let mut out = Vec::new();
            float(x, &mut digits, &mut out);
            let (text, known) = (String::from_utf8(out).unwrap(), format!("{x:?}"));
            // of two equally near numbers of as many digits either is right
            let back: f64 = text.parse().unwrap();
            assert!(text == known || text.len() == known.len() && back.to_bits() == x.to_bits(), "{text} {known}");
        };
        for k in 0..200_000 {
            bits = bits.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
            same(f64::from_bits(bits));
            // of usual size, with few digits and with many
            let x = (bits >> 40) as f64 * 10f64.powi(k % 40 - 20);
            same(x);
            same(-x / 3.0);
        }
        for x in [
            0.0,
            -0.0,
            1.0,
            1e15,
            1e16,
            1e17,
            123_456_789.0,
            9.999e-5,
            -2.5e-5,
            1e-4,
            1e-5,
            9.9e-6,
            5e-324,
            f64::MAX,
            f64::NAN,
            f64::INFINITY,
        ] {
            same(x);
        }
    }

    #[test]
    fn blocks_of_rows_follow_each_other() {
        let n = 3 * ROWS + 5;
        let t = Table::new("t", "").float("x", "", "", (0..n).map(|i| i as f64 + 0.5).collect()).build().unwrap();
        let back: Vec<f64> = csv(&t).lines().skip(1).map(|l| l.parse().unwrap()).collect();
        assert!(back.iter().enumerate().all(|(i, x)| *x == i as f64 + 0.5) && back.len() == n);
    }

    #[test]
    fn words_that_need_quotes() {
        let t = Table::new("t", "two\nlines")
            .text("a,b", "", vec!["x\"y".into(), "#1".into(), "".into(), "plain".into(), "\u{1b}[2J".into()])
            .build()
            .unwrap();
        assert_eq!(csv(&t), "# t: two\\u000alines\n\"a,b\"\n\"x\"\"y\"\n\"#1\"\n\"\"\nplain\n\\u001b[2J\n");
    }
}
