//! The parts of a file that the mesh does not hold.

use std::borrow::Cow;

/// A part of a file that the mesh does not hold.
#[derive(Clone, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
pub struct Dropped {
    /// A name: "normals", "property nx of element vertex".
    pub what: Cow<'static, str>,
    /// Their number.
    pub count: usize,
}

#[derive(Debug, Default)]
pub(super) struct Drops {
    list: Vec<Dropped>,
}

impl Drops {
    pub(super) fn add(&mut self, what: &'static str, count: usize) {
        if count == 0 {
            return;
        }
        // A reader drops only a few kinds of parts.
        match self.list.iter_mut().find(|dropped| dropped.what == what) {
            Some(dropped) => dropped.count += count,
            None => self.list.push(Dropped { what: Cow::Borrowed(what), count }),
        }
    }

    pub(super) fn add_if(&mut self, condition: bool, what: &'static str) {
        self.add(what, usize::from(condition));
    }

    pub(super) fn add_owned(&mut self, what: String, count: usize) {
        if count > 0 {
            self.list.push(Dropped { what: Cow::Owned(what), count });
        }
    }

    pub(super) fn into_list(self) -> Vec<Dropped> {
        self.list
    }
}
