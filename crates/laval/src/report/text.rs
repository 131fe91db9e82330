//! Escaping, file names, widths of words and numbers in drawings.

use crate::plain;

/// Letters of a unit that has no slash, with a mark behind it: "mm/s" has one, "kN," has none.
const LONGEST_UNIT: usize = 4;

/// Sentences for XML and HTML content and attributes: [`escape`], and no line ends between a number and its unit, behind the slash of a unit, behind a relation sign
/// or before a dash.
pub(super) fn prose(text: &str) -> String {
    let text = escape(text);
    let mut out = String::with_capacity(text.len());
    let (mut last, mut unit, mut dash) = (' ', false, false);
    for (at, c) in text.char_indices() {
        if c == ' ' {
            let next = text[at + 1..].split([' ', '&', ')']).next().unwrap_or("");
            dash = next == "–";
            unit = last.is_ascii_digit() && (next.chars().count() <= LONGEST_UNIT || next.contains('/'));
        }
        let relation = matches!(last, '≤' | '≥');
        last = c;
        match c {
            ' ' if unit || relation || dash => out.push('\u{a0}'),
            '/' if unit => out.push_str("/\u{2060}"),
            c => out.push(c),
        }
    }
    out
}

/// Text that is copied and found again, such as a machine file or an address, for XML and HTML content and attributes: markup characters as entities, control characters
/// as they are written in a machine file.
pub fn escape(text: &str) -> String {
    let mut out = String::with_capacity(text.len());
    for c in plain::lines(text).chars() {
        match c {
            '&' => out.push_str("&amp;"),
            '<' => out.push_str("&lt;"),
            '>' => out.push_str("&gt;"),
            '"' => out.push_str("&quot;"),
            '\'' => out.push_str("&#39;"),
            // no character of XML, and no mark that could be shown
            '\u{fffe}' | '\u{ffff}' => {}
            c => out.push(c),
        }
    }
    out
}

/// A name that is safe as a file name on every system: letters, digits, `-`, `_`, `.`; never empty, hidden or a device name.
///
/// ```
/// use laval::report::file_name;
/// assert_eq!(file_name("run up / slow"), "run-up-slow");
/// assert_eq!(file_name("../../etc"), "etc");
/// assert_eq!(file_name("?"), "unnamed");
/// ```
pub fn file_name(name: &str) -> String {
    let mut out = String::new();
    for c in name.chars() {
        match c {
            c if c.is_alphanumeric() || c == '_' => out.push(c),
            '.' if !out.is_empty() && !out.ends_with(['-', '.']) => out.push('.'),
            _ if !out.is_empty() && !out.ends_with(['-', '.']) => out.push('-'),
            _ => {}
        }
    }
    // file systems limit names in bytes; leave room for a suffix and an extension
    while out.len() > 80 {
        out.pop();
    }
    let out = out.trim_end_matches(['-', '.']);
    let stem = out.split('.').next().unwrap_or("").to_ascii_lowercase();
    let device = matches!(stem.as_str(), "con" | "prn" | "aux" | "nul")
        || (stem.starts_with("com") || stem.starts_with("lpt"))
            && stem.chars().count() == 4
            && stem.ends_with(|c: char| c.is_ascii_digit() || matches!(c, '¹' | '²' | '³'));
    match out {
        "" => "unnamed".into(),
        _ if device => format!("{out}_"),
        _ => out.into(),
    }
}

/// Width of a text in a sans-serif font of the given size, estimated on the wide side.
pub(super) fn width(text: &str, size: f64) -> f64 {
    let units: f64 = text
        .chars()
        .map(|c| match c {
            'i' | 'j' | 'l' | '.' | ',' | ':' | ';' | '|' | '!' | '\'' | '·' => 0.28,
            ' ' | 'f' | 't' | 'r' | 'I' | '(' | ')' | '[' | ']' | '/' | '-' => 0.36,
            'm' | 'w' | 'M' | 'W' | '@' | '%' => 0.88,
            '⁰' | '¹' | '²' | '³' | '⁴'..='⁹' | '⁻' => 0.38,
            c if c.is_ascii_uppercase() => 0.7,
            // Cyrillic
            'ж' | 'м' | 'ф' | 'ш' | 'щ' | 'ы' | 'ю' | 'Ж' | 'М' | 'Ф' | 'Ш' | 'Щ' | 'Ы' | 'Ю' => 0.86,
            '\u{400}'..='\u{4ff}' => {
                if c.is_uppercase() {
                    0.72
                } else {
                    0.6
                }
            }
            c if (c as u32) > 0x2e80 => 1.05,
            _ => 0.57,
        })
        .sum();
    // fonts differ by some percent; labels must not run out of the drawing in the widest common one
    1.06 * units * size
}

