//! Random programs, with shrinking.

use super::op::{FacePick, Op, Program};
use super::shrink::candidates;
use alloc::boxed::Box;
use alloc::vec::Vec;
use quickcheck::{Arbitrary, Gen};

impl Arbitrary for Op {
    fn arbitrary(g: &mut Gen) -> Self {
        let all: [u8; 256] = core::array::from_fn(|byte| byte as u8);
        // `u8::arbitrary` prefers 0 and 255, which are nothing special here.
        let mut bytes = core::iter::from_fn(|| g.choose(&all).copied());
        Self::from_bytes(&mut bytes).unwrap_or(Self::AddIsolatedVertex { face: FacePick::Unbounded })
    }

    fn shrink(&self) -> Box<dyn Iterator<Item = Self>> {
        Box::new(self.simpler().into_iter())
    }
}

impl Arbitrary for Program {
    /// A vertex, without which there is nothing to be done, and up to [`Gen::size`] operators.
    fn arbitrary(g: &mut Gen) -> Self {
        let first = Op::AddIsolatedVertex { face: FacePick::Unbounded };
        core::iter::once(first).chain(Vec::arbitrary(g)).collect()
    }

    fn shrink(&self) -> Box<dyn Iterator<Item = Self>> {
        Box::new(candidates(self))
    }
}
