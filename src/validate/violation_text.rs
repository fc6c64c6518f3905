//! Violations in words: a sentence each, that says what is wrong and why it matters.

use super::names::Names;
use super::record::{Field, Record};
use super::view::BoundaryPlace;
use super::violation::Violation;
use super::words::Number;
use core::fmt;

/// A boundary component in words: by its own record, or by the half-edge or vertex by which its face lists it.
struct BoundaryText<'a>(&'static str, Names<'a>, Record);

impl fmt::Display for BoundaryText<'_> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self(kind, names, record) = *self;
        match record {
            Record::Boundary(_) => write!(f, "the {kind} {}", names.record(record)),
            at => write!(f, "the {kind} boundary component at {}", names.record(at)),
        }
    }
}

/// A place in words.
struct PlaceText(Option<BoundaryPlace>);

impl fmt::Display for PlaceText {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self.0 {
            Some(BoundaryPlace::Outer) => f.write_str("the outer one"),
            Some(BoundaryPlace::Inner(i)) => write!(f, "inner position {i}"),
            None => f.write_str("no place"),
        }
    }
}

impl fmt::Display for Violation {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write(self, Names::INDICES, f)
    }
}

/// Writes the sentence, with the records named so.
#[allow(clippy::too_many_lines, reason = "one sentence per variant, together so that they read alike")]
pub(super) fn write(violation: &Violation, names: Names<'_>, f: &mut fmt::Formatter<'_>) -> fmt::Result {
    use Violation as V;
    match *violation {
        V::Nil { record, field } => {
            let record = names.record(record);
            write!(f, "the {field} of {record} is nil, but the record needs one")
        }
        // What a link to an unknown id becomes.
        V::Dangling { record, field, value: usize::MAX } => {
            let record = names.record(record);
            write!(f, "the {field} of {record} leads to no record at all: following it reads something else")
        }
        V::Dangling { record, field, value } => {
            let record = names.record(record);
            write!(f, "the {field} of {record} is {value}, which is no live record: following it reads something else")
        }
        V::TwinIsSelf { half_edge } => {
            let half_edge = names.half_edge(half_edge);
            write!(f, "half-edge {half_edge} is its own twin, so its edge has one side only")
        }
        V::TwinNotMutual { half_edge, twin, found } => {
            let half_edge = names.half_edge(half_edge);
            let twin = names.half_edge(twin);
            write!(
                f,
                "half-edge {half_edge} has twin {twin}, whose twin is {}: the two sides disagree about their edge",
                names.link(Record::HalfEdge, found)
            )
        }
        V::PrevOfNext { half_edge, next, found } => {
            let half_edge = names.half_edge(half_edge);
            let next = names.half_edge(next);
            let found = names.half_edge(found);
            write!(
                f,
                "half-edge {half_edge} has next {next}, whose prev is {found}: a walk back along the cycle leaves it"
            )
        }
        V::NextOfPrev { half_edge, prev, found } => {
            let half_edge = names.half_edge(half_edge);
            let prev = names.half_edge(prev);
            let found = names.half_edge(found);
            write!(f, "half-edge {half_edge} has prev {prev}, whose next is {found}: a walk along the cycle leaves it")
        }
        V::NextShared { first, second, next } => {
            let first = names.half_edge(first);
            let second = names.half_edge(second);
            let next = names.half_edge(next);
            write!(f, "half-edges {first} and {second} both have next {next}, so one of their cycles never closes")
        }
        V::Target { half_edge, next, target, found } => {
            let half_edge = names.half_edge(half_edge);
            let target = names.vertex(target);
            let next = names.half_edge(next);
            let found = names.vertex(found);
            write!(
                f,
                "half-edge {half_edge} ends at vertex {target}, but its next {next} starts at vertex {found}: the cycle jumps"
            )
        }
        V::NotLeaving { vertex, half_edge, origin } => {
            let vertex = names.vertex(vertex);
            let half_edge = names.half_edge(half_edge);
            let origin = names.vertex(origin);
            write!(
                f,
                "vertex {vertex} keeps half-edge {half_edge}, which leaves vertex {origin}: its rotation is that of another vertex"
            )
        }
        V::SplitRotation { vertex, half_edge, reached, degree } => {
            let half_edge = names.half_edge(half_edge);
            let vertex = names.vertex(vertex);
            write!(
                f,
                "from half-edge {half_edge} the rotation of vertex {vertex} reaches {reached} of the {degree} half-edges that \
                 leave it: several fans share the vertex, and no walk around it reaches them all"
            )
        }
        V::BoundaryChanges { half_edge, next, boundary, found } => {
            let half_edge = names.half_edge(half_edge);
            let next = names.half_edge(next);
            write!(
                f,
                "half-edge {half_edge} belongs to boundary component {}, its next {next} to {}: one cycle belongs to two boundary components",
                names.link(Record::Boundary, boundary),
                names.link(Record::Boundary, found)
            )
        }
        V::StartElsewhere { boundary, half_edge, found } => {
            let boundary = names.boundary(boundary);
            let half_edge = names.half_edge(half_edge);
            write!(
                f,
                "boundary component {boundary} starts at half-edge {half_edge}, which belongs to {}: a walk along it is a walk along another one",
                names.link(Record::Boundary, found)
            )
        }
        V::SecondCycle { boundary, cycle, half_edges } => {
            let boundary = names.boundary(boundary);
            write!(
                f,
                "boundary component {boundary} has {}, but the cycle of its start has {cycle}: the others lie on a cycle at which no \
                 boundary component starts",
                Number(half_edges as u64, "half-edge", "half-edges")
            )
        }
        V::FaceChanges { half_edge, next, face, found } => {
            let half_edge = names.half_edge(half_edge);
            let next = names.half_edge(next);
            write!(
                f,
                "half-edge {half_edge} bounds face {}, its next {next} bounds {}: the face changes along one cycle",
                names.link(Record::Face, face),
                names.link(Record::Face, found)
            )
        }
        V::ListedElsewhere { face, half_edge, found } => {
            let face = names.face(face);
            let half_edge = names.half_edge(half_edge);
            write!(
                f,
                "face {face} lists half-edge {half_edge}, which bounds face {}: a walk around the one is a walk around the other",
                names.link(Record::Face, found)
            )
        }
        V::IsolatedUnclaimed { vertex } => {
            let vertex = names.vertex(vertex);
            write!(
                f,
                "no half-edge leaves vertex {vertex} and no boundary component starts at it: no walk over the faces reaches it"
            )
        }
        V::IsolatedTwice { vertex, first, second } => {
            let first = names.record(first);
            let second = names.record(second);
            let vertex = names.vertex(vertex);
            write!(
                f,
                "{first} and {second} both start at isolated vertex {vertex}, so the vertex lies in two places at once"
            )
        }
        V::StartsAtConnected { record, vertex } => {
            let record = names.record(record);
            let vertex = names.vertex(vertex);
            write!(f, "{record} starts at vertex {vertex} as if it were isolated, but half-edges leave it")
        }
        V::IsolatedMismatch { vertex, boundary, found } => {
            let boundary = names.boundary(boundary);
            let vertex = names.vertex(vertex);
            write!(
                f,
                "boundary component {boundary} starts at isolated vertex {vertex}, which names {} instead: its face is not determined",
                names.link(Record::Boundary, found)
            )
        }
        V::ConnectedNamesBoundary { vertex, boundary } => {
            let vertex = names.vertex(vertex);
            let boundary = names.boundary(boundary);
            write!(
                f,
                "vertex {vertex} names boundary component {boundary} as if it were isolated, but half-edges leave it"
            )
        }
        V::NoUnboundedFace => {
            f.write_str("every face has an outer boundary component, but one face of a plane is unbounded and has none")
        }
        V::SecondUnboundedFace { first, second } => {
            let first = names.face(first);
            let second = names.face(second);
            write!(
                f,
                "faces {first} and {second} both have no outer boundary component, but only one face of a plane is unbounded"
            )
        }
        V::NoOuter { face } => {
            let face = names.face(face);
            write!(
                f,
                "face {face} has no outer boundary component, but every face of this structure needs one: `outer` (or, without \
                     boundary component records, `outer_half_edge`) is nil"
            )
        }
        V::OuterIsVertex { face, boundary } => {
            let boundary = names.boundary(boundary);
            let face = names.face(face);
            write!(
                f,
                "the outer boundary component {boundary} of face {face} is an isolated vertex, which encloses nothing"
            )
        }
        V::NotListed { boundary, face } => {
            let boundary = names.boundary(boundary);
            write!(
                f,
                "boundary component {boundary} names face {}, but no face lists it: a walk over the faces never reaches it",
                names.link(Record::Face, face)
            )
        }
        V::CycleNotListed { half_edge } => {
            let half_edge = names.half_edge(half_edge);
            write!(f, "no face lists the cycle of half-edge {half_edge}: a walk over the faces never reaches it")
        }
        V::ListedTwice { record, face } => {
            let face = names.face(face);
            let record = names.record(record);
            write!(f, "face {face} lists {record}, which was listed before: a walk over the faces reaches it twice")
        }
        V::ListedByOther { boundary, face, found } => {
            let face = names.face(face);
            let boundary = names.boundary(boundary);
            write!(
                f,
                "face {face} lists boundary component {boundary}, which names face {}: the two directions disagree",
                names.link(Record::Face, found)
            )
        }
        V::WrongPlace { boundary, place, listed } => {
            let boundary = names.boundary(boundary);
            write!(
                f,
                "boundary component {boundary} says that it is {}, but its face lists it as {}: to remove it would remove another one",
                PlaceText(place),
                PlaceText(Some(listed))
            )
        }
        V::ListTooLong { face, claimed } => {
            let face = names.face(face);
            write!(
                f,
                "face {face} claims {claimed} inner boundary components, far more than there can be: the lists were not read to the end"
            )
        }
        V::NoOutside { vertex } => {
            let vertex = names.vertex(vertex);
            write!(
                f,
                "the component of vertex {vertex} has only outer boundary components, so it lies in no face at all"
            )
        }
        V::TwoOutsides { vertex, first, second } => {
            let vertex = names.vertex(vertex);
            let first = names.record(first);
            let second = names.record(second);
            write!(
                f,
                "the component of vertex {vertex} has two inner boundary components, at {first} and at {second}: it would lie \
                 in two faces at once"
            )
        }
        V::NestedInItself { vertex, face } => {
            let vertex = names.vertex(vertex);
            let face = names.face(face);
            write!(
                f,
                "the component of vertex {vertex} lies in face {face}, which lies, through others, inside that component: \
                 no path leads from it out to the unbounded face"
            )
        }
        V::Genus { vertex, vertices, edges, cycles, genus } => {
            let vertex = names.vertex(vertex);
            write!(
                f,
                "the component of vertex {vertex} has V − E + cycles = {vertices} − {edges} + {cycles}, genus {genus}: it can \
                 only be drawn on a surface with {}, not in the plane",
                Number(genus as u64, "handle", "handles")
            )
        }
        V::NoSuchSurface { vertex, vertices, edges, cycles } => {
            let vertex = names.vertex(vertex);
            write!(
                f,
                "the component of vertex {vertex} has V − E + cycles = {vertices} − {edges} + {cycles}, which no orientable \
                 surface has"
            )
        }
        V::TooManyEdges { vertices, edges } => write!(
            f,
            "the map is simple and has {edges} edges on {vertices} vertices, more than 3V − 6 = {}: it is not planar",
            vertices.saturating_mul(3).saturating_sub(6)
        ),
        V::TooManyFaces { vertices, faces } => write!(
            f,
            "the map is simple and has {faces} faces on {vertices} vertices, more than 2V − 4 = {}: some face has no boundary of its own",
            vertices.saturating_mul(2).saturating_sub(4)
        ),
        V::UnusedVertex { vertex } => {
            let vertex = names.vertex(vertex);
            write!(f, "no half-edge leaves vertex {vertex}: no edge and no face uses it")
        }
        V::LoopEdge { half_edge, vertex } => {
            let (half_edge, vertex) = (names.half_edge(half_edge), names.vertex(vertex));
            write!(f, "half-edge {half_edge} starts and ends at vertex {vertex}: its edge is a loop")
        }
        V::ParallelEdges { first, second, vertices: [u, v] } => {
            let (first, second) = (names.half_edge(first), names.half_edge(second));
            let (u, v) = (names.vertex(u), names.vertex(v));
            write!(
                f,
                "half-edges {first} and {second} belong to two edges that both join vertices {u} and {v}: the ends do not tell \
                 which edge is meant"
            )
        }
        V::WrongSides { record: Record::HalfEdge(h), sides, expected } => {
            let h = names.half_edge(h);
            let sides = Number(sides as u64, "side", "sides");
            write!(f, "the cycle of half-edge {h} has {sides}, where {expected} are expected")
        }
        V::WrongSides { record, sides, expected } => {
            let record = names.record(record);
            let sides = Number(sides as u64, "side", "sides");
            write!(f, "{record} has {sides}, where {expected} are expected")
        }
        V::OnBorder { half_edge, vertices: [u, v], lacks } => {
            let (half_edge, u, v) = (names.half_edge(half_edge), names.vertex(u), names.vertex(v));
            let lack = if lacks == Field::Twin { "has no twin" } else { "bounds no face" };
            write!(f, "half-edge {half_edge}, from vertex {u} to vertex {v}, {lack}: the surface has a border there")
        }
        V::WrongComponents { found, expected } => {
            let found = Number(found as u64, "component", "components");
            write!(f, "the structure has {found} with an edge, where {expected} are expected")
        }
        V::WrongBorders { found, expected } => {
            let found = Number(found as u64, "border loop", "border loops");
            write!(f, "the structure has {found}, where {expected} are expected")
        }
        V::WrongGenus { found, expected } => {
            write!(f, "the components have genus {found} together, where {expected} is expected")
        }
        V::KeptInside { vertex, half_edge, border } => {
            let (vertex, kept, border) = (names.vertex(vertex), names.half_edge(half_edge), names.half_edge(border));
            write!(
                f,
                "vertex {vertex} keeps half-edge {kept}, which is not on the border, where half-edge {border} leaves it along \
                 the border"
            )
        }
        V::NotFinite { vertex } => {
            let vertex = names.vertex(vertex);
            write!(f, "vertex {vertex} has a coordinate that is not finite, or out of range")
        }
        V::ZeroLength { half_edge } => {
            let half_edge = names.half_edge(half_edge);
            write!(f, "half-edge {half_edge} starts and ends at the same point: it has no direction")
        }
        V::BendNotFinite { half_edge, bend } => {
            let half_edge = names.half_edge(half_edge);
            write!(f, "bend {bend} of half-edge {half_edge} has a coordinate that is not finite, or out of range")
        }
        V::SegmentZeroLength { half_edge, segment } => {
            let half_edge = names.half_edge(half_edge);
            write!(
                f,
                "segment {segment} of half-edge {half_edge} starts and ends at the same point: it has no direction"
            )
        }
        V::OutOfOrder { vertex, half_edge, found } => {
            let vertex = names.vertex(vertex);
            let found = names.half_edge(found);
            let half_edge = names.half_edge(half_edge);
            write!(
                f,
                "at vertex {vertex}, half-edge {found} follows half-edge {half_edge} in the rotation, but another lies between: \
                 the coordinates and the links disagree"
            )
        }
        V::OuterClockwise { boundary } => {
            write!(f, "{} turns clockwise, so its face would lie outside it", BoundaryText("outer", names, boundary))
        }
        V::InnerCounterClockwise { boundary } => {
            write!(
                f,
                "{} turns counter-clockwise, so its face would lie inside it",
                BoundaryText("inner", names, boundary)
            )
        }
        V::Cross { first, second } => {
            let first = names.half_edge(first);
            let second = names.half_edge(second);
            write!(f, "half-edges {first} and {second} cross where no vertex is: the map is not plane")
        }
        V::Touch { vertex, half_edge } => {
            let vertex = names.vertex(vertex);
            let half_edge = names.half_edge(half_edge);
            write!(f, "vertex {vertex} lies inside half-edge {half_edge}, which does not end there")
        }
        V::Overlap { first, second } => {
            let first = names.half_edge(first);
            let second = names.half_edge(second);
            write!(f, "half-edges {first} and {second} overlap: they have more than a point in common")
        }
        V::SamePlace { first, second } => {
            let first = names.vertex(first);
            let second = names.vertex(second);
            write!(f, "vertices {first} and {second} lie at the same point but are not joined")
        }
        V::SegmentsCross { first, first_segment, second, second_segment } => {
            let first = names.half_edge(first);
            let second = names.half_edge(second);
            write!(
                f,
                "segment {first_segment} of half-edge {first} and segment {second_segment} of half-edge {second} cross where no \
                 vertex is: the map is not plane"
            )
        }
        V::VertexInSegment { vertex, half_edge, segment } => {
            let vertex = names.vertex(vertex);
            let half_edge = names.half_edge(half_edge);
            write!(
                f,
                "vertex {vertex} lies inside segment {segment} of half-edge {half_edge}, which does not end there"
            )
        }
        V::BendInSegment { half_edge, bend, other, segment } => {
            let half_edge = names.half_edge(half_edge);
            let other = names.half_edge(other);
            write!(f, "bend {bend} of half-edge {half_edge} lies inside segment {segment} of half-edge {other}")
        }
        V::SegmentsOverlap { first, first_segment, second, second_segment } => {
            let first = names.half_edge(first);
            let second = names.half_edge(second);
            write!(
                f,
                "segment {first_segment} of half-edge {first} and segment {second_segment} of half-edge {second} overlap: they have \
                 more than a point in common"
            )
        }
        V::BendAtVertex { half_edge, bend, vertex } => {
            let half_edge = names.half_edge(half_edge);
            let vertex = names.vertex(vertex);
            write!(f, "bend {bend} of half-edge {half_edge} lies at vertex {vertex}, where the half-edge does not end")
        }
        V::BendsAtSamePlace { first, first_bend, second, second_bend } => {
            let first = names.half_edge(first);
            let second = names.half_edge(second);
            write!(
                f,
                "bend {first_bend} of half-edge {first} and bend {second_bend} of half-edge {second} lie at the same point, where \
                 no vertex is"
            )
        }
        V::WrongFace { boundary, face, found } => {
            let face = names.face(face);
            write!(f, "{} is listed by face {face}, but lies in ", BoundaryText("inner", names, boundary))?;
            match found {
                Some(found) => write!(f, "face {}", names.face(found)),
                None => f.write_str("no face"),
            }
        }
        V::Unlisted { vertex, face } => {
            let vertex = names.vertex(vertex);
            let face = names.face(face);
            write!(f, "the component of vertex {vertex} lies in face {face}, which does not list it")
        }
    }
}
