//! What a page embeds: numbers as base64, hashes for its content security policy.

use base64::prelude::{BASE64_STANDARD, Engine};
use sha2::{Digest, Sha256};

/// Numbers as little-endian single precision (seven digits) in base64.
pub(super) fn floats(values: impl Iterator<Item = f64>) -> String {
    // tiny numbers go to zero and huge ones to infinity; a drawing shows neither
    let bytes: Vec<u8> = values.flat_map(|v| (v as f32).to_le_bytes()).collect();
    BASE64_STANDARD.encode(&bytes)
}

/// SHA-256 of a style or script in base64.
pub(super) fn hash(text: &str) -> String {
    BASE64_STANDARD.encode(Sha256::digest(text.as_bytes()))
}
