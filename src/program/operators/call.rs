//! What an operator of a program comes to: the operator with handles in place of numbers.

use super::table::operators;
use crate::dcel::{Corner, Side, Turn};
use crate::program::subject::Subject;
use alloc::vec::Vec;

macro_rules! define_call {
    ($($variant:ident $method:ident $share:literal {
        changes [$($change:expr),+]
        $($arg:ident: $pick:ty => $handle:ty, $depends:tt;)*
    })*) => {
        /// An operator with the handles that it chose, as [`Runner::resolve`](crate::program::Runner::resolve) tells. They may be
        /// stale.
        #[derive(Clone, Debug, PartialEq, Eq)]
        #[allow(missing_docs, reason = "the arguments are those of the methods of `Subject` of the same names")]
        pub enum Call<V, H, F> {
            $(
                #[doc = concat!("[`Subject::", stringify!($method), "`].")]
                $variant { $($arg: $handle),* },
            )*
        }
    };
}
operators!(define_call);

/// A call of the subject `K`.
pub type CallOf<K> = Call<<K as Subject>::Vertex, <K as Subject>::HalfEdge, <K as Subject>::Face>;
