//! Places in a text: bytes here, UTF-16 code units in the page.

/// The places of a text.
pub(crate) struct Offsets {
    /// Byte behind each character that takes another number of bytes than of code units, and the code unit there.
    marks: Vec<(usize, usize)>,
}

impl Offsets {
    pub fn new(text: &str) -> Offsets {
        let mut marks = Vec::new();
        let mut units = 0;
        for (at, c) in text.char_indices() {
            units += c.len_utf16();
            if !c.is_ascii() {
                marks.push((at + c.len_utf8(), units));
            }
        }
        Offsets { marks }
    }

    /// The code unit of a byte at which a character begins.
    pub fn units(&self, byte: usize) -> usize {
        match self.marks.partition_point(|m| m.0 <= byte).checked_sub(1).and_then(|k| self.marks.get(k)) {
            Some((b, u)) => u + (byte - b),
            None => byte,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn places_count_code_units() {
        let text = "aµ😀ж z";
        let offsets = Offsets::new(text);
        for (at, _) in text.char_indices().chain([(text.len(), ' ')]) {
            assert_eq!(offsets.units(at), text[..at].encode_utf16().count(), "{at}");
        }
    }
}
