//! The language: edits whose arguments are small numbers and points, so that any bytes are a program that runs.

use super::draw::Draw;
use super::pick::{AtPick, FeaturesPick, GridPick, MapFacePick, MapHalfEdgePick, MapVertexPick, RingPick, Spot};
use super::table::edits;
use crate::program::choose::Choose;
use crate::program::{Generator, Language};

macro_rules! define_op {
    ($($variant:ident $method:ident $share:literal { $($arg:ident: $pick:ty;)* })*) => {
        /// One edit with its arguments.
        #[derive(Clone, Debug, PartialEq, Eq, Hash)]
        #[allow(missing_docs, reason = "the arguments are those of the methods of `PlanarMap` of the same names")]
        pub enum EditOp {
            $(
                #[doc = concat!(
                    "[`PlanarMap::", stringify!($method), "`](crate::map::PlanarMap::", stringify!($method), ")."
                )]
                $variant { $($arg: $pick),* },
            )*
        }

        /// The kinds of edits, for a [`Generator`].
        #[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
        pub enum EditKind {
            $(
                #[doc = concat!("[`EditOp::", stringify!($variant), "`].")]
                $variant,
            )*
        }

        impl EditKind {
            /// All kinds, each with how often it is drawn, in proportion to the others.
            pub const SHARES: &[(Self, u32)] = &[$((Self::$variant, $share)),*];
        }

        impl EditOp {
            /// The names of all edits, as texts have them.
            pub const NAMES: &[&str] = &[$(stringify!($method)),*];

            /// The name of the edit.
            #[must_use]
            pub const fn name(&self) -> &'static str {
                match self {
                    $(Self::$variant { .. } => stringify!($method),)*
                }
            }
        }

        impl Language for EditProgram {
            type Kind = EditKind;

            const KINDS: &'static [(EditKind, u32)] = EditKind::SHARES;

            fn op(kind: EditKind, source: &mut impl Choose) -> EditOp {
                match kind {
                    $(EditKind::$variant => EditOp::$variant { $($arg: Draw::draw(source)),* },)*
                }
            }
        }
    };
}
edits!(define_op);

/// A sequence of edits, to be run by an [`EditRunner`](super::EditRunner).
///
/// ```
/// use twinedge::map::PlanarMap;
/// use twinedge::map::program::{EditProgram, EditRunner};
///
/// let program = EditProgram::from_bytes(b"any bytes are a program of edits, and each edit leaves a valid map");
/// let mut runner = EditRunner::new(PlanarMap::new());
/// runner.run_checked(&program)?;
/// // It can be written down, and read again.
/// assert_eq!(program.to_string().parse(), Ok(program));
/// # Ok::<(), twinedge::map::program::EditFailure>(())
/// ```
#[derive(Clone, Debug, Default, PartialEq, Eq, Hash)]
pub struct EditProgram(pub Vec<EditOp>);

impl EditProgram {
    /// The program that these bytes encode: every choice takes as few as it needs, and those that end too early are followed by
    /// zeros. O(bytes).
    #[must_use]
    pub fn from_bytes(bytes: &[u8]) -> Self {
        Self::generator().decode(bytes)
    }

    /// A generator of programs, to be told which edits, how often, and how many.
    ///
    /// ```
    /// use twinedge::map::program::{EditKind, EditOp, EditProgram};
    /// use twinedge::program::choose::Bytes;
    ///
    /// let drawing = EditProgram::generator().only(&[EditKind::InsertSegment]).length(3..=3);
    /// let program = drawing.generate(&mut Bytes::new(b"choices"));
    /// assert!(program.0.iter().all(|edit| matches!(edit, EditOp::InsertSegment { .. })));
    /// assert_eq!(program.0.len(), 3);
    /// ```
    #[must_use]
    pub fn generator() -> Generator<Self> {
        Generator::default()
    }
}

impl FromIterator<EditOp> for EditProgram {
    fn from_iter<I: IntoIterator<Item = EditOp>>(ops: I) -> Self {
        Self(ops.into_iter().collect())
    }
}
