//! A sentence for people as data: its English template and what stands in it, so that other languages can say it too.

use crate::units::{DIGITS, format_number, format_si};
use std::borrow::Cow;
use std::fmt::{self, Write as _};

/// A sentence or phrase: an English template with named places, and what stands in them. [`text!`](crate::text!) makes it.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Text {
    template: &'static str,
    args: Box<[(&'static str, Arg)]>,
}

/// What stands in a place of a template.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Arg {
    /// The same in all languages: a name, a word of the file, what is to be written there.
    Plain(String),
    /// A number without unit, as English writes it.
    Number(String),
    /// A value in its SI unit; who shows it chooses the unit of the reader.
    Quantity(Value),
    /// A count: chooses plural forms.
    Count(u64),
    /// A fixed English phrase of a declaration, such as what a key means.
    Term(&'static str),
    /// A phrase.
    Text(Text),
    /// A phrase with a capital at its beginning.
    Capital(Text),
    /// Several, joined.
    List(Vec<Arg>, Joint),
}

/// A value in an SI unit (`""` is a pure number).
#[derive(Clone, Debug)]
pub struct Value {
    /// In the SI unit.
    pub value: f64,
    /// The SI unit.
    pub unit: Cow<'static, str>,
    /// Significant digits; as many as people read where there is none.
    pub digits: Option<u8>,
}

/// Compared bit by bit: NaN equals itself, and so does every sentence.
impl PartialEq for Value {
    fn eq(&self, other: &Value) -> bool {
        self.value.to_bits() == other.value.to_bits() && self.unit == other.unit && self.digits == other.digits
    }
}
impl Eq for Value {}

/// What stands between the entries of a list.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Joint {
    /// `, `
    Comma,
    /// `; `
    Semicolon,
    /// `, `, and before the last ` and `.
    And,
    /// ` and ` between all.
    Ands,
    /// `, `, and before the last ` or `.
    Or,
    /// ` or ` between all.
    Ors,
}

impl Joint {
    /// The English text between two entries; `last` before the last one.
    fn english(self, last: bool) -> &'static str {
        match self {
            Joint::And if last => " and ",
            Joint::Or if last => " or ",
            Joint::Ands => " and ",
            Joint::Ors => " or ",
            Joint::Semicolon => "; ",
            Joint::Comma | Joint::And | Joint::Or => ", ",
        }
    }
}

/// A sentence with what stands in its places: `text!("{name} must be positive, not {value}", name, value = x)`. A place without value takes the
/// variable of its name. A template whose places are not the names given does not compile.
///
/// ```
/// use laval_model::text;
/// let name = "mass";
/// let said = text!("{name} must be positive, not {value}", name, value = -2.0);
/// assert_eq!(said.to_string(), "mass must be positive, not -2");
/// ```
///
/// ```compile_fail
/// laval_model::text!("{name} must be positive", value = 3);
/// ```
#[macro_export]
macro_rules! text {
    (@value $name:ident) => { $crate::text::Argument::argument(&$name) };
    (@value $name:ident = $value:expr) => { $crate::text::Argument::argument(&$value) };
    ($template:literal $(, $name:ident $(= $value:expr)?)* $(,)?) => {{
        const _: () = $crate::text::check($template, &[$(stringify!($name)),*]);
        $crate::text::Text::of_template($template, ::std::boxed::Box::new([$((stringify!($name), $crate::text!(@value $name $(= $value)?))),*]))
    }};
}

impl Text {
    /// For [`text!`](crate::text!) alone: translations are looked up by the templates that stand in it.
    #[doc(hidden)]
    pub fn of_template(template: &'static str, args: Box<[(&'static str, Arg)]>) -> Self {
        Text { template, args }
    }

    /// The English sentence with its places: `{name}`; braces of the text itself are doubled.
    pub fn template(&self) -> &'static str {
        self.template
    }

    /// What stands in the places, in the order in which it was given.
    pub fn args(&self) -> &[(&'static str, Arg)] {
        &self.args
    }

    /// The English text contains this.
    pub fn contains(&self, part: &str) -> bool {
        self.to_string().contains(part)
    }

    /// The English text begins so.
    pub fn starts_with(&self, part: &str) -> bool {
        self.to_string().starts_with(part)
    }
}

