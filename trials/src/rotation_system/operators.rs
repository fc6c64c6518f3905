//! The operators of the model.

use super::{HalfEdge, ModelCorner, RotationSystem, UNBOUNDED};
use twinedge::dcel::{Corner, Side, Turn};
use twinedge::mesh_operators_by_steps;
use twinedge::program::{Refusal, Subject};

impl Subject for RotationSystem {
    type Vertex = usize;
    type HalfEdge = usize;
    type Face = usize;

    fn unbounded_face(&self) -> Option<usize> {
        Some(UNBOUNDED)
    }

    fn half_edge_at(&self, index: usize) -> Option<usize> {
        self.half_edges.contains_key(&index).then_some(index)
    }

    fn vertex_at(&self, index: usize) -> Option<usize> {
        self.vertices.contains_key(&index).then_some(index)
    }

    fn face_of(&self, corner: ModelCorner) -> Result<usize, Refusal> {
        match corner {
            Corner::At(h) => Ok(self.half_edge(h)?.face),
            Corner::Isolated(v) => {
                let v = self.vertices.get(&v).ok_or(Refusal::Stale)?;
                if v.leaving.is_empty() { Ok(v.face) } else { Err(Refusal::NotIsolated) }
            }
        }
    }

    fn origin_of(&self, half_edge: usize) -> Result<usize, Refusal> {
        Ok(self.half_edge(half_edge)?.origin)
    }

    fn twin_of(&self, half_edge: usize) -> Result<usize, Refusal> {
        self.half_edge(half_edge)?;
        Ok(half_edge ^ 1)
    }

    fn next_of(&self, half_edge: usize) -> Result<usize, Refusal> {
        self.half_edge(half_edge)?;
        Ok(self.next(half_edge))
    }

    fn add_isolated_vertex(&mut self, face: usize) -> Result<usize, Refusal> {
        self.faces.get(&face).ok_or(Refusal::Stale)?;
        Ok(self.make_vertex(Vec::new(), face))
    }

    fn remove_isolated_vertex(&mut self, vertex: usize) -> Result<(), Refusal> {
        self.face_of(Corner::Isolated(vertex))?;
        self.vertices.remove(&vertex);
        Ok(())
    }

    fn connect(
        &mut self,
        from: ModelCorner,
        to: ModelCorner,
        new_face: Side,
        inner: &[ModelCorner],
    ) -> Result<usize, Refusal> {
        let (face, other) = (self.face_of(from)?, self.face_of(to)?);
        let inner_faces = inner.iter().map(|corner| self.face_of(*corner)).collect::<Result<Vec<_>, _>>()?;
        if face != other {
            return Err(Refusal::FacesDiffer);
        }
        let cycle = self.boundary(from);
        let splits = cycle.contains(&to);
        let may_go = |corner: &ModelCorner| match corner {
            Corner::At(h) => !cycle.contains(corner) && !self.is_outer(*h),
            Corner::Isolated(_) => !cycle.contains(corner),
        };
        if splits && !(inner_faces.iter().all(|f| *f == face) && inner.iter().all(may_go)) {
            return Err(Refusal::NotInner);
        }
        let is_outer = matches!(from, Corner::At(h) if self.is_outer(h));
        let (a, b) = (self.vertex_of(from)?, self.vertex_of(to)?);
        let n = self.make_edge(HalfEdge { origin: a, face }, HalfEdge { origin: b, face });
        self.attach(n, a, from);
        self.attach(n ^ 1, b, to);
        if splits {
            let new = self.made_faces;
            self.made_faces += 1;
            let (of_new, of_old) = match new_face {
                Side::Left => (n, n ^ 1),
                Side::Right => (n ^ 1, n),
            };
            self.faces.insert(new, Some(of_new));
            if is_outer {
                self.faces.insert(face, Some(of_old));
            }
            let cycle = self.boundary(Corner::At(of_new));
            self.set_face(&cycle, new);
            for corner in inner {
                let boundary = self.boundary(*corner);
                self.set_face(&boundary, new);
            }
        }
        Ok(n)
    }

    fn remove_edge(&mut self, half_edge: usize) -> Result<Option<usize>, Refusal> {
        self.half_edge(half_edge)?;
        let (n, t) = (half_edge, half_edge ^ 1);
        let dropped = (!self.cycle(n).contains(&t)).then(|| self.merge(n, t));
        let before = self.clone();
        let face = self.half_edges[&n].face;
        let ends = [self.origin(n), self.origin(t)];
        self.detach(n);
        self.detach(t);
        for v in ends {
            self.vertex(v).face = face;
        }
        if dropped.is_none() && before.is_outer(n) {
            let outer = before.outer_after_parting(n, self);
            self.faces.insert(face, outer);
        }
        self.remove_half_edges([n, t]);
        Ok(dropped)
    }

