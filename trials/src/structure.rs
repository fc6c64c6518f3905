//! The structure under test.

use crate::error::StructureError;
use crate::regression::TestSource;
use crate::verdict::judge;
use std::fmt;
use twinedge::program::Subject;
use twinedge::program::panics::catch;
use twinedge::validate::{Expectation, Part, Parts};

/// A structure under test: its name, a function that makes an empty one, and an expectation for the validator.
///
/// ```
/// use twinedge_trials::RawPointers;
/// use twinedge::validate::Expectation;
/// use twinedge_trials::Structure;
/// let mine = Structure::new("mine", RawPointers::new, Expectation::plane());
/// assert_eq!(mine.name(), "mine");
/// ```
pub struct Structure<K> {
    name: &'static str,
    make: fn() -> K,
    expectation: Expectation,
    source: Option<TestSource>,
}

impl<K> Clone for Structure<K> {
    fn clone(&self) -> Self {
        *self
    }
}

impl<K> Copy for Structure<K> {}

impl<K> fmt::Debug for Structure<K> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_struct("Structure").field("name", &self.name).finish_non_exhaustive()
    }
}

impl<K: Subject> Structure<K> {
    /// Returns a structure of this name. `make` makes the empty map.
    #[must_use]
    pub const fn new(name: &'static str, make: fn() -> K, expectation: Expectation) -> Self {
        Self { name, make, expectation, source: None }
    }

    /// Adds the Rust source that names it, for the regression tests that [`soak()`](crate::soak()) prints.
    #[must_use]
    pub const fn source(mut self, source: TestSource) -> Self {
        self.source = Some(source);
        self
    }

    /// Returns its name, as shown in outcomes.
    #[must_use]
    pub const fn name(&self) -> &'static str {
        self.name
    }

    /// Returns its expectation.
    #[must_use]
    pub const fn expectation(&self) -> Expectation {
        self.expectation
    }

    /// Makes an empty map.
    #[must_use]
    pub fn make(&self) -> K {
        (self.make)()
    }

    pub(crate) const fn test_source(&self) -> Option<&TestSource> {
        self.source.as_ref()
    }

    /// Checks that maps can be told apart by faces, the lists of their boundary components, and the unbounded face.
    pub(crate) fn can_be_told_apart(&self) -> Result<(), StructureError> {
        // A structure that panics passes here: engines report that.
        let stored = catch(|| self.make().parts()).unwrap_or(Parts::ALL);
        let needed = [Part::Faces, Part::Holes, Part::UnboundedFace];
        let lacks = needed.into_iter().find(|part| !self.expectation.looks_at(stored).has(*part));
        lacks.map_or(Ok(()), |part| Err(StructureError::Lacks(part)))
    }

    /// Checks that the empty map keeps the rules. A structure that panics passes: engines report that with the program at fault.
    pub(crate) fn starts_valid(&self) -> Result<(), StructureError> {
        let Ok(report) = catch(|| judge(&self.make(), &self.expectation)) else { return Ok(()) };
        report.first().map_or(Ok(()), |violation| Err(StructureError::InvalidStart(*violation)))
    }
}