/// The name of a template in catalogues: its first words and a check sum of the whole.
pub fn id(template: &str) -> String {
    const WORDS: usize = 6;
    let mut plain = String::new();
    let mut inside = false;
    for c in template.chars() {
        match c {
            '{' => inside = true,
            '}' => inside = false,
            c if inside || !c.is_ascii_alphanumeric() => plain.push(' '),
            c => plain.push(c.to_ascii_lowercase()),
        }
    }
    // FNV-1a, folded to 16 bits
    let hash = template.bytes().fold(0x811c_9dc5_u32, |h, b| (h ^ u32::from(b)).wrapping_mul(0x0100_0193));
    let words: Vec<&str> = plain.split_whitespace().take(WORDS).collect();
    format!("diag-{}{}{:04x}", words.join("-"), if words.is_empty() { "" } else { "-" }, (hash >> 16) ^ (hash & 0xffff))
}

/// The names of the places of a template, in order.
pub fn places(template: &str) -> Vec<&str> {
    let mut out = Vec::new();
    pieces(template, |p| {
        if let Piece::Place(name) = p {
            out.push(name);
        }
    });
    out
}

enum Piece<'a> {
    Words(&'a str),
    Place(&'a str),
}

fn pieces<'a>(template: &'a str, mut each: impl FnMut(Piece<'a>)) {
    let mut rest = template;
    while let Some(at) = rest.find(['{', '}']) {
        let brace = &rest[at..=at];
        if rest[at + 1..].starts_with(brace) {
            each(Piece::Words(&rest[..=at]));
            rest = &rest[at + 2..];
            continue;
        }
        each(Piece::Words(&rest[..at]));
        let end = rest[at..].find('}').map_or(rest.len(), |e| at + e);
        each(Piece::Place(&rest[at + 1..end]));
        rest = rest.get(end + 1..).unwrap_or_default();
    }
    each(Piece::Words(rest));
}

/// Fails at compile time where the places of a template and the names given differ.
#[doc(hidden)]
pub const fn check(template: &str, names: &[&str]) {
    let t = template.as_bytes();
    let mut used = [false; 32];
    let mut i = 0;
    while i < t.len() {
        if t[i] != b'{' && t[i] != b'}' {
            i += 1;
            continue;
        }
        if i + 1 < t.len() && t[i + 1] == t[i] {
            i += 2;
            continue;
        }
        assert!(t[i] == b'{', "a single closing brace in a template");
        let start = i + 1;
        while i < t.len() && t[i] != b'}' {
            i += 1;
        }
        assert!(i < t.len(), "a place of a template is not closed");
        let mut k = 0;
        let mut found = false;
        while k < names.len() {
            if same(t, start, i, names[k].as_bytes()) {
                used[k] = true;
                found = true;
            }
            k += 1;
        }
        assert!(found, "a place of the template has no value");
        i += 1;
    }
    let mut k = 0;
    while k < names.len() {
        assert!(used[k], "a value has no place in the template");
        k += 1;
    }
}

const fn same(t: &[u8], start: usize, end: usize, name: &[u8]) -> bool {
    if end - start != name.len() {
        return false;
    }
    let mut i = 0;
    while i < name.len() {
        if t[start + i] != name[i] {
            return false;
        }
        i += 1;
    }
    true
}

/// The text with its first letter as a capital.
pub fn capital(text: &str) -> String {
    let mut chars = text.chars();
    chars.next().map(|f| f.to_uppercase().chain(chars).collect()).unwrap_or_default()
}

/// A word of the file in quotation marks, as it would be written there.
pub fn quoted(word: &(impl fmt::Debug + ?Sized)) -> Arg {
    Arg::Plain(format!("{word:?}"))
}

/// A value in its SI unit, for the reader in the unit of the file.
pub fn quantity(value: f64, unit: impl Into<Cow<'static, str>>) -> Arg {
    Arg::Quantity(Value { value, unit: unit.into(), digits: None })
}

/// The same with so many digits that it differs from another value in every unit.
pub fn quantity_beside(value: f64, other: f64, unit: impl Into<Cow<'static, str>>) -> Arg {
    let apart = (value - other).abs() / value.abs().max(other.abs());
    let digits = 1.0 + (-apart.log10()).ceil();
    let digits = (digits > f64::from(DIGITS)).then(|| digits.min(17.0) as u8);
    Arg::Quantity(Value { value, unit: unit.into(), digits })
}

/// A number without unit, with at most `significant` digits.
pub fn number(x: f64, significant: usize) -> Arg {
    Arg::Number(format_number(x, significant))
}

/// Fixed phrase of a declaration.
pub fn term(phrase: &'static str) -> Arg {
    Arg::Term(phrase)
}

/// A phrase that begins a sentence.
pub fn sentence(phrase: Text) -> Arg {
    Arg::Capital(phrase)
}

/// Several entries, joined.
pub fn list<T: Argument>(entries: impl IntoIterator<Item = T>, joint: Joint) -> Arg {
    Arg::List(entries.into_iter().map(|e| e.argument()).collect(), joint)
}

impl fmt::Display for Arg {
    /// In English.
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Arg::Plain(text) | Arg::Number(text) => f.write_str(text),
            Arg::Quantity(q) => f.write_str(&format_si(q.value, &q.unit, q.digits.unwrap_or(DIGITS))),
            Arg::Count(n) => write!(f, "{n}"),
            Arg::Term(text) => f.write_str(text),
            Arg::Text(text) => text.fmt(f),
            Arg::Capital(text) => f.write_str(&capital(&text.to_string())),
            Arg::List(all, joint) => all.iter().enumerate().try_for_each(|(k, a)| {
                f.write_str(if k == 0 { "" } else { joint.english(k + 1 == all.len()) })?;
                a.fmt(f)
            }),
        }
    }
}

