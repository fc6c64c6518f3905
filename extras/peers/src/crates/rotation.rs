//! Derives the `next` of border half-edges for structures that store none.

/// The border half-edge that follows `border`, found by turning around its target: from its twin by `previous` and
/// `twin`, up to a half-edge without face. Nil if the turn takes more than `limit` steps.
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
