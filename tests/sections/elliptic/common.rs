//! What the tests of elliptic functions share.

use super::*;

/// `m:0x…` or `mc:0x…`.
pub fn parameter(text: &str) -> Result<Parameter> {
    match text.split_once(':') {
        Some(("m", value)) => Parameter::from_parameter(hexadecimal(value)),
        Some(("mc", value)) => Parameter::from_complement(hexadecimal(value)),
        _ => panic!("{text}"),
    }
}
