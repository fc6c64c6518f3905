//! Programs from the bytes of a fuzzer.

use super::op::{Op, Program};
use arbitrary::{Arbitrary, Error, Result, Unstructured};

impl<'a> Arbitrary<'a> for Op {
    fn arbitrary(u: &mut Unstructured<'a>) -> Result<Self> {
        let mut bytes = core::iter::from_fn(|| u.arbitrary().ok());
        Self::from_bytes(&mut bytes).ok_or(Error::NotEnoughData)
    }

    fn size_hint(_depth: usize) -> (usize, Option<usize>) {
        (2, Some(14))
    }
}

/// Where a program is all that is wanted, the bytes are read as by [`Program::from_bytes`], so a corpus is that of the
/// bytes.
impl<'a> Arbitrary<'a> for Program {
    fn arbitrary(u: &mut Unstructured<'a>) -> Result<Self> {
        u.arbitrary_iter()?.collect()
    }

    fn arbitrary_take_rest(u: Unstructured<'a>) -> Result<Self> {
        Ok(Self::from_bytes(u.take_rest()))
    }
}
