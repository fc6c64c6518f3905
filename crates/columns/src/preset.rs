//! The promises of known libraries about their structures.

use twinedge::validate::Expectation;

macro_rules! presets {
    ($($(#[doc = $doc:literal])* $variant:ident $name:literal from $source:literal $expectation:expr;)*) => {
        /// The expectation for the structures of a library, according to its documentation. Add any further properties of a
        /// single structure (closed, of some genus).
        ///
        /// ```
        /// use twinedge::validate::Rule;
        /// use twinedge_columns::Preset;
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

            /// Returns the name, in snake case.
            #[must_use]
            pub const fn name(self) -> &'static str {
                match self { $(Self::$variant => $name,)* }
            }

            /// Returns the documentation behind it.
            #[must_use]
            pub const fn source(self) -> &'static str {
                match self { $(Self::$variant => $source,)* }
            }

            /// Returns the expectation.
            #[must_use]
            pub const fn expectation(self) -> Expectation {
                match self { $(Self::$variant => $expectation,)* }
            }
        }
    };
}

/// A surface with or without border.
const MESH: Expectation = Expectation::surface().open();

presets! {
    /// `CGAL::Surface_mesh`. The manual: each edge is two half-edges; a half-edge keeps a face, a vertex, the next and the
    /// previous one; a vertex and a face keep one; a half-edge without face is on the border, where `next` and `prev` follow it.
    ///
    /// A half-edge keeps its target, and a vertex one that *arrives*: answer `leaving` with its next, which is on the border if
    /// the vertex's half-edge is. The documentation is ambiguous about the half-edge of a border vertex: `halfedge(v)`
    /// "will be a border halfedge", and "the user is in charge" of that (section Borders). Add
    /// [`border_kept`](Expectation::border_kept) to check it.
    SurfaceMesh "surface_mesh"
        from "CGAL, user manual of Surface_mesh, sections Connectivity and Borders, and CGAL/Surface_mesh/Surface_mesh.h, halfedge(Vertex_index)"
        MESH;
    /// `OpenMesh`, `PolyMesh` and `TriMesh`. The manual: a vertex keeps a half-edge that leaves it, a face a half-edge that bounds it, and a
    /// half-edge its target, face, next, opposite and, optionally, its previous one.
    ///
    /// "The outgoing halfedge" of a boundary vertex "must be a boundary halfedge" (M8): `is_boundary` of a vertex relies on it,
    /// and `adjust_outgoing_halfedge` restores it. For a mesh of triangles, add [`triangles`](Expectation::triangles).
    OpenMesh "openmesh"
        from "OpenMesh, The Halfedge Data Structure, and OpenMesh/Core/Mesh/PolyConnectivity.hh, is_boundary and adjust_outgoing_halfedge"
        MESH.border_kept();
    /// `CGAL::Arrangement_2` of bounded curves, in the plane. The manual: a half-edge has its face to its left; the half-edges
    /// around a face form chains (CCBs); a face has at most one outer one, the one unbounded face none, and any number of inner
    /// ones and isolated vertices.
    ///
    /// A half-edge keeps its target, and a vertex one that arrives: answer `leaving` with its twin. Records of CCBs and isolated
    /// vertices keep an iterator into their face's list, which is no position, so there are no
    /// [`places`](twinedge::validate::Part::Places). Unbounded curves, with several unbounded faces and a fictitious one, are
    /// excluded.
    Arrangement2 "arrangement_2"
        from "CGAL, user manual of 2D Arrangements, section Representation of Arrangements: The Dcel, and CGAL/Arr_dcel_base.h"
        Expectation::plane();
    /// `trimesh.Trimesh`. It promises that faces are triples of vertices, and keeps no half-edges: its corners are half-edges
    /// here, and an edge of only one triangle is a border.
    ///
    /// The rest are queries: this preset checks the same as `is_winding_consistent` ("each shared edge going in an opposite
    /// direction from the other in the pair"), and that no edge has three triangles, and that no two fans share a vertex;
    /// [`closed`](Expectation::closed) adds the check of `is_watertight` ("every edge is included in two faces").
    Trimesh "trimesh"
        from "trimesh, reference of Trimesh, faces, is_winding_consistent and is_watertight"
        MESH.triangles();
    /// `compas.datastructures.Mesh`, "open or closed surface meshes". A dictionary has the face of each pair of vertices, or
    /// `None` along a border, so there are no parallel edges; `add_face` drops a vertex that follows itself, so no loops.
    ///
    /// This equals `is_valid` (half-edges have their faces and vertices, faces their half-edges, no edge has none) and
    /// `is_manifold` ("the faces incident to a vertex form a closed or an open fan"), except that the latter is also false for a
    /// vertex without face: add [`no_unused_vertices`](Expectation::no_unused_vertices) for that.
    Compas "compas"
        from "compas, reference of datastructures.Mesh, is_valid, is_manifold and add_face"
        MESH.simple();
    /// `networkx.PlanarEmbedding`: rotations in the plane, without faces. "Edges must go in both directions", and each "must have
    /// a 'cw' and 'ccw' attribute which corresponds to a correct planar embedding". The graph is a `DiGraph`: it has no parallel
    /// edges, and a loop would be its own twin.
    ///
    /// Answer `next` of `(u, v)` with `(v, w)`, where `w` is the `ccw` of `(v, u)`, and `prev` with `(w, u)`, where `w` is the
    /// `cw` of `(u, v)`. The two attributes are then checked against each other.
    Networkx "networkx"
        from "networkx, reference of PlanarEmbedding, and check_structure"
        Expectation::plane().simple();
}

impl Preset {
    /// Returns the preset of this name.
    #[must_use]
    pub fn from_name(name: &str) -> Option<Self> {
        Self::ALL.iter().copied().find(|preset| preset.name() == name)
    }
}
