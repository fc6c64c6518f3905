//! Each rule as one function: its sentence in sets and quantifiers.

use super::structure::{Entry, Says, Structure, orbit};
use crate::validate::expectation::{Expectation, Surface};
use crate::validate::rule::Rule;
use crate::validate::structure::{Link, Part, Start, View};
use alloc::collections::BTreeSet;
use alloc::vec::Vec;

/// Returns every broken rule, in order; none for a valid structure.
///
/// Cost: O(n³) and more.
///
/// ```
/// use twinedge::validate::{Expectation, FaceRow, Rule, Table, reference::broken_rules};
/// // The empty map is one unbounded face. Two of them are one too many.
/// let mut table = Table { faces: vec![Some(FaceRow::default())], ..Table::default() };
/// assert_eq!(broken_rules(&table, &Expectation::plane()), []);
/// table.faces.push(Some(FaceRow::default()));
/// assert_eq!(broken_rules(&table, &Expectation::plane()), [Rule::F1]);
/// ```
pub fn broken_rules(view: &dyn View, expectation: &Expectation) -> Vec<Rule> {
    let s = Structure::new(view, *expectation);
    rules().into_iter().filter(|(_, holds)| !holds(&s)).map(|(rule, _)| rule).collect()
}

/// Returns only the first broken rule, which takes less time.
///
/// Cost: O(n³) and more.
///
/// ```
/// use twinedge::validate::{Expectation, Rule, Table, reference::first_broken_rule};
/// // A loop that is its own twin.
/// let table: Table = "V 1 0 - H 1 0 0 0 0 0 B 1 0 h0 i0 F 1 - 1 0".parse()?;
/// assert_eq!(first_broken_rule(&table, &Expectation::plane()), Some(Rule::L1));
/// # Ok::<(), twinedge::validate::ParseTableError>(())
/// ```
pub fn first_broken_rule(view: &dyn View, expectation: &Expectation) -> Option<Rule> {
    first_broken_of(view, expectation, Rule::ALL)
}

/// Returns the first broken rule among `rules`, in their order. Rules about coordinates are skipped.
///
/// Rules after a broken one are not evaluated, so the order determines which parts of the structure are read.
///
/// Cost: O(n³) and more.
///
/// ```
/// use twinedge::validate::{Expectation, Rule, Table, reference::first_broken_of};
/// // A loop that is its own twin and its own face.
/// let table: Table = "V 1 0 - H 1 0 0 0 0 0 B 1 0 h0 i0 F 1 - 1 0".parse()?;
/// assert_eq!(first_broken_of(&table, &Expectation::plane(), &[Rule::L2, Rule::T3, Rule::L1]), Some(Rule::T3));
/// # Ok::<(), twinedge::validate::ParseTableError>(())
/// ```
pub fn first_broken_of(view: &dyn View, expectation: &Expectation, order: &[Rule]) -> Option<Rule> {
    let s = Structure::new(view, *expectation);
    let statements = rules();
    let is_broken = |rule: &Rule| statements.iter().any(|(stated, holds)| stated == rule && !holds(&s));
    order.iter().copied().find(is_broken)
}

/// A rule, and the function that decides whether it holds.
type Statement<'a> = (Rule, fn(&Structure<'a>) -> bool);

fn rules<'a>() -> [Statement<'a>; 22] {
    [
        (Rule::R1, r1),
        (Rule::L1, l1),
        (Rule::L2, l2),
        (Rule::L3, l3),
        (Rule::V1, v1),
        (Rule::V2, v2),
        (Rule::B1, b1),
        (Rule::B2, b2),
        (Rule::F1, f1),
        (Rule::F2, f2),
        (Rule::T1, t1),
        (Rule::T2, t2),
        (Rule::T3, t3),
        (Rule::T4, t4),
        (Rule::M1, m1),
        (Rule::M2, m2),
        (Rule::M3, m3),
        (Rule::M4, m4),
        (Rule::M5, m5),
        (Rule::M6, m6),
        (Rule::M7, m7),
        (Rule::M8, m8),
    ]
}

