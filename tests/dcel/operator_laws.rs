//! Laws for every program: operators can be undone, and stale keys stay stale.

use crate::support::programs::{built, check};
use crate::support::tracked::{Keys, Tracked};
use std::collections::BTreeSet;
use std::sync::atomic::{AtomicUsize, Ordering};
use twinedge::dcel::{Boundary, Connection, Corner, Dcel, Face, HalfEdge, HalfEdgeKey, RemovedEdge, Side, Split, Turn};
use twinedge::program::{Program, Runner, Subject};
use twinedge_trials::canonical::{Canonizer, Code};

/// Applies every possible change to a map, and undoes each at once.
struct Undo<'a> {
    map: &'a Dcel,
    code: Code,
    canonizer: Canonizer,
}

/// The number of operators undone.
static UNDONE: AtomicUsize = AtomicUsize::new(0);

impl Undo<'_> {
    /// Does something, undoes it, and expects the original map.
    fn law<T>(&mut self, does: impl FnOnce(&mut Dcel) -> Option<T>, undoes: impl FnOnce(&mut Dcel, T)) {
        let mut map = self.map.clone();
        if let Some(done) = does(&mut map) {
            undoes(&mut map, done);
            UNDONE.fetch_add(1, Ordering::Relaxed);
            assert_eq!(self.canonizer.subdivision(&map).as_ref(), Some(&self.code));
        }
    }

    fn corners(&self) -> Vec<Corner> {
        let isolated = self.map.vertices().filter(|v| v.isolated().is_some());
        self.map.half_edges().map(|h| h.key().into()).chain(isolated.map(|v| v.key().into())).collect()
    }

    fn isolated_vertices(&mut self) {
        let map = self.map;
        for f in map.faces() {
            self.law(
                |map| map.add_isolated_vertex(f.key()).ok(),
                |map, added| {
                    map.remove_isolated_vertex(added.vertex).unwrap();
                    assert_eq!(*map, *self.map);
                },
            );
        }
        for v in map.vertices() {
            self.law(
                |map| map.remove_isolated_vertex(v.key()).ok(),
                |map, removed| {
                    map.add_isolated_vertex(removed.face).unwrap();
                },
            );
        }
    }

    fn connections(&mut self) {
        let corners = self.corners();
        for (i, from) in corners.iter().enumerate() {
            for (j, to) in corners.iter().enumerate() {
                let new_face = if (i + j) % 2 == 0 { Side::Left } else { Side::Right };
                let of_face = |corner: &Corner| match *corner {
                    Corner::At(h) => self.map.half_edge(h).unwrap().boundary(),
                    Corner::Isolated(v) => self.map.vertex(v).unwrap().isolated().unwrap(),
                };
                let own = of_face(from);
                let inner: Vec<_> = own.face().inner().filter(|b| *b != own).step_by(2).map(Boundary::key).collect();
                self.law(
                    |map| map.connect(*from, *to, Split { new_face, inner: &inner }).ok(),
                    |map, connected| {
                        map.remove_edge(connected.half_edge).unwrap();
                    },
                );
            }
        }
    }

    fn removals(&mut self) {
        let map = self.map;
        for h in map.half_edges() {
            let (n, t) = (h, h.twin());
            // The corner at which the edge was attached, if another edge has it; a loop around nothing stands on the corner of
            // its twin.
            let corner = |h: HalfEdge<'_>, other: HalfEdge<'_>| -> Option<Corner> {
                [other.next(), h.next()]
                    .into_iter()
                    .find(|g| *g != n && *g != t && g.origin() == h.origin())
                    .map(|g| g.key().into())
            };
            let at = [(n, t), (t, n)].map(|(h, other)| corner(h, other).unwrap_or(h.origin().key().into()));
            let left_is_empty = n.next() == n && t.next() != t;
            let inner = |face| -> Vec<_> { map.face(face).unwrap().inner().map(Boundary::key).collect() };
            self.law(
                |map| map.remove_edge(n.key()).ok(),
                |map, removed| {
                    let (left_is_new, inner) = match removed {
                        RemovedEdge::Merged { dropped_face, .. } => {
                            (dropped_face == n.face().key(), inner(dropped_face))
                        }
                        _ => (true, Vec::new()),
                    };
                    // A restored loop has its empty side to its right.
                    let new_face = if left_is_new == left_is_empty { Side::Right } else { Side::Left };
                    map.connect(at[0], at[1], Split { new_face, inner: &inner }).unwrap();
                },
            );
        }
    }

    fn vertices_on_edges(&mut self) {
        let map = self.map;
        for h in map.half_edges().map(HalfEdge::key) {
            self.law(
                |map| map.split_edge(h).ok(),
                |map, _| {
                    map.join_edges(h).unwrap();
                    // Not only isomorphic: every link and key is unchanged.
                    assert_eq!(*map, *self.map);
                },
            );
            self.law(
                |map| map.join_edges(h).ok(),
                |map, _| {
                    map.split_edge(h).unwrap();
                },
            );
        }
    }

    fn vertices_apart(&mut self) {
        let corners = self.corners();
        for from in &corners {
            for to in &corners {
                self.law(
                    |map| map.split_vertex(*from, *to).ok(),
                    |map, split| {
                        map.contract_edge(split.half_edge).unwrap();
                    },
                );
            }
        }
        let map = self.map;
        for h in map.half_edges() {
            let (n, t) = (h, h.twin());
            let corners = [t.next(), n.next()].map(|g| (g != n && g != t).then(|| Corner::from(g.key())));
            self.law(
                |map| map.contract_edge(n.key()).ok(),
                |map, contracted| {
                    let lone = Corner::from(contracted.kept);
                    let from = corners[0].or(corners[1]).unwrap_or(lone);
                    let to = corners[1].or(corners[0]).unwrap_or(lone);
                    map.split_vertex(from, to).unwrap();
                },
            );
        }
    }

    fn turns(&mut self) {
        let map = self.map;
        for h in map.half_edges().map(HalfEdge::key) {
            for turn in [Turn::CounterClockwise, Turn::Clockwise] {
                self.law(
                    |map| map.flip_edge(h, turn).ok(),
                    |map, ()| {
                        map.flip_edge(h, turn.reversed()).unwrap();
                        assert_eq!(links(map), links(self.map));
                    },
                );
            }
        }
    }

    fn moves(&mut self) {
        let map = self.map;
        for b in map.boundaries().map(Boundary::key) {
            for f in map.faces().map(Face::key) {
                self.law(
                    |map| map.move_inner(b, f).ok(),
                    |map, old| {
                        assert_eq!(map.move_inner(b, old).unwrap(), f);
                        assert_eq!(links(map), links(self.map));
                    },
                );
            }
        }
    }
}

