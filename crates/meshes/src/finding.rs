//! The faults of a list of faces, in the terms of its author.

use super::space_rule::SpaceRule;
use std::fmt;
use twinedge::validate::Collect;
use twinedge_diagnosis::{Diagnosis, Records};

macro_rules! kinds {
    ($($variant:ident $name:literal $statement:literal cause $cause:literal remedy $remedy:literal;)*) => {
        /// A kind of finding. The names are stable.
        #[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
        #[non_exhaustive]
        pub enum Kind {
            $(#[doc = concat!("`", $name, "`: ", $statement)] $variant,)*
        }

        impl Kind {
            /// All kinds, in the order in which findings are listed.
            pub const ALL: &[Self] = &[$(Self::$variant),*];

            /// Returns the name: `degenerate_face` and so on.
            #[must_use]
            pub const fn name(self) -> &'static str {
                match self { $(Self::$variant => $name,)* }
            }

            /// Returns the kind in one sentence.
            #[must_use]
            pub const fn statement(self) -> &'static str {
                match self { $(Self::$variant => $statement,)* }
            }

            /// Returns the usual cause.
            #[must_use]
            pub const fn cause(self) -> &'static str {
                match self { $(Self::$variant => $cause,)* }
            }

            /// Returns the remedy.
            ///
            /// ```
            /// use twinedge_meshes::Kind;
            /// assert!(Kind::FlippedFaces.remedy().starts_with("reverse the vertices of one of the two faces"));
            /// ```
            #[must_use]
            pub const fn remedy(self) -> &'static str {
                match self { $(Self::$variant => $remedy,)* }
            }
        }
    };
}

kinds! {
    NoFaces "no_faces" "there are no faces"
        cause "the file holds points or lines only, or the faces were not exported"
        remedy "export the faces, too; points alone are no mesh";
    DegenerateFace "degenerate_face" "a face has fewer than three different vertices"
        cause "vertices were merged, and the faces that shrank to an edge or a point were kept"
        remedy "delete the face";
    RepeatedVertex "repeated_vertex" "a face with three or more different vertices lists one of them again"
        cause "a face with a hole was written as one polygon with a slit, or vertices were merged"
        remedy "cut the face into faces that pass each vertex once";
    RepeatedFace "repeated_face" "a face has the vertices of an earlier one, in the same order or the opposite one"
        cause "the same part was exported twice, or a sheet was given two sides"
        remedy "delete one of the two faces, or give the sheet a thickness";
    NonManifoldEdge "non_manifold_edge" "an edge has three or more faces"
        cause "bodies that touch along an edge were merged, or an inner wall was kept"
        remedy "delete the inner faces, or give each body vertices of its own along the edge";
    FlippedFaces "flipped_faces" "the two faces at an edge run along it in the same direction"
        cause "faces come from sources that wind them differently, or part of the mesh was mirrored"
        remedy "reverse the vertices of one of the two faces, or have the program that made the mesh orient all of it; a Möbius strip cannot be mended so";
    NonManifoldVertex "non_manifold_vertex" "several fans of faces meet at a vertex and share no edge there"
        cause "bodies that touch at a point were merged, or faces between the fans are missing"
        remedy "give each fan a vertex of its own, or add the missing faces";
    UnusedVertex "unused_vertex" "no face uses the vertex"
        cause "faces were deleted and their vertices kept, or the vertex belongs to a line or a point of the file"
        remedy "delete the vertex, or pass over it: it is a fault only where none is expected";
    ZeroArea "zero_area" "the corners of a face all lie on one line (M9)"
        cause "vertices were merged or moved onto an edge, or coordinates were rounded"
        remedy "delete the face and let those beside it meet along its longest side, or flip that side";
    CrossingFaces "crossing_faces" "two faces meet elsewhere than in common corners and edges (M10)"
        cause "bodies overlap and were not united, or a surface was offset, smoothed or simplified so far that it folds"
        remedy "unite the bodies (a boolean operation), or undo what folded the surface there";
    InsideOut "inside_out" "the faces of a closed component face inwards, and it is no cavity of another one (M11)"
        cause "the file or a program winds faces the other way round, or the component was mirrored"
        remedy "reverse the vertices of all its faces";
}

