//! The part of an address behind the question mark.

/// The value of a name, with `%` and `+` decoded; `None` where it is missing or no text.
pub(crate) fn value(query: Option<&str>, name: &str) -> Option<String> {
    let pair = query?.split('&').filter_map(|p| p.split_once('=')).find(|p| p.0 == name)?;
    decoded(pair.1)
}

fn decoded(text: &str) -> Option<String> {
    let mut out = Vec::with_capacity(text.len());
    let mut bytes = text.bytes();
    while let Some(b) = bytes.next() {
        out.push(match b {
            b'+' => b' ',
            b'%' => {
                let digit = |b: Option<u8>| (b? as char).to_digit(16);
                (16 * digit(bytes.next())? + digit(bytes.next())?) as u8
            }
            b => b,
        });
    }
    String::from_utf8(out).ok()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn values_are_decoded_and_what_is_no_text_is_none() {
        let q = Some("lang=ru&file=a%20b%2Fc.toml&x=%d0%b6+1&bad=%zz&cut=%4&raw=%ff");
        assert_eq!(value(q, "file").as_deref(), Some("a b/c.toml"));
        assert_eq!(value(q, "x").as_deref(), Some("ж 1"));
        for name in ["bad", "cut", "raw", "none"] {
            assert_eq!(value(q, name), None, "{name}");
        }
        assert_eq!(value(None, "file"), None);
    }
}
