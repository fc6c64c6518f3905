//! Compacting: the same map without gaps, and the new keys.

use crate::support::programs::{built, check};
use twinedge::dcel::{Boundary, Dcel, Face, HalfEdge, Vertex};
use twinedge::program::Program;
use twinedge_trials::canonical::isomorphic;

#[test]
fn a_compacted_map_is_the_same_without_gaps() {
    fn law(program: Program) {
        let old: Dcel = built(&program);
        let mut new = old.clone();
        let renamed = new.compact();
        assert!(new.validate().is_valid());
        assert!(isomorphic(&new, &old));
        assert_eq!(new.vertex_slots(), new.vertex_count() + 1);
        assert_eq!(new.half_edge_slots(), new.half_edge_count() + 2);
        assert_eq!(new.boundary_slots(), new.boundary_count() + 1);
        assert_eq!(new.face_slots(), new.face_count() + 1);

        assert_eq!(renamed.faces[old.unbounded_face().key()], new.unbounded_face().key());
        assert_eq!(new.unbounded_face().index(), 1);
        let pairs =
            renamed.half_edges.iter().map(|(from, to)| (old.half_edge(from).unwrap(), new.half_edge(*to).unwrap()));
        let mut count = 0;
        for (from, to) in pairs {
            count += 1;
            assert!(new.half_edge(from.key()).is_err() && old.half_edge(to.key()).is_err());
            assert_eq!(renamed.half_edges[from.next().key()], to.next().key());
            assert_eq!(renamed.half_edges[from.twin().key()], to.twin().key());
            assert_eq!(renamed.vertices[from.origin().key()], to.origin().key());
            assert_eq!(renamed.boundaries[from.boundary().key()], to.boundary().key());
            assert_eq!(renamed.faces[from.face().key()], to.face().key());
        }
        assert_eq!(count, old.half_edge_count());
        for f in old.faces() {
            let inner: Vec<_> = f.inner().map(|b| renamed.boundaries[b.key()]).collect();
            let here = new.face(renamed.faces[f.key()]).unwrap();
            assert_eq!(here.inner().map(Boundary::key).collect::<Vec<_>>(), inner);
            assert_eq!(here.outer().map(Boundary::key), f.outer().map(|b| renamed.boundaries[b.key()]));
        }
        // The order is kept.
        assert!(old.vertices().map(|v| renamed.vertices[v.key()]).eq(new.vertices().map(Vertex::key)));
        assert!(old.half_edges().map(|h| renamed.half_edges[h.key()]).eq(new.half_edges().map(HalfEdge::key)));
        assert!(old.boundaries().map(|b| renamed.boundaries[b.key()]).eq(new.boundaries().map(Boundary::key)));
        let bounded = |f: &Face<'_>| !f.is_unbounded();
        let faces = new.faces().filter(bounded).map(Face::key);
        assert!(old.faces().filter(bounded).map(|f| renamed.faces[f.key()]).eq(faces));
    }
    check(300, 200, law as fn(Program));
}