/// R1 live: every link that a record needs is there and leads to a live record, and no face lists far more boundary components than there are.
///
/// At an open boundary twin or face may be nil, but not both. A vertex needs a leaving half-edge only if some half-edge leaves it.
///
/// The rule is also broken if all lists together have more inner boundary components than twice the number of boundary components
/// plus 16: the fast validator stops reading there. Without records for boundary components, vertices and half-edges count.
fn r1(s: &Structure<'_>) -> bool {
    let vertex = |link| s.vertices.contains(&link);
    let half_edge = |link| s.half_edges.contains(&link);
    let boundary = |link| s.boundaries.contains(&link);
    let face = |link| s.faces.contains(&link);
    let nil = |link: Link| link.is_none();
    let start = |start| match start {
        Some(Start::HalfEdge(h)) => half_edge(Some(h)),
        Some(Start::Vertex(v)) => vertex(Some(v)),
        None => false,
    };
    s.half_edges.iter().all(|&h| {
        let other_side_only = s.open && !nil(s.twin(h));
        vertex(s.origin(h))
            && (half_edge(s.twin(h)) || s.open && nil(s.twin(h)))
            && half_edge(s.next(h))
            && (s.lacks(Part::Prev) || half_edge(s.prev(h)))
            && match s.says {
                Says::Nothing => true,
                Says::Boundary => boundary(s.boundary(h)) || other_side_only && nil(s.boundary(h)),
                Says::Face => face(s.face(h)) || other_side_only && nil(s.face(h)),
            }
    }) && s.vertices.iter().all(|&v| {
        (s.lacks(Part::Leaving) || half_edge(s.leaving(v)) || nil(s.leaving(v)) && s.all_leaving(v).is_empty())
            && (s.lacks(Part::Holes) || boundary(s.isolated(v)) || nil(s.isolated(v)))
    }) && s.boundaries.iter().all(|&b| face(s.boundary_face(b)) && start(s.start(b)))
        && s.entries().iter().all(|e| match s.says {
            Says::Boundary => boundary(e.boundary),
            Says::Face | Says::Nothing => start(e.start),
        })
        && s.entries().iter().filter(|e| !e.is_outer()).count()
            <= 16
                + 2 * match s.says {
                    Says::Boundary => s.boundaries.len(),
                    Says::Face | Says::Nothing => s.half_edges.len() + s.vertices.len(),
                }
}

/// L1 twin: `twin(twin(h)) = h` and `twin(h) ≠ h`.
fn l1(s: &Structure<'_>) -> bool {
    s.half_edges.iter().all(|&h| s.on_border(h) || s.twin(s.twin(h)) == h && s.twin(h) != h)
}

/// L2 next/prev: `prev(next(h)) = h` and `next(prev(h)) = h`.
///
/// Without `prev`: no two half-edges have the same next.
fn l2(s: &Structure<'_>) -> bool {
    if s.lacks(Part::Prev) {
        s.half_edges.iter().all(|&g| s.half_edges.iter().all(|&h| g == h || s.next(g) != s.next(h)))
    } else {
        s.half_edges.iter().all(|&h| s.prev(s.next(h)) == h && s.next(s.prev(h)) == h)
    }
}

/// L3 target: `origin(next(h)) = origin(twin(h))`.
fn l3(s: &Structure<'_>) -> bool {
    s.half_edges.iter().all(|&h| s.on_border(h) || s.origin(s.next(h)) == s.origin(s.twin(h)))
}

/// V1 leaving: the half-edge kept by a vertex leaves that vertex.
fn v1(s: &Structure<'_>) -> bool {
    s.vertices.iter().all(|&v| s.leaving(v).is_none() || s.origin(s.leaving(v)) == v)
}

/// V2 rotation: the rotation of a vertex is all half-edges with that origin.
fn v2(s: &Structure<'_>) -> bool {
    s.half_edges.iter().all(|&h| s.rotation(h) == s.all_leaving(s.origin(h)))
}

/// B1 cycle: the boundary component is constant along `next`, its start is on its own cycle, and it has one cycle.
///
/// So the half-edges of a component are the cycle of its start, which is empty if it starts at a vertex. Without records for
/// boundary components: the face is constant along `next`, and a face lists only half-edges of its own.
fn b1(s: &Structure<'_>) -> bool {
    match s.says {
        Says::Nothing => true,
        Says::Boundary => {
            s.half_edges.iter().all(|&h| s.boundary(s.next(h)) == s.boundary(h))
                && s.boundaries.iter().all(|&b| {
                    s.half_edges.iter().copied().filter(|&h| s.boundary(h) == b).collect::<BTreeSet<_>>()
                        == match s.start(b) {
                            Some(Start::HalfEdge(h)) => s.cycle(Some(h)),
                            Some(Start::Vertex(_)) | None => BTreeSet::new(),
                        }
                })
        }
        Says::Face => {
            s.half_edges.iter().all(|&h| s.face(s.next(h)) == s.face(h))
                && s.entries().iter().all(|e| match e.start {
                    Some(Start::HalfEdge(h)) => s.face(Some(h)) == e.face,
                    Some(Start::Vertex(_)) | None => true,
                })
        }
    }
}

