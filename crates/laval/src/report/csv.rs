//! Tables as CSV.

use crate::outcome::{Data, Table};
use crate::plain;
use std::io::{self, Write};

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

/// The same, row by row: a table of many rows needs no text of its own.
pub(super) fn write_csv(table: &Table, out: &mut dyn Write) -> io::Result<()> {
    let mut comment = |name: &str, doc: &str| match doc {
        "" => Ok(()),
        _ => writeln!(out, "{}", plain::line(&format!("# {name}: {doc}"))),
    };
    comment(table.name(), &table.doc().to_string())?;
    table.columns().iter().try_for_each(|c| comment(&c.heading(), &c.doc.to_string()))?;
    let header: Vec<String> = table.columns().iter().map(|c| quoted(&c.heading())).collect();
    writeln!(out, "{}", header.join(","))?;
    for i in 0..table.rows() {
        for (k, c) in table.columns().iter().enumerate() {
            if k > 0 {
                out.write_all(b",")?;
            }
            match &c.data {
                Data::Float(v) => write!(out, "{:?}", v[i])?,
                Data::Int(v) => write!(out, "{}", v[i])?,
                Data::Text(v) => out.write_all(quoted(&v[i]).as_bytes())?,
                Data::Flag(v) => out.write_all(if v[i] { b"true" } else { b"false" })?,
            }
        }
        out.write_all(b"\n")?;
    }
    Ok(())
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
    fn words_that_need_quotes() {
        let t = Table::new("t", "two\nlines")
            .text("a,b", "", vec!["x\"y".into(), "#1".into(), "".into(), "plain".into(), "\u{1b}[2J".into()])
            .build()
            .unwrap();
        assert_eq!(csv(&t), "# t: two\\u000alines\n\"a,b\"\n\"x\"\"y\"\n\"#1\"\n\"\"\nplain\n\\u001b[2J\n");
    }
}
