//! The manifest of a folder: whose results these are, and which chunks are done.

use super::Plan;
use super::cells::Column;
use crate::build;
use crate::hash::sha256;
use crate::text;
use crate::text::{Argument, Text};
use serde::{Deserialize, Serialize};
use serde_json::{Value as Json, json};
use std::collections::BTreeMap;

/// Version of the layout of the folder.
pub const FORMAT: u32 = 2;

/// `manifest.json`.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Manifest {
    pub format: u32,
    pub laval: String,
    /// The build that computes.
    pub build: String,
    /// Widest instructions of its processor.
    pub processor: String,
    pub study: String,
    /// SHA-256 of all that settles the numbers.
    pub input_hash: String,
    pub rows: usize,
    pub chunk_rows: usize,
    pub columns: Vec<Column>,
    pub input: Json,
    pub chunks: Vec<Entry>,
}

/// A chunk that is done.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Entry {
    pub chunk: usize,
    pub file: String,
    pub sha256: String,
}

impl Manifest {
    pub fn new(plan: &Plan, input: &Json) -> Manifest {
        let mut out = Manifest {
            format: FORMAT,
            laval: env!("CARGO_PKG_VERSION").into(),
            build: build::ID.into(),
            processor: build::processor().into(),
            study: plan.study.clone(),
            input_hash: String::new(),
            rows: plan.rows,
            chunk_rows: plan.chunk,
            columns: plan.columns.clone(),
            input: input.clone(),
            chunks: Vec::new(),
        };
        out.input_hash = hash_of(&out.identity());
        out
    }

    /// All that settles the numbers and how they lie in files. Rows of two builds or processors may differ in their last digits, so that they may not
    /// stand in one table.
    fn identity(&self) -> Json {
        let columns: Vec<String> = self.columns.iter().map(|c| format!("{} [{}] {:?}", c.name, c.unit, c.kind)).collect();
        json!({
            "laval version": self.laval, "build": self.build, "processor": self.processor, "kind of study": self.study, "number of rows": self.rows, "rows of a chunk": self.chunk_rows,
            "columns": columns, "input": self.input,
        })
    }

    /// What differs between the input of a folder and that of this run, in words.
    pub fn differences(&self, now: &Manifest) -> Vec<Text> {
        let (mut old, mut new) = (BTreeMap::new(), BTreeMap::new());
        flatten("", &self.identity(), &mut old);
        flatten("", &now.identity(), &mut new);
        let mut keys: Vec<&String> = old.keys().chain(new.keys().filter(|k| !old.contains_key(*k))).collect();
        // the number of rows and columns follows from what was requested: the cause before its effects
        keys.sort_by_key(|k| (!k.starts_with("input."), k.as_str()));
        let word = |map: &BTreeMap<String, String>, k: &String| map.get(k).map_or_else(|| text!("not given").argument(), |w| w.argument());
        keys.into_iter()
            .filter(|k| old.get(*k) != new.get(*k))
            .map(|k| {
                let what = k.strip_prefix("input.").unwrap_or(k);
                text!("{what} was {old}, now {new}", what, old = word(&old, k), new = word(&new, k))
            })
            .collect()
    }

    pub fn text(&self) -> Result<String, String> {
        // JSON leaves the second block of control characters and marks that reorder text as they are
        serde_json::to_string_pretty(self).map(|t| crate::plain::lines(&(t + "\n")).into_owned()).map_err(|e| e.to_string())
    }
}

fn hash_of(identity: &Json) -> String {
    let mut text = String::new();
    canonical(identity, &mut text);
    format!("sha256:{}", sha256(text.as_bytes()))
}

/// JSON with the keys of every object in order.
fn canonical(value: &Json, out: &mut String) {
    match value {
        Json::Object(o) => {
            let sorted: BTreeMap<&String, &Json> = o.iter().collect();
            out.push('{');
            for (k, v) in sorted {
                out.push_str(&Json::from(k.as_str()).to_string());
                out.push(':');
                canonical(v, out);
                out.push(',');
            }
            out.push('}');
        }
        Json::Array(list) => {
            out.push('[');
            for v in list {
                canonical(v, out);
                out.push(',');
            }
            out.push(']');
        }
        other => out.push_str(&other.to_string()),
    }
}

/// Every leaf by its path; members of a list by their name where they have one.
fn flatten(path: &str, value: &Json, out: &mut BTreeMap<String, String>) {
    let at = |key: &str| if path.is_empty() { key.to_string() } else { format!("{path}.{key}") };
    match value {
        Json::Object(o) => o.iter().for_each(|(k, v)| flatten(&at(k), v, out)),
        Json::Array(list) => {
            for (i, v) in list.iter().enumerate() {
                let name = v.get("name").and_then(Json::as_str).map_or_else(|| (i + 1).to_string(), str::to_string);
                flatten(&at(&name), v, out);
            }
        }
        leaf => {
            out.insert(path.to_string(), leaf.to_string());
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn manifest(input: Json) -> Manifest {
        let plan = Plan { study: "s".into(), columns: vec![Column::float("x", "m", "")], rows: 10, chunk: 3 };
        Manifest::new(&plan, &input)
    }

    #[test]
    fn the_order_of_keys_is_no_difference_and_every_value_is() {
        let a = manifest(json!({"a": 1.5, "part": [{"name": "drum", "mass": 2.0}]}));
        let b = manifest(json!({"part": [{"mass": 2.0, "name": "drum"}], "a": 1.5}));
        assert_eq!((a.input_hash.clone(), a.differences(&b)), (b.input_hash, vec![]));
        let c = manifest(json!({"a": 1.5, "part": [{"name": "drum", "mass": 2.0000000000000004, "speed": "x"}]}));
        assert_ne!(a.input_hash, c.input_hash);
        assert_eq!(a.differences(&c), ["part.drum.mass was 2.0, now 2.0000000000000004", "part.drum.speed was not given, now \"x\""]);
    }

    #[test]
    fn another_build_or_processor_is_another_identity() {
        let a = manifest(json!({}));
        for other in [Manifest { build: "x".into(), ..a.clone() }, Manifest { processor: "x".into(), ..a.clone() }] {
            assert_ne!(hash_of(&other.identity()), a.input_hash);
            assert_eq!(a.differences(&other).len(), 1);
        }
        assert_eq!(hash_of(&a.identity()), a.input_hash);
    }

    #[test]
    fn text_and_back() {
        let mut a = manifest(json!({"x": [0.1, null, true]}));
        a.chunks.push(Entry { chunk: 2, file: "f".into(), sha256: "0".into() });
        let back: Manifest = serde_json::from_str(&a.text().unwrap()).unwrap();
        assert_eq!(back, a);
    }
}