/// B2 isolated: a vertex has no half-edge if and only if exactly one boundary component starts at it, and they name
/// each other.
///
/// No component starts at other vertices, and they name none. Without a record of the unbounded face, an isolated vertex may lie
/// there, and then no component starts at it. Without records for boundary components, the list entries of the faces take their
/// place.
fn b2(s: &Structure<'_>) -> bool {
    s.lacks(Part::Holes)
        || s.vertices.iter().all(|&v| {
            let at_v = |start| matches!(start, Some(Start::Vertex(u)) if Some(u) == v);
            let starts: Vec<Link> = match s.says {
                Says::Boundary => s.boundaries.iter().copied().filter(|&b| at_v(s.start(b))).collect(),
                Says::Face | Says::Nothing => s.entries().iter().filter(|e| at_v(e.start)).map(|e| e.face).collect(),
            };
            let right = if s.all_leaving(v).is_empty() {
                starts.len() == 1 || starts.is_empty() && s.lacks(Part::UnboundedFace)
            } else {
                starts.is_empty()
            };
            right && (s.says == Says::Face || s.isolated(v) == starts.first().copied().flatten())
        })
}

/// F1 outer: a bounded face has exactly one outer boundary component, a cycle; the one unbounded face has none.
///
/// A face stores one link for it, so there are never two. It is a cycle: an isolated vertex encloses nothing.
fn f1(s: &Structure<'_>) -> bool {
    let is_unbounded = |f: &&Link| !s.entries().iter().any(|e| e.face == **f && e.is_outer());
    let unbounded = s.faces.iter().filter(is_unbounded).count();
    s.lacks(Part::Faces)
        || unbounded == usize::from(!s.lacks(Part::UnboundedFace))
            && s.entries().iter().all(|e| !e.is_outer() || !matches!(e.start, Some(Start::Vertex(_))))
}

/// F2 listed: every boundary component is listed exactly once, by the face it names, at the place it says.
///
/// Without records for boundary components: every cycle with a face is listed exactly once, a cycle without one at most once (and
/// then B1 is broken).
fn f2(s: &Structure<'_>) -> bool {
    match s.says {
        Says::Nothing => true,
        Says::Boundary => s.boundaries.iter().all(|&b| {
            let listed: Vec<&Entry> = s.entries().iter().filter(|e| e.boundary == b).collect();
            listed.len() == 1
                && listed.iter().all(|e| e.face == s.boundary_face(b))
                && (s.lacks(Part::Places) || listed.iter().all(|e| Some(e.place) == s.place(b)))
        }),
        Says::Face => s.half_edges.iter().all(|&h| {
            let cycle = s.cycle(h);
            let on_it = |e: &&Entry| matches!(e.start, Some(Start::HalfEdge(g)) if cycle.contains(&Some(g)));
            let listed = s.entries().iter().filter(on_it).count();
            listed == 1 || listed == 0 && s.face(h).is_none()
        }),
    }
}

/// T1 outside: each component has exactly one inner boundary component, its outside.
///
/// All its other boundary components are outer.
///
/// It lacks one if its outside has no record: at an open boundary, or without a record of the unbounded face.
fn t1(s: &Structure<'_>) -> bool {
    !s.has_containment()
        || s.components().iter().all(|c| {
            let inner = s.entries().iter().filter(|e| !e.is_outer() && c.contains(&s.vertex_at(e.start))).count();
            inner == 1 || inner == 0 && (s.lacks(Part::UnboundedFace) || s.is_open_somewhere(c))
        })
}

/// T2 nesting: containment is a tree rooted at the unbounded face.
///
/// A component lies in a face, and a face is bounded by a component: no component may lie inside itself, directly or through
/// others.
fn t2(s: &Structure<'_>) -> bool {
    if !s.has_containment() {
        return true;
    }
    let components: Vec<BTreeSet<Link>> = s.components().into_iter().collect();
    let component_at = |start| components.iter().position(|c| c.contains(&s.vertex_at(start)));
    let face_around =
        |c: Link| s.entries().iter().find(|e| !e.is_outer() && component_at(e.start) == c).and_then(|e| e.face);
    let component_around =
        |f: Link| s.entries().iter().find(|e| e.is_outer() && e.face == f).and_then(|e| component_at(e.start));
    let container = |c: Link| c.and_then(|_| component_around(face_around(c)));
    (0..components.len()).map(Some).all(|c| !orbit(container(c), container).contains(&c))
}