/// Returns the links of every half-edge and every isolated vertex, by keys.
fn links(map: &Dcel) -> impl PartialEq + std::fmt::Debug {
    let of_half_edge = |h: HalfEdge<'_>| {
        (h.key(), h.twin().key(), h.next().key(), h.origin().key(), h.boundary().key(), h.face().key())
    };
    let isolated = map.vertices().filter_map(|v| Some((v.key(), v.isolated()?.key(), v.isolated()?.face().key())));
    (map.half_edges().map(of_half_edge).collect::<BTreeSet<_>>(), isolated.collect::<BTreeSet<_>>())
}

#[test]
fn what_is_done_can_be_undone() {
    fn law(program: Program) -> bool {
        let map = built(&program);
        let mut canonizer = Canonizer::new();
        let code = canonizer.subdivision(&map).unwrap();
        let mut undo = Undo { map: &map, code, canonizer };
        undo.isolated_vertices();
        undo.connections();
        undo.removals();
        undo.vertices_on_edges();
        undo.vertices_apart();
        undo.turns();
        undo.moves();
        true
    }
    check(250, 60, law as fn(Program) -> bool);
    let undone = UNDONE.load(Ordering::Relaxed);
    assert!(undone > 20_000, "too little to show anything: {undone}");
}

/// The keys of a structure, and those that it has issued before.
#[derive(Clone, Default)]
struct Memory {
    live: Keys,
    gone: Keys,
}

impl Memory {
    /// Runs a program, and checks after each operator that no key came back, neither for an old record nor for a new one.
    fn run(&mut self, runner: &mut Runner<Dcel>, program: &Program) {
        for op in &program.0 {
            runner.step(*op);
            let now = Keys::of(runner.subject());
            assert!(now.are_live(runner.subject()));
            self.gone.add(&self.live.without(&now));
            assert!(self.gone.are_stale(runner.subject()), "{op}");
            assert_eq!(now.without(&self.gone), now, "{op}");
            self.live = now;
        }
    }
}

