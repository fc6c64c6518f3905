//! What known libraries promise of their structures.

use crate::validate::expectation::{Expectation, Part};

macro_rules! presets {
    ($($(#[doc = $doc:literal])* $variant:ident $name:literal from $source:literal $expectation:expr;)*) => {
        /// The expectation for the structures of a library, as its documentation describes them. What a single structure is to be
        /// beyond that (closed, of some genus) is asked for in addition.
        ///
        /// ```
        /// use twinedge::validate::Rule;
        /// use twinedge::validate::interchange::Preset;
        /// assert_eq!(Preset::from_name("openmesh"), Some(Preset::OpenMesh));
        /// assert!(Preset::OpenMesh.expectation().asks_for(Rule::M8));
        /// let closed = Preset::OpenMesh.expectation().closed().genus(0);
        /// ```
        #[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
        #[non_exhaustive]
        pub enum Preset {
            $($(#[doc = $doc])* #[doc = concat!("\n\nSource: ", $source, ".")] $variant,)*
        }

        impl Preset {
            /// All presets.
            pub const ALL: &[Self] = &[$(Self::$variant),*];

            /// The name, in snake case.
            #[must_use]
            pub const fn name(self) -> &'static str {
                match self { $(Self::$variant => $name,)* }
            }

            /// The documentation that says so.
            #[must_use]
            pub const fn source(self) -> &'static str {
                match self { $(Self::$variant => $source,)* }
            }

            /// The expectation.
            #[must_use]
            pub const fn expectation(self) -> Expectation {
                match self { $(Self::$variant => $expectation,)* }
            }
        }
    };
}

/// A surface with or without border, of half-edges that name a face.
const MESH: Expectation = Expectation::surface().without(Part::BoundaryComponents).open();

presets! {
    /// `CGAL::Surface_mesh`: half-edges along a border are there, are linked, and have no face. Vertices keep a half-edge that
    /// *arrives*: answer `leaving` with its next, which is on the border if it is. That a border vertex keeps a border
    /// half-edge is left to its users, so [`border_kept`](Expectation::border_kept) must be asked for in addition.
    SurfaceMesh "surface_mesh"
        from "CGAL, user manual of 3D Surface Mesh, sections Connectivity and Borders"
        MESH;
    /// `OpenMesh`: the same, with vertices that keep a half-edge that leaves them, one of the border where there is one
    /// (`adjust_outgoing_halfedge`, on which `is_boundary` of a vertex relies).
    OpenMesh "openmesh"
        from "OpenMesh, The Halfedge Data Structure, and reference of PolyConnectivity::adjust_outgoing_halfedge"
        MESH.border_kept();
    /// `CGAL::Arrangement_2`: a planar subdivision with records for boundary components (outer and inner CCBs) and isolated
    /// vertices, which do not keep their place in the list of the face. It has one unbounded face if all curves are bounded.
    Arrangement2 "arrangement_2"
        from "CGAL, user manual of 2D Arrangements, section Representation of Arrangements: The Dcel"
        Expectation::plane().without(Part::Places);
    /// `trimesh.Trimesh`: triangles, and no half-edges. Corners are half-edges, and an edge that one triangle has is a border.
    /// For a mesh that is watertight, ask for [`closed`](Expectation::closed) in addition.
    Trimesh "trimesh"
        from "trimesh, reference of Trimesh, is_watertight and is_winding_consistent"
        MESH.without(Part::Prev).without(Part::Leaving).triangles();
    /// `compas.datastructures.Mesh`: an orientable surface with or without border, in which a dictionary has the face of each
    /// pair of vertices: there are no loops and no parallel edges.
    Compas "compas"
        from "compas, reference of datastructures.Mesh, is_manifold and is_valid"
        MESH.without(Part::Prev).without(Part::Leaving).simple();
    /// `networkx.PlanarEmbedding`: rotations of a simple graph, without faces, in the plane.
    Networkx "networkx"
        from "networkx, reference of PlanarEmbedding, check_structure"
        Expectation::plane().without(Part::Faces).without(Part::Prev).without(Part::Leaving).simple();
}

impl Preset {
    /// The preset of this name.
    #[must_use]
    pub fn from_name(name: &str) -> Option<Self> {
        Self::ALL.iter().copied().find(|preset| preset.name() == name)
    }
}