/// T3 Euler: per component `V − E + cycles = 2 − 2g`, with `g = 0` in the plane.
///
/// Elsewhere `g ≥ 0`.
fn t3(s: &Structure<'_>) -> bool {
    s.components().iter().all(|c| {
        let (vertices, edges, cycles) = (c.len(), s.edges(c).len(), s.cycles(c));
        match s.expect.surface_kind() {
            Surface::Plane => vertices + cycles == 2 + edges,
            Surface::Any => (0..=edges).any(|g| vertices + cycles + 2 * g == 2 + edges),
        }
    })
}

/// T4 bounds: a simple map with `V ≥ 3` has `E ≤ 3V − 6` and `F ≤ 2V − 4`.
fn t4(s: &Structure<'_>) -> bool {
    let (vertices, edges, faces) = (s.vertices.len(), s.all_edges().len(), s.faces.len());
    s.expect.surface_kind() != Surface::Plane
        || !s.is_simple()
        || vertices < 3
        || edges <= 3 * vertices - 6 && faces <= 2 * vertices - 4
}

/// M1 used: some half-edge leaves every vertex.
fn m1(s: &Structure<'_>) -> bool {
    !s.expect.asks_for(Rule::M1) || s.vertices.iter().all(|&v| !s.all_leaving(v).is_empty())
}

/// M2 simple: no edge is a loop, and no two edges join the same vertices.
fn m2(s: &Structure<'_>) -> bool {
    !s.expect.asks_for(Rule::M2) || s.is_simple()
}

/// M3 sides: every bounded face has the expected number of sides.
///
/// The sides of a face are the half-edges that bound it. Without faces, each cycle counts as a face.
fn m3(s: &Structure<'_>) -> bool {
    let Some(expected) = s.expect.expected_count(Rule::M3) else { return true };
    let sides = |f: Link| s.half_edges.iter().filter(|&&h| s.face_of(h) == f).count();
    match s.says {
        Says::Nothing => s.half_edges.iter().all(|&h| s.cycle(h).len() == expected),
        Says::Boundary | Says::Face => s.entries().iter().filter(|e| e.is_outer()).all(|e| sides(e.face) == expected),
    }
}

/// M4 closed: every half-edge has a twin and bounds a face.
fn m4(s: &Structure<'_>) -> bool {
    !s.expect.asks_for(Rule::M4) || s.half_edges.iter().all(|&h| s.twin(h).is_some() && !s.lacks_face(h))
}

/// M5 connected: there are as many components with an edge as expected.
fn m5(s: &Structure<'_>) -> bool {
    let found = s.components().iter().filter(|c| !s.edges(c).is_empty()).count();
    s.expect.expected_count(Rule::M5).is_none_or(|expected| found == expected)
}

/// M6 borders: there are as many border loops as expected.
///
/// A border loop is a cycle without face, or half-edges without twin that follow one another.
fn m6(s: &Structure<'_>) -> bool {
    let without_face: BTreeSet<_> = s.half_edges.iter().filter(|&&h| s.lacks_face(h)).map(|&h| s.cycle(h)).collect();
    let without_twin: BTreeSet<_> = s.half_edges.iter().filter(|&&h| s.on_border(h)).map(|&h| s.border(h)).collect();
    let found = without_face.len() + without_twin.len();
    s.expect.expected_count(Rule::M6).is_none_or(|expected| found == expected)
}

/// M7 genus: the genera of the components add up to the genus expected.
fn m7(s: &Structure<'_>) -> bool {
    let genus = |c: &BTreeSet<Link>| {
        let (vertices, edges, cycles) = (c.len(), s.edges(c).len(), s.cycles(c));
        (0..=edges).find(|g| vertices + cycles + 2 * g == 2 + edges)
    };
    let found = s.components().iter().map(genus).sum::<Option<usize>>();
    s.expect.expected_count(Rule::M7).is_none_or(|expected| found == Some(expected))
}

/// M8 kept: if a half-edge without twin or face leaves a vertex, the half-edge kept by that vertex lacks a twin or a face.
fn m8(s: &Structure<'_>) -> bool {
    let on_border = |h: Link| s.twin(h).is_none() || s.lacks_face(h);
    !s.expect.asks_for(Rule::M8)
        || s.lacks(Part::Leaving)
        || s.vertices.iter().all(|&v| !s.all_leaving(v).into_iter().any(on_border) || on_border(s.leaving(v)))
}