impl Kind {
    /// Returns the kind of the findings of a rule about the coordinates of points.
    #[must_use]
    pub const fn of(rule: SpaceRule) -> Self {
        match rule {
            SpaceRule::Area => Self::ZeroArea,
            SpaceRule::Crossing => Self::CrossingFaces,
            SpaceRule::Outward => Self::InsideOut,
        }
    }

    /// Returns the optional rule that findings of this kind break.
    #[must_use]
    pub fn rule(self) -> Option<SpaceRule> {
        SpaceRule::ALL.into_iter().find(|rule| Self::of(*rule) == self)
    }

    /// Returns true if it is a fault in any mesh. Unused vertices are a fault only if the expectation excludes them.
    #[must_use]
    pub const fn is_fault(self) -> bool {
        !matches!(self, Self::UnusedVertex)
    }
}

impl fmt::Display for Kind {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(self.name())
    }
}

/// A fault, with its faces and vertices. `Display` states it in a sentence.
#[derive(Clone, Debug, PartialEq, Eq, Hash)]
#[non_exhaustive]
pub enum Finding {
    /// There are no faces.
    NoFaces,
    /// A face has fewer than three different vertices. It is left out.
    DegenerateFace {
        /// The face.
        face: usize,
        /// Its distinct vertices, none to two, in the order of the face.
        vertices: Vec<usize>,
    },
    /// A face lists a vertex again. It is left out.
    RepeatedVertex {
        /// The face.
        face: usize,
        /// The first repeated vertex.
        vertex: usize,
    },
    /// A face has the vertices of an earlier one. It is left out.
    RepeatedFace {
        /// The face.
        face: usize,
        /// The first face with these vertices.
        first: usize,
        /// True if it lists them in the opposite order, so that the two are back to back.
        reversed: bool,
        /// The vertices, as the face lists them.
        vertices: Vec<usize>,
    },
    /// An edge has three or more faces. They are not joined there.
    NonManifoldEdge {
        /// The ends of the edge, the smaller first.
        vertices: [usize; 2],
        /// All of its faces.
        faces: Vec<usize>,
    },
    /// The two faces at an edge run along it in the same direction: one of them is flipped. They are not joined there.
    FlippedFaces {
        /// The ends of the edge, in the order in which both faces list them.
        vertices: [usize; 2],
        /// The faces.
        faces: [usize; 2],
    },
    /// Several fans of faces meet at a vertex.
    NonManifoldVertex {
        /// The vertex.
        vertex: usize,
        /// The first face of each fan.
        faces: Vec<usize>,
    },
    /// No face uses the vertex, ignoring faces that are left out.
    UnusedVertex {
        /// The vertex.
        vertex: usize,
    },
    /// All corners of a face lie on one line.
    ZeroArea {
        /// The face.
        face: usize,
    },
    /// Two faces meet elsewhere than in common corners and edges.
    CrossingFaces {
        /// The faces, the smaller number first.
        faces: [usize; 2],
    },
    /// The faces of a closed component face inwards.
    InsideOut {
        /// The first face of the component.
        face: usize,
        /// The number of its faces.
        faces: usize,
    },
}

impl Finding {
    /// Its kind.
    #[must_use]
    pub const fn kind(&self) -> Kind {
        match self {
            Self::NoFaces => Kind::NoFaces,
            Self::DegenerateFace { .. } => Kind::DegenerateFace,
            Self::RepeatedVertex { .. } => Kind::RepeatedVertex,
            Self::RepeatedFace { .. } => Kind::RepeatedFace,
            Self::NonManifoldEdge { .. } => Kind::NonManifoldEdge,
            Self::FlippedFaces { .. } => Kind::FlippedFaces,
            Self::NonManifoldVertex { .. } => Kind::NonManifoldVertex,
            Self::UnusedVertex { .. } => Kind::UnusedVertex,
            Self::ZeroArea { .. } => Kind::ZeroArea,
            Self::CrossingFaces { .. } => Kind::CrossingFaces,
            Self::InsideOut { .. } => Kind::InsideOut,
        }
    }

