//! Programs as Rust source, to be pasted into a regression test.

use super::op::{CornerPick, FacePick, HalfEdgePick, InnerPick, Op, Program, SecondPick, VertexPick};
use super::table::operators;
use crate::dcel::{Side, Turn};
use alloc::format;
use alloc::string::String;

impl Program {
    /// The program as a Rust expression, to be read where `twinedge::program::*` is in scope.
    #[must_use]
    pub fn to_rust(&self) -> String {
        let mut source = String::from("Program(vec![\n");
        for op in &self.0 {
            source.push_str("    ");
            source.push_str(&op.to_rust());
            source.push_str(",\n");
        }
        source + "])"
    }
}

macro_rules! define_rust {
    ($($variant:ident $method:ident $share:literal {
        changes [$($change:expr),+]
        $($arg:ident: $pick:ty => $handle:ty, $depends:tt;)*
    })*) => {
        impl Op {
            /// The operator as a Rust expression, to be read where `twinedge::program::*` is in scope.
            #[must_use]
            pub fn to_rust(&self) -> String {
                match *self {
                    $(Self::$variant { $($arg),* } => {
                        let arguments = [$(format!(concat!(stringify!($arg), ": {}"), $arg.to_rust())),*];
                        format!(concat!("Op::", stringify!($variant), " {{ {} }}"), arguments.join(", "))
                    })*
                }
            }
        }
    };
}
operators!(define_rust);

/// An argument as a Rust expression.
trait ToRust {
    fn to_rust(self) -> String;
}

impl ToRust for HalfEdgePick {
    fn to_rust(self) -> String {
        format!("HalfEdgePick::{self:?}")
    }
}

impl ToRust for VertexPick {
    fn to_rust(self) -> String {
        format!("VertexPick::{self:?}")
    }
}

impl ToRust for CornerPick {
    fn to_rust(self) -> String {
        match self {
            Self::At(pick) => format!("Corner::At({})", pick.to_rust()),
            Self::Isolated(pick) => format!("Corner::Isolated({})", pick.to_rust()),
        }
    }
}

impl ToRust for SecondPick {
    fn to_rust(self) -> String {
        match self {
            Self::Fitting(k) => format!("SecondPick::Fitting({k})"),
            Self::Any(pick) => format!("SecondPick::Any({})", pick.to_rust()),
        }
    }
}

impl ToRust for FacePick {
    fn to_rust(self) -> String {
        match self {
            Self::Unbounded => String::from("FacePick::Unbounded"),
            Self::Of(pick) => format!("FacePick::Of({})", pick.to_rust()),
            Self::Retired(k) => format!("FacePick::Retired({k})"),
        }
    }
}

impl ToRust for InnerPick {
    fn to_rust(self) -> String {
        let also = self.also.map_or_else(|| String::from("None"), |pick| format!("Some({})", pick.to_rust()));
        format!("InnerPick {{ mask: {}, also: {also} }}", self.mask)
    }
}

impl ToRust for Side {
    fn to_rust(self) -> String {
        format!("Side::{self:?}")
    }
}

impl ToRust for Turn {
    fn to_rust(self) -> String {
        format!("Turn::{self:?}")
    }
}
