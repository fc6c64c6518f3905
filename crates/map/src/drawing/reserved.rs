//! Memory that is asked for before it is used.

/// An empty column with memory for `n` entries, if there is as much.
pub(super) fn reserved<T>(n: usize) -> Option<Vec<T>> {
    let mut column = Vec::new();
    column.try_reserve_exact(n).ok()?;
    Some(column)
}
