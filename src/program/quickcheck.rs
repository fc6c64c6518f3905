//! Random programs, with shrinking.

use super::choose::Choose;
use super::op::{FacePick, Op, Program};
use super::shrink::candidates;
use alloc::boxed::Box;
use quickcheck::{Arbitrary, Gen};

impl Arbitrary for Op {
    fn arbitrary(g: &mut Gen) -> Self {
        let mut bytes = core::iter::repeat_with(|| Choose::choose(g, 256) as u8);
        Self::from_bytes(&mut bytes).unwrap_or(Self::AddIsolatedVertex { face: FacePick::Unbounded })
    }

    fn shrink(&self) -> Box<dyn Iterator<Item = Self>> {
        Box::new(self.simpler().into_iter())
    }
}

impl Arbitrary for Program {
    /// A vertex, without which there is nothing to be done, and up to [`Gen::size`] operators.
    fn arbitrary(g: &mut Gen) -> Self {
        Self::generator().length(1..=g.size().saturating_add(1)).generate(g)
    }

    fn shrink(&self) -> Box<dyn Iterator<Item = Self>> {
        Box::new(candidates(self))
    }
}
