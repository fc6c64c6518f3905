//! The numbers that a certificate of surfaces proves.

use core::fmt;

/// The numbers that a [`SurfaceCertificate`](super::SurfaceCertificate) proves.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[non_exhaustive]
pub struct SurfaceCounts {
    /// The sum of the genera of the components, once their holes are filled.
    pub genus: usize,
    /// The number of components with edges.
    pub components: usize,
    /// The number of holes, equal to the number of border loops.
    pub holes: usize,
    /// The number of vertices with edges.
    pub vertices: usize,
    /// The number of edges.
    pub edges: usize,
    /// The number of faces.
    pub faces: usize,
}

/// In the words of Coq's checker.
impl fmt::Display for SurfaceCounts {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self { genus, components, holes, .. } = self;
        let plural = |count: usize| if count == 1 { "" } else { "s" };
        write!(f, "a surface of genus {genus} with {components} component{}, ", plural(*components))?;
        match holes {
            0 => f.write_str("closed"),
            _ => write!(f, "open at {holes} hole{}", plural(*holes)),
        }
    }
}
