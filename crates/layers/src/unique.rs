//! Distinct column names.

use std::collections::HashSet;

/// Returns a name that no other column has, ignoring case.
pub(super) fn unique(name: &str, taken: &mut HashSet<String>) -> String {
    let mut free = if name.is_empty() { "field".to_owned() } else { name.to_owned() };
    for number in 1.. {
        if taken.insert(free.to_lowercase()) {
            break;
        }
        free = format!("{name}_{number}");
    }
    free
}