impl fmt::Display for Text {
    /// In English.
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(&fill(self.template, |name| {
            self.args.iter().find(|a| a.0 == name).map_or_else(|| format!("{{{name}}}"), |a| a.1.to_string())
        }))
    }
}

/// A template with its places filled.
pub fn fill(template: &str, mut value: impl FnMut(&str) -> String) -> String {
    let mut out = String::with_capacity(template.len() + 32);
    pieces(template, |p| {
        // writing to a string does not fail
        let _ = match p {
            Piece::Words(w) => out.write_str(w),
            Piece::Place(name) => out.write_str(&value(name)),
        };
    });
    out
}

/// The English text.
impl PartialEq<str> for Text {
    fn eq(&self, other: &str) -> bool {
        self.to_string().as_str() == other
    }
}

/// The English text.
impl PartialEq<String> for Text {
    fn eq(&self, other: &String) -> bool {
        *self == **other
    }
}

/// The English text.
impl PartialEq<&str> for Text {
    fn eq(&self, other: &&str) -> bool {
        *self == **other
    }
}

/// What can stand in a place of a template.
pub trait Argument {
    /// As an argument.
    fn argument(&self) -> Arg;
}

macro_rules! plain {
    ($($t:ty),*) => { $(impl Argument for $t {
        fn argument(&self) -> Arg {
            Arg::Plain(self.to_string())
        }
    })* };
}
plain!(str, String, char, i32, i64, std::io::Error, std::path::Display<'_>, fmt::Arguments<'_>);

macro_rules! count {
    ($($t:ty),*) => { $(impl Argument for $t {
        fn argument(&self) -> Arg {
            Arg::Count(u64::from(*self))
        }
    })* };
}
count!(u8, u16, u32, u64);

impl Argument for f64 {
    fn argument(&self) -> Arg {
        Arg::Number(self.to_string())
    }
}

impl Argument for usize {
    fn argument(&self) -> Arg {
        Arg::Count(*self as u64)
    }
}

impl Argument for Arg {
    fn argument(&self) -> Arg {
        self.clone()
    }
}

impl Argument for Text {
    fn argument(&self) -> Arg {
        Arg::Text(self.clone())
    }
}

impl Argument for Cow<'_, str> {
    fn argument(&self) -> Arg {
        Arg::Plain(self.to_string())
    }
}

impl<T: Argument + ?Sized> Argument for &T {
    fn argument(&self) -> Arg {
        (**self).argument()
    }
}

impl<T: Argument + ?Sized> Argument for Box<T> {
    fn argument(&self) -> Arg {
        (**self).argument()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_english_sentence_is_the_template_with_its_places_filled() {
        let name = "drum";
        let t = crate::text!("{name} has {n} balls: write {{ x = {x} }}", name, n = 3usize, x = quoted("1 \"mm\""));
        assert_eq!(t.to_string(), "drum has 3 balls: write { x = \"1 \\\"mm\\\"\" }");
        assert_eq!(places(t.template()), ["name", "n", "x"]);
        assert!(t.contains("has 3") && t.starts_with("drum") && t == *t.to_string());
    }

    #[test]
    fn phrases_and_lists_nest() {
        let inner = crate::text!("parts of this file: {names}", names = list(["a", "b", "c"], Joint::And));
        let t = crate::text!("did you mean {near}? {rest}", near = quoted("a"), rest = sentence(inner));
        assert_eq!(t.to_string(), "did you mean \"a\"? Parts of this file: a, b and c");
        let joined = |j| list(["a", "b", "c"], j).to_string();
        assert_eq!([Joint::Ands, Joint::Or, Joint::Ors].map(joined), ["a and b and c", "a, b or c", "a or b or c"]);
    }

    #[test]
    fn names_of_templates_begin_with_their_words() {
        let id = id("{who} has no {key}: {doc}");
        assert!(id.starts_with("diag-has-no-") && id.len() == "diag-has-no-".len() + 4, "{id}");
        assert_ne!(super::id("{a}"), super::id("{b}"));
    }
}
