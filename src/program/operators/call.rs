//! Operators with handles in place of numbers.

use super::table::operators;
use crate::dcel::{Corner, Side, Turn};
use crate::program::subject::Subject;
use alloc::string::{String, ToString};
use alloc::vec::Vec;
use core::fmt::{self, Display, Write as _};

macro_rules! define_call {
    ($($variant:ident $method:ident $share:literal {
        changes [$($change:expr),+]
        $($arg:ident: $pick:ident => $handle:ty, $depends:tt;)*
    })*) => {
        /// An operator with the handles that it chose, as [`Runner::resolve`](crate::program::Runner::resolve) tells. They may be
        /// stale.
        ///
        /// `Display` writes the handles alone, as in `h0 to h3, inner v1`.
        #[derive(Clone, Debug, PartialEq, Eq)]
        #[allow(missing_docs, reason = "the arguments are those of the methods of `Subject` of the same names")]
        pub enum Call<V, H, F> {
            $(
                #[doc = concat!("[`Subject::", stringify!($method), "`].")]
                $variant { $($arg: $handle),* },
            )*
        }

        impl<V, H, F> Call<V, H, F> {
            /// The same operator with other handles in place of those of vertices, half-edges and faces.
            pub fn map<W, I, G>(
                self,
                vertex: impl Fn(V) -> W,
                half_edge: impl Fn(H) -> I,
                face: impl Fn(F) -> G,
            ) -> Call<W, I, G> {
                let corner = |corner| match corner {
                    Corner::At(h) => Corner::At(half_edge(h)),
                    Corner::Isolated(v) => Corner::Isolated(vertex(v)),
                };
                match self {
                    $(Self::$variant { $($arg),* } => Call::$variant {
                        $($arg: mapped!($pick: $arg, vertex half_edge face corner)),*
                    },)*
                }
            }
        }

        impl<V: Display, H: Display, F: Display> Display for Call<V, H, F> {
            fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
                let mut words = String::new();
                match self {
                    $(Self::$variant { $($arg),* } => {
                        $(written!($pick: $arg, words);)*
                    })*
                }
                f.write_str(&words)
            }
        }
    };
}

/// The handle that an argument of this kind has become, with other handles.
macro_rules! mapped {
    (VertexPick: $of:ident, $vertex:ident $half_edge:ident $face:ident $corner:ident) => {
        $vertex($of)
    };
    (HalfEdgePick: $of:ident, $vertex:ident $half_edge:ident $face:ident $corner:ident) => {
        $half_edge($of)
    };
    (FacePick: $of:ident, $vertex:ident $half_edge:ident $face:ident $corner:ident) => {
        $face($of)
    };
    (CornerPick: $of:ident, $vertex:ident $half_edge:ident $face:ident $corner:ident) => {
        $corner($of)
    };
    (SecondPick: $of:ident, $vertex:ident $half_edge:ident $face:ident $corner:ident) => {
        $corner($of)
    };
    (InnerPick: $of:ident, $vertex:ident $half_edge:ident $face:ident $corner:ident) => {
        $of.into_iter().map($corner).collect()
    };
    ($value:ident: $of:ident, $vertex:ident $half_edge:ident $face:ident $corner:ident) => {
        $of
    };
}

/// Writes the handle that an argument of this kind has become. Sides and turns are no handles.
macro_rules! written {
    (VertexPick: $of:ident, $words:ident) => {
        join(&mut $words, "", $of)
    };
    (HalfEdgePick: $of:ident, $words:ident) => {
        join(&mut $words, "", $of)
    };
    (FacePick: $of:ident, $words:ident) => {
        join(&mut $words, "in ", $of)
    };
    (CornerPick: $of:ident, $words:ident) => {
        join(&mut $words, "", &corner_word($of))
    };
    (SecondPick: $of:ident, $words:ident) => {
        join(&mut $words, "", &corner_word($of))
    };
    (InnerPick: $of:ident, $words:ident) => {
        for (i, corner) in $of.iter().enumerate() {
            let _ = write!($words, "{}{}", if i == 0 { ", inner " } else { " " }, corner_word(corner));
        }
    };
    ($value:ident: $of:ident, $words:ident) => {
        let _ = $of;
    };
}
operators!(define_call);

fn join(words: &mut String, first: &str, handle: &impl Display) {
    let _ = write!(words, "{}{handle}", if words.is_empty() { first } else { " to " });
}

fn corner_word<H: Display, V: Display>(corner: &Corner<H, V>) -> String {
    match corner {
        Corner::At(h) => h.to_string(),
        Corner::Isolated(v) => v.to_string(),
    }
}

/// A call of the subject `K`.
pub type CallOf<K> = Call<<K as Subject>::Vertex, <K as Subject>::HalfEdge, <K as Subject>::Face>;
