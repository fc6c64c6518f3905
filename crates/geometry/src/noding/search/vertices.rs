//! The hot pixels by number: given ones, followed by the pixels that a search adds.

use crate::noding::pixel::Pixel;
use core::ops::Index;

pub(super) struct Vertices<'a> {
    given: &'a [Pixel],
    added: Vec<Pixel>,
    /// The number of vertices when this search began.
    before: usize,
}

impl<'a> Vertices<'a> {
    pub(super) const fn new(given: &'a [Pixel]) -> Self {
        Self { given, added: Vec::new(), before: given.len() }
    }

    pub(super) const fn len(&self) -> usize {
        self.given.len() + self.added.len()
    }

    /// Adds a pixel without a number, and returns its number; `None` if there are too many.
    pub(super) fn push(&mut self, pixel: Pixel) -> Option<u32> {
        let number = u32::try_from(self.len()).ok().filter(|number| *number < u32::MAX)?;
        self.added.push(pixel);
        Some(number)
    }

    /// Returns the current vertices, for a parallel search.
    pub(super) fn beside(&self) -> Self {
        Self { given: self.given, added: self.added.clone(), before: self.len() }
    }

    /// Adds the vertices of a parallel search. Returns a function from their numbers there to those here; `None` for too many.
    pub(super) fn take(&mut self, other: &Self) -> Option<impl Fn(u32) -> u32 + use<>> {
        let (before, moved) = (other.before as u32, (self.len() - other.before) as u32);
        self.added.extend_from_slice(&other.added[other.before - other.given.len()..]);
        let all_have_numbers = self.len() < u32::MAX as usize;
        all_have_numbers.then_some(move |v| if v < before { v } else { v + moved })
    }

    pub(super) fn added(self) -> Vec<Pixel> {
        self.added
    }
}

impl Index<usize> for Vertices<'_> {
    type Output = Pixel;

    #[inline]
    fn index(&self, v: usize) -> &Pixel {
        self.given.get(v).unwrap_or_else(|| &self.added[v - self.given.len()])
    }
}