    fn split_edge(&mut self, half_edge: usize) -> Result<usize, Refusal> {
        let h = self.half_edge(half_edge)?;
        let t = self.half_edge(half_edge ^ 1)?;
        let n = self.make_edge(h, t);
        for leaving in &mut self.vertex(t.origin).leaving {
            if *leaving == half_edge ^ 1 {
                *leaving = n ^ 1;
            }
        }
        self.make_vertex(vec![n, half_edge ^ 1], h.face);
        Ok(n)
    }

    fn join_edges(&mut self, half_edge: usize) -> Result<(), Refusal> {
        self.half_edge(half_edge)?;
        let (h, t) = (half_edge, half_edge ^ 1);
        let (v, n) = (self.origin(t), self.next(h));
        if self.vertices[&v].leaving.len() != 2 {
            return Err(Refusal::DegreeNotTwo);
        }
        if n == h {
            return Err(Refusal::Loop);
        }
        self.spare([n, n ^ 1]);
        let b = self.origin(n ^ 1);
        self.attach(t, b, Corner::At(n ^ 1));
        self.detach(n ^ 1);
        self.remove_half_edges([n, n ^ 1]);
        self.vertices.remove(&v);
        Ok(())
    }

    fn split_vertex(&mut self, from: ModelCorner, to: ModelCorner) -> Result<usize, Refusal> {
        let (v, other) = (self.vertex_of(from)?, self.vertex_of(to)?);
        if v != other {
            return Err(Refusal::VerticesDiffer);
        }
        let (right, left) = (self.face_of(from)?, self.face_of(to)?);
        let mut leaving = Vec::new();
        if let (Corner::At(a), Corner::At(b)) = (from, to) {
            let mut at = a;
            while at != b {
                at = self.turned(at, 1);
                leaving.push(at);
            }
        }
        let n = self.make_edge(HalfEdge { origin: v, face: left }, HalfEdge { origin: v, face: right });
        self.attach(n, v, from);
        self.vertex(v).leaving.retain(|h| !leaving.contains(h));
        leaving.push(n ^ 1);
        self.make_vertex(leaving, left);
        Ok(n)
    }

    fn contract_edge(&mut self, half_edge: usize) -> Result<usize, Refusal> {
        self.half_edge(half_edge)?;
        let (n, t) = (half_edge, half_edge ^ 1);
        let (kept, dropped) = (self.origin(n), self.origin(t));
        if kept == dropped {
            return Err(Refusal::Loop);
        }
        self.spare([n, t]);
        let face = self.half_edges[&n].face;
        // Each goes in just behind `n`, so the last is the first.
        let mut at = self.turned(t, self.vertices[&dropped].leaving.len() - 1);
        while at != t {
            let before = self.turned(at, self.vertices[&dropped].leaving.len() - 1);
            self.detach(at);
            self.attach(at, kept, Corner::At(n));
            at = before;
        }
        self.detach(n);
        self.remove_half_edges([n, t]);
        self.vertices.remove(&dropped);
        self.vertex(kept).face = face;
        Ok(dropped)
    }

    fn flip_edge(&mut self, half_edge: usize, turn: Turn) -> Result<(), Refusal> {
        self.half_edge(half_edge)?;
        let (n, t) = (half_edge, half_edge ^ 1);
        if self.cycle(n).contains(&t) {
            return Err(Refusal::NotSeparating);
        }
        let alone = [n, t].map(|h| self.next(h) == h);
        let steps = match turn {
            Turn::CounterClockwise => [self.next(t), self.next(n)],
            Turn::Clockwise => [self.prev(n), self.prev(t)],
        };
        match (alone, turn) {
            ([true, true], _) => {}
            ([false, false], Turn::CounterClockwise) => {
                self.reattach(n, |model| [(n, model.next(steps[0])), (t, model.next(steps[1]))]);
            }
            ([false, false], Turn::Clockwise) => self.reattach(n, |_| [(n, steps[0]), (t, steps[1])]),
            // A loop slides. The half-edge inside goes in last, next to the corner.
            ([n_alone, _], turn) => {
                let (lone, s) = if n_alone { (n, t) } else { (t, n) };
                let (after, before) = (self.next(s), self.prev(s));
                self.reattach(n, |model| {
                    let corner = match turn {
                        Turn::CounterClockwise => model.next(after),
                        Turn::Clockwise => before,
                    };
                    [(s, corner), (lone, corner)]
                });
            }
        }
        Ok(())
    }

    fn move_inner(&mut self, inner: ModelCorner, face: usize) -> Result<(), Refusal> {
        let old = self.face_of(inner)?;
        self.faces.get(&face).ok_or(Refusal::Stale)?;
        if let Corner::At(h) = inner {
            if self.is_outer(h) {
                return Err(Refusal::IsOuter);
            }
            if old != face && self.lies_inside(face, h) {
                return Err(Refusal::InsideItself);
            }
        }
        let boundary = self.boundary(inner);
        self.set_face(&boundary, face);
        Ok(())
    }

    mesh_operators_by_steps!();
}
