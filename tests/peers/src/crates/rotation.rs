//! Half-edges of a border for structures that keep no `next` there.

/// The half-edge of the border that follows `border`, found by turning around its target: from its twin, `previous` and
/// `twin` again and again, up to a half-edge without face. Nil if the turn does not end within `limit` steps.
pub(super) fn next_on_border<H: Copy>(
    border: H,
    limit: usize,
    twin: impl Fn(H) -> Option<H>,
    previous: impl Fn(H) -> Option<H>,
    is_border: impl Fn(H) -> bool,
) -> Option<H> {
    let mut h = twin(border)?;
    for _ in 0..=limit {
        if is_border(h) {
            return Some(h);
        }
        h = twin(previous(h)?)?;
    }
    None
}