/// The text, cut with an ellipsis when wider than `room`.
pub(super) fn fit(text: &str, size: f64, room: f64) -> String {
    if width(text, size) <= room {
        return text.into();
    }
    let mut out = String::new();
    for c in text.chars() {
        out.push(c);
        if width(&out, size) + size > room {
            out.pop();
            break;
        }
    }
    format!("{}…", out.trim_end())
}

/// The text in lines no wider than `room`, broken between words; a word that is wider is broken itself.
pub(super) fn wrap(text: &str, size: f64, room: f64) -> Vec<String> {
    let mut out = vec![String::new()];
    for word in text.split(' ').filter(|w| !w.is_empty()) {
        let line = out.last_mut().map(std::mem::take).unwrap_or_default();
        let longer = if line.is_empty() { word.to_string() } else { format!("{line} {word}") };
        out.pop();
        if width(&longer, size) <= room {
            out.push(longer);
            continue;
        }
        if !line.is_empty() {
            out.push(line);
        }
        out.push(String::new());
        for c in word.chars() {
            let last = out.len() - 1;
            out[last].push(c);
            if width(&out[last], size) > room && out[last].chars().count() > 1 {
                out[last].pop();
                out.push(c.to_string());
            }
        }
    }
    out
}

/// A coordinate in a drawing: at most one decimal, no negative zero.
pub(super) fn px(x: f64) -> String {
    let r = (x * 10.0).round() / 10.0 + 0.0;
    if r == r.trunc() { format!("{r:.0}") } else { format!("{r:.1}") }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn markup_and_control_characters() {
        assert_eq!(escape("<a b=\"c\">&'\u{0}\u{1b}"), "&lt;a b=&quot;c&quot;&gt;&amp;&#39;\\u0000\\u001b");
    }

    /// A line may end behind the slash of a path, not behind that of a unit.
    #[test]
    fn units_do_not_break_at_their_slash() {
        assert_eq!(prose("out/m: 3 rad/s, 4 mm of a/b"), "out/m: 3\u{a0}rad/\u{2060}s, 4\u{a0}mm of a/b");
        assert_eq!(prose("2 bearings and 5 kN."), "2 bearings and 5\u{a0}kN.");
        assert_eq!(prose("\"wheel (at 40 mm)\" 2 – 3"), "&quot;wheel (at 40\u{a0}mm)&quot; 2\u{a0}– 3");
        assert_eq!(prose("≤ 600 N"), "≤\u{a0}600\u{a0}N");
        assert_eq!(escape("speed = \"300 rad/s\""), "speed = &quot;300 rad/s&quot;");
    }

    #[test]
    fn file_names_cannot_leave_the_folder() {
        for (name, want) in [
            ("..", "unnamed"),
            ("/abs/x", "abs-x"),
            ("a\0b", "a-b"),
            ("CON", "CON_"),
            ("com1.txt", "com1.txt_"),
            ("LPT²", "LPT²_"),
            ("..con", "con_"),
            ("a. .", "a"),
            ("a\u{202e}b", "a-b"),
            ("Läufer 2", "Läufer-2"),
        ] {
            assert_eq!(file_name(name), want);
        }
        assert!(file_name(&"ä".repeat(500)).len() <= 80);
    }

    #[test]
    fn fitted_text_fits() {
        let cut = fit("a very long label that cannot fit", 12.0, 80.0);
        assert!(cut.ends_with('…') && width(&cut, 12.0) <= 80.0);
        assert_eq!(fit("short", 12.0, 80.0), "short");
    }

    #[test]
    fn wrapped_text_is_whole_and_fits() {
        for text in ["front bearing at the drive end", "Einscheibenversuchsläufer", "a", "", "передняя опора ведущего конца"]
        {
            let lines = wrap(text, 11.0, 60.0);
            assert!(lines.iter().all(|l| width(l, 11.0) <= 60.0), "{lines:?}");
            let joined: String = lines.concat();
            assert_eq!(joined.replace(' ', ""), text.replace(' ', ""));
        }
    }

    #[test]
    fn coordinates() {
        assert_eq!([px(-0.01), px(1.0), px(1.26)], ["0", "1", "1.3"]);
    }
}
