//! Tables as CSV.

use crate::outcome::{Data, Table};
use crate::plain;

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
    let mut out = String::new();
    let mut comment = |name: &str, doc: &str| {
        if !doc.is_empty() {
            out.push_str(&plain::line(&format!("# {name}: {doc}")));
            out.push('\n');
        }
    };
    comment(table.name(), &table.doc().to_string());
    table.columns().iter().for_each(|c| comment(&c.heading(), &c.doc.to_string()));
    let header: Vec<String> = table.columns().iter().map(|c| quoted(&c.heading())).collect();
    out.push_str(&header.join(","));
    out.push('\n');
    for i in 0..table.rows() {
        for (k, c) in table.columns().iter().enumerate() {
            if k > 0 {
                out.push(',');
            }
            match &c.data {
                Data::Float(v) => out.push_str(&format!("{:?}", v[i])),
                Data::Int(v) => out.push_str(&v[i].to_string()),
                Data::Text(v) => out.push_str(&quoted(&v[i])),
                Data::Flag(v) => out.push_str(if v[i] { "true" } else { "false" }),
            }
        }
        out.push('\n');
    }
    out
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
