//! Columns with reserved memory.

/// Returns an empty column with memory for `n` entries, or `None` if memory runs out.
pub(super) fn reserved<T>(n: usize) -> Option<Vec<T>> {
    let mut column = Vec::new();
    column.try_reserve_exact(n).ok()?;
    Some(column)
}