    /// Returns the faces involved, the faulty one first, if there is one.
    #[must_use]
    pub fn faces(&self) -> Vec<usize> {
        match self {
            Self::DegenerateFace { face, .. }
            | Self::RepeatedVertex { face, .. }
            | Self::ZeroArea { face }
            | Self::InsideOut { face, .. } => vec![*face],
            Self::RepeatedFace { face, first, .. } => vec![*face, *first],
            Self::NonManifoldEdge { faces, .. } | Self::NonManifoldVertex { faces, .. } => faces.clone(),
            Self::FlippedFaces { faces, .. } | Self::CrossingFaces { faces } => faces.to_vec(),
            Self::NoFaces | Self::UnusedVertex { .. } => Vec::new(),
        }
    }

    /// Returns the vertices involved.
    #[must_use]
    pub fn vertices(&self) -> Vec<usize> {
        match self {
            Self::DegenerateFace { vertices, .. } | Self::RepeatedFace { vertices, .. } => vertices.clone(),
            Self::RepeatedVertex { vertex, .. }
            | Self::NonManifoldVertex { vertex, .. }
            | Self::UnusedVertex { vertex } => vec![*vertex],
            Self::NonManifoldEdge { vertices, .. } | Self::FlippedFaces { vertices, .. } => vertices.to_vec(),
            Self::NoFaces | Self::ZeroArea { .. } | Self::CrossingFaces { .. } | Self::InsideOut { .. } => Vec::new(),
        }
    }

    /// Returns the sentence with faces and vertices counted from this number: see
    /// [`Format::first_number`](super::Format::first_number).
    ///
    /// ```
    /// use twinedge_meshes::Finding;
    /// let finding = Finding::UnusedVertex { vertex: 6 };
    /// assert_eq!(finding.to_string(), "no face uses vertex 6");
    /// assert_eq!(finding.counted_from(1).to_string(), "no face uses vertex 7");
    /// ```
    #[must_use]
    pub const fn counted_from(&self, first: usize) -> impl fmt::Display + '_ {
        Counted { finding: self, first }
    }
}

/// A finding with its faces and vertices counted from a number.
struct Counted<'a> {
    finding: &'a Finding,
    first: usize,
}

/// The first few of these numbers, each increased by an offset.
struct Row<'a>(&'a [usize], usize);

impl fmt::Display for Row<'_> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        const SHOWN: usize = 8;
        for (i, number) in self.0.iter().take(SHOWN).enumerate() {
            write!(f, "{}{}", if i == 0 { "" } else { ", " }, number + self.1)?;
        }
        match self.0.len().saturating_sub(SHOWN) {
            0 => Ok(()),
            more => write!(f, " and {more} more"),
        }
    }
}

impl fmt::Display for Finding {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        self.counted_from(0).fmt(f)
    }
}