/// A clone knows the keys of its original, and refuses the same ones. Afterwards they are independent.
#[test]
fn a_stale_key_never_resolves_again() {
    fn law(program: Program, other: Program) {
        let (mut runner, mut memory) = (Runner::new(Dcel::new()), Memory::default());
        memory.run(&mut runner, &program);
        let (mut clone, mut memory_of_clone) = (runner.clone(), memory.clone());
        assert!(memory.live.are_live(clone.subject()) && memory.gone.are_stale(clone.subject()));
        memory_of_clone.run(&mut clone, &other);
        memory.run(&mut runner, &program);
    }
    check(100, 150, law as fn(Program, Program));
}

/// Makes a polygon in the unbounded face; returns its half-edges, with the inside to their left.
fn polygon(map: &mut Dcel, corners: usize) -> Vec<HalfEdgeKey> {
    let v = map.add_isolated_vertex(Subject::unbounded_face(map).unwrap()).unwrap().vertex;
    let mut sides = vec![map.connect(v, v, Split::default()).unwrap().half_edge];
    while sides.len() < corners {
        sides.push(map.split_edge(sides[sides.len() - 1]).unwrap().half_edge);
    }
    sides
}

#[test]
fn only_the_shorter_side_is_relabelled() {
    let mut map = Dcel::new();
    let (big, small) = (polygon(&mut map, 30_000), polygon(&mut map, 10));
    let outer = |map: &Dcel, h: HalfEdgeKey| map.half_edge(h).unwrap().twin().key();
    let (a, b) = (outer(&map, big[0]), outer(&map, small[0]));
    let of = |map: &Dcel, h: HalfEdgeKey| map.half_edge(h).unwrap().boundary().key();
    let (of_big, of_small) = (of(&map, a), of(&map, b));
    // In either order, the record of the long boundary stays; relabelling the other one is cheaper.
    for (from, to) in [(a, b), (b, a)] {
        let bridge = map.connect(from, to, Split::default()).unwrap();
        let Connection::Bridge { kept, dropped } = bridge.connection else { panic!("{bridge:?}") };
        assert!(kept == of_big && map.boundary(dropped).is_err());
        let removed = map.remove_edge(bridge.half_edge).unwrap();
        let RemovedEdge::Parted { kept, made } = removed else { panic!("{removed:?}") };
        assert_eq!((kept, made), (of_big, of(&map, b)));
    }
    assert!(map.boundary(of_small).is_err());
    // A split also keeps the record, with the new face on either side.
    for (i, j) in [(0, 5), (5, 0), (29_999, 3), (14_000, 14_001)] {
        for new_face in [Side::Left, Side::Right] {
            let whole = of(&map, big[0]);
            let split = map.connect(big[i], big[j], Split { new_face, inner: &[] }).unwrap();
            let Connection::Split { kept, made, .. } = split.connection else { panic!("{split:?}") };
            assert_eq!(kept, whole);
            assert!(map.boundary(made).unwrap().half_edges().take(10).count() < 10);
            let removed = map.remove_edge(split.half_edge).unwrap();
            let RemovedEdge::Merged { kept, dropped, .. } = removed else { panic!("{removed:?}") };
            assert_eq!((kept, dropped), (whole, made));
        }
    }
    assert!(map.validate().is_valid());
}

/// Ten thousand changes at a boundary of sixty thousand half-edges. Walking along it for each would take billions of steps.
#[test]
fn small_changes_to_a_long_boundary_are_cheap() {
    let mut t = Tracked::default();
    let sides = polygon(&mut t.map, 30_000);
    let map = &mut t.map;
    for i in (0..sides.len() - 3).step_by(3) {
        let ear = map.connect(sides[i], sides[i + 2], Split { new_face: Side::Right, inner: &[] }).unwrap();
        if i % 2 == 0 {
            map.remove_edge(ear.half_edge).unwrap();
        }
        let leaf = map.split_vertex(sides[i], sides[i]).unwrap();
        if i % 4 == 0 {
            // The outside is near, though the cycle is long.
            map.remove_edge(leaf.half_edge).unwrap();
        }
    }
    assert_eq!(map.vertex_count(), 40_000 - 1);
    assert!(map.validate().is_valid());
}