impl fmt::Display for Counted<'_> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let n = |number: &usize| number + self.first;
        let row = |numbers| Row(numbers, self.first);
        match self.finding {
            Finding::NoFaces => f.write_str("there are no faces, so there is no surface"),
            Finding::DegenerateFace { face, vertices } => match vertices[..] {
                [] => write!(f, "face {} has no vertices: it is left out", n(face)),
                [_] => write!(f, "face {} has one vertex only, {}: it is left out", n(face), row(vertices)),
                _ => write!(f, "face {} has two different vertices only, {}: it is left out", n(face), row(vertices)),
            },
            Finding::RepeatedVertex { face, vertex } => {
                write!(f, "face {} passes vertex {} more than once: it is left out", n(face), n(vertex))
            }
            Finding::RepeatedFace { face, first, reversed, vertices } => {
                let how = if *reversed { "in the opposite order" } else { "in the same order" };
                let (face, first, vertices) = (n(face), n(first), row(vertices));
                write!(f, "face {face} has the vertices of face {first}, {how} ({vertices}): it is left out")
            }
            Finding::NonManifoldEdge { vertices: [a, b], faces } => {
                let (a, b, count) = (n(a), n(b), faces.len());
                write!(f, "the edge between vertices {a} and {b} has {count} faces: {}", row(faces))
            }
            Finding::FlippedFaces { vertices, faces } => {
                let ([a, b], [first, second]) = (vertices.each_ref().map(n), faces.each_ref().map(n));
                write!(f, "faces {first} and {second} both run from vertex {a} to vertex {b}: one of them is flipped")
            }
            Finding::NonManifoldVertex { vertex, faces } => write!(
                f,
                "{} fans of faces meet at vertex {} and share no edge there; one face of each: {}",
                faces.len(),
                n(vertex),
                row(faces)
            ),
            Finding::UnusedVertex { vertex } => write!(f, "no face uses vertex {}", n(vertex)),
            Finding::ZeroArea { face } => write!(f, "the corners of face {} lie on one line: it has no area", n(face)),
            Finding::CrossingFaces { faces } => {
                let [first, second] = faces.each_ref().map(n);
                write!(f, "faces {first} and {second} meet elsewhere than in common corners and edges")
            }
            Finding::InsideOut { face, faces } => {
                let (face, s) = (n(face), if *faces == 1 { "" } else { "s" });
                write!(f, "the closed component of face {face}, of {faces} face{s}, faces inwards")
            }
        }
    }
}

impl From<&Finding> for Diagnosis {
    fn from(finding: &Finding) -> Self {
        let kind = finding.kind();
        Self {
            rule: kind.rule().map(SpaceRule::id),
            kind: twinedge_diagnosis::Kind::Named { kind: kind.name() },
            message: finding.to_string(),
            cause: Some(kind.cause()),
            remedy: Some(kind.remedy()),
            records: Records::OfMesh { faces: finding.faces(), vertices: finding.vertices() },
            is_violation: kind.is_fault(),
            ..Self::default()
        }
    }
}

/// The findings in a list of faces: the number of each kind, and the first of each kind.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Findings {
    kept: Vec<Finding>,
    counts: [usize; Kind::ALL.len()],
    most: usize,
}

impl Findings {
    pub(super) fn new(collect: Collect) -> Self {
        let most = match collect {
            Collect::First => 1,
            Collect::All => Collect::DEFAULT_CAP,
            Collect::AtMost(most) => most,
        };
        Self { kept: Vec::new(), counts: [0; Kind::ALL.len()], most }
    }

    /// Counts a finding, and makes and keeps it if there is room.
    pub(super) fn add(&mut self, kind: Kind, finding: impl FnOnce() -> Finding) {
        let count = &mut self.counts[kind as usize];
        *count += 1;
        if *count <= self.most {
            self.kept.push(finding());
        }
    }

    pub(super) fn sort(&mut self) {
        self.kept.sort_by_key(Finding::kind);
    }

    /// Returns the kept findings, by kind, and then by face, by the smaller vertex of the edge, or by vertex.
    #[must_use]
    pub fn list(&self) -> &[Finding] {
        &self.kept
    }

    /// Returns the number of findings of this kind, kept or not.
    #[must_use]
    pub const fn count(&self, kind: Kind) -> usize {
        self.counts[kind as usize]
    }

    /// Returns the number of findings, kept or not.
    #[must_use]
    pub fn total(&self) -> usize {
        self.counts.iter().sum()
    }

    /// Returns true if no finding is a fault in any mesh.
    #[must_use]
    pub fn is_faultless(&self) -> bool {
        Kind::ALL.iter().all(|kind| !kind.is_fault() || self.count(*kind) == 0)
    }
}
