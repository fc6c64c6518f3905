//! T1 … T4: components, containment and Euler's formula.
//!
//! ```text
//!   unbounded face                      containment as a tree
//!   ┌───────────────┐                     unbounded face
//!   │  a   ┌─────┐  │                       └─ component of a
//!   │      │  c  │  │                            └─ face ─ component of c
//!   │      └─────┘  │                                          └─ face ─ …
//!   └───────────────┘
//!
//!   T1  the outside of each component is one inner boundary component
//!   T2  following component ► face ► component … ends at the unbounded face
//!   T3  V − E + cycles = 2 − 2g per component
//! ```

use super::components::Components;
use super::report::{Flow, Halt};
use super::run::{NIL, Run, column};
use super::{Bounds, Part, Record, Rule, Start, Surface, Unchecked, View, Violation};

impl<V: View + ?Sized> Run<'_, V> {
    /// Runs T1, T2, T3 and T4. A glance may have counted the cycles and seen to T1 already.
    pub(super) fn topology(&mut self, glanced: bool, bounds: &mut Option<Bounds>) -> Result<(), Halt> {
        if let Some(rule) = self.map_broken().or_else(|| self.findings.broken(&[Rule::V2])) {
            for rule_waiting in [Rule::T1, Rule::T2, Rule::T3, Rule::T4] {
                self.findings.not_checked(rule_waiting, Unchecked::Broken(rule));
            }
            return Ok(());
        }
        let Some(mut components) = self.components.take() else { return Ok(()) };
        self.counts.components = Some(components.all.len());
        if !glanced {
            self.cycles(&mut components)?;
            self.outside(&mut components)?;
        }
        self.nesting(&components)?;
        self.euler(&components)?;
        self.bounds(&components, bounds)
    }

    /// Counts the cycles of each component: those of `next`, one for each isolated vertex, and one for each open boundary.
    fn cycles(&mut self, components: &mut Components) -> Flow {
        let by_record = self.expect.has(Part::BoundaryComponents) && !self.expect.is_open();
        let cycles = if by_record && self.findings.broken(&[Rule::R1, Rule::B1]).is_none() {
            // B1 has shown that boundary components and cycles are the same.
            self.count_components_with_cycle(components)
        } else {
            self.count_cycles(components)?
        };
        self.counts.cycles = Some(cycles);
        for component in &mut components.all {
            if component.paired + component.unpaired == 0 {
                component.cycles += 1;
            }
        }
        self.counts.borders = Some(if self.expect.is_open() { self.borders(components)? } else { 0 });
        Ok(())
    }

    fn count_components_with_cycle(&self, components: &mut Components) -> usize {
        let mut cycles = 0;
        for b in 0..self.boundaries {
            if !self.live_boundary(b) {
                continue;
            }
            let start = self.view.boundary_start(b as usize).filter(|start| matches!(start, Start::HalfEdge(_)));
            if let Some(c) = self.component_of_start(components, start) {
                cycles += 1;
                components.all[c].cycles += 1;
            }
        }
        cycles
    }

    fn count_cycles(&self, components: &mut Components) -> Result<usize, Halt> {
        let mut seen = column(self.half_edges, false)?;
        let mut cycles = 0;
        for start in 0..self.half_edges {
            if seen[start as usize] || !self.live_half_edge(start) {
                continue;
            }
            let mut h = start;
            while h != NIL && !seen[h as usize] {
                seen[h as usize] = true;
                h = self.next(h);
            }
            cycles += 1;
            if let Some(c) = self.component_at(components, start) {
                components.all[c].cycles += 1;
                components.all[c].open |= self.lacks_face(start as usize);
            }
        }
        Ok(cycles)
    }

    /// Whether the half-edge has no face, or no boundary component to have one: a cycle of such is an open boundary.
    fn lacks_face(&self, h: usize) -> bool {
        if self.expect.has(Part::BoundaryComponents) {
            self.view.boundary(h).is_none()
        } else {
            self.view.face(h).is_none()
        }
    }

    /// Half-edges without twin follow one another around each open boundary: where V2 holds, one at most leaves a vertex.
    /// Tells how many there are.
    fn borders(&self, components: &mut Components) -> Result<usize, Halt> {
        let mut border_at = column(self.vertices, NIL)?;
        for h in 0..self.half_edges {
            if self.live_half_edge(h)
                && self.twin(h) == NIL
                && let Some(entry) = border_at.get_mut(self.origin(h) as usize)
            {
                *entry = h;
            }
        }
        let mut borders = 0;
        for v in 0..self.vertices as usize {
            let mut h = core::mem::replace(&mut border_at[v], NIL);
            if h == NIL {
                continue;
            }
            borders += 1;
            if let Some(c) = self.component_at(components, h) {
                components.all[c].cycles += 1;
            }
            while h != NIL {
                let target = self.target_by_next(h);
                h = border_at.get_mut(target as usize).map_or(NIL, |entry| core::mem::replace(entry, NIL));
            }
        }
        Ok(borders)
    }

    fn component_at(&self, components: &Components, h: u32) -> Option<usize> {
        let c = components.of.get(self.origin(h) as usize).copied()?;
        (c != NIL).then_some(c as usize)
    }

    fn component_of_start(&self, components: &Components, start: Option<Start>) -> Option<usize> {
        match start? {
            Start::HalfEdge(h) if h < self.half_edges as usize => self.component_at(components, h as u32),
            Start::Vertex(v) => components.of.get(v).filter(|c| **c != NIL).map(|c| *c as usize),
            Start::HalfEdge(_) => None,
        }
    }

    /// Why T1 and T2 cannot be checked, if so.
    pub(super) fn containment_unchecked(&self) -> Option<Unchecked> {
        if self.expect.surface_kind() != Surface::Plane {
            return Some(Unchecked::PlaneOnly);
        }
        if !self.expect.has(Part::Holes) {
            return Some(Unchecked::Lacks(Part::Holes));
        }
        let below = [Rule::R1, Rule::V1, Rule::B1, Rule::B2, Rule::F1, Rule::F2];
        self.findings.broken(&below).map(Unchecked::Broken)
    }

    /// Runs T1, and notes in which face each component lies.
    fn outside(&mut self, components: &mut Components) -> Flow {
        if let Some(why) = self.containment_unchecked() {
            self.findings.not_checked(Rule::T1, why);
            return Ok(());
        }
        let by_record = self.expect.has(Part::BoundaryComponents);
        let mut budget = self.list_budget;
        for f in 0..self.faces as usize {
            if !self.view.is_face(f) {
                continue;
            }
            let listed = self.view.inner_count(f).min(budget);
            budget -= listed;
            for i in 0..listed {
                let (start, record) = if by_record {
                    let b = self.view.inner(f, i).filter(|b| *b < self.boundaries as usize);
                    (b.and_then(|b| self.view.boundary_start(b)), b.map(Record::Boundary))
                } else {
                    let start = self.view.inner_start(f, i);
                    let record = start.map(|start| match start {
                        Start::HalfEdge(h) => Record::HalfEdge(h),
                        Start::Vertex(v) => Record::Vertex(v),
                    });
                    (start, record)
                };
                let (Some(c), Some(record)) = (self.component_of_start(components, start), record) else {
                    continue;
                };
                let component = &mut components.all[c];
                if let Some(first) = component.outside {
                    let vertex = component.vertex as usize;
                    self.findings.add(Violation::TwoOutsides { vertex, first, second: record })?;
                } else {
                    component.outside = Some(record);
                    component.lies_in = f as u32;
                }
            }
        }
        self.findings.checked(Rule::T1, components.all.len() as u64);
        // What has no face around it, by design, has no inner boundary component either.
        let needed = self.expect.has(Part::UnboundedFace);
        for component in &components.all {
            if component.outside.is_none() && needed && !component.open {
                self.findings.add(Violation::NoOutside { vertex: component.vertex as usize })?;
            }
        }
        Ok(())
    }

    /// Runs T2: from each component outwards, until the unbounded face or something already known.
    fn nesting(&mut self, components: &Components) -> Flow {
        let why = self.containment_unchecked().or_else(|| self.findings.broken(&[Rule::T1]).map(Unchecked::Broken));
        if let Some(why) = why {
            self.findings.not_checked(Rule::T2, why);
            return Ok(());
        }
        let count = components.all.len() as u32;
        // The round in which a component was first passed; all rounds before the present one ended well or were reported.
        let mut passed = column(count, NIL)?;
        for first in 0..count {
            let mut c = first;
            loop {
                match passed[c as usize] {
                    NIL => passed[c as usize] = first,
                    round if round == first => {
                        let component = &components.all[c as usize];
                        let (vertex, face) = (component.vertex as usize, component.lies_in as usize);
                        self.findings.add(Violation::NestedInItself { vertex, face })?;
                        break;
                    }
                    _ => break,
                }
                match self.container(components, c) {
                    Some(outer) => c = outer as u32,
                    None => break,
                }
            }
        }
        self.findings.checked(Rule::T2, u64::from(count));
        Ok(())
    }

    /// The component whose outer boundary component bounds the face in which this component lies; none at the root.
    fn container(&self, components: &Components, c: u32) -> Option<usize> {
        let face = components.all[c as usize].lies_in as usize;
        if face >= self.faces as usize {
            return None;
        }
        let start = if self.expect.has(Part::BoundaryComponents) {
            self.view.boundary_start(self.view.outer(face).filter(|b| *b < self.boundaries as usize)?)
        } else {
            self.view.outer_half_edge(face).map(Start::HalfEdge)
        };
        self.component_of_start(components, start)
    }

    /// Runs T3.
    fn euler(&mut self, components: &Components) -> Flow {
        let mut total = 0;
        for component in &components.all {
            let vertex = component.vertex as usize;
            let (vertices, edges, cycles) = (component.vertices as usize, component.edges(), component.cycles as usize);
            let handles = (2 + edges).checked_sub(vertices + cycles);
            match handles {
                Some(twice) if twice % 2 == 0 => {
                    let genus = twice / 2;
                    total += genus;
                    if genus > 0 && self.expect.surface_kind() == Surface::Plane {
                        self.findings.add(Violation::Genus { vertex, vertices, edges, cycles, genus })?;
                    }
                }
                _ => self.findings.add(Violation::NoSuchSurface { vertex, vertices, edges, cycles })?,
            }
        }
        self.findings.checked(Rule::T3, components.all.len() as u64);
        self.counts.genus = Some(total);
        Ok(())
    }

    /// Runs T4.
    fn bounds(&mut self, components: &Components, bounds: &mut Option<Bounds>) -> Flow {
        let (vertices, edges, faces) = (self.counts.vertices, self.counts.edges, self.counts.faces);
        let why = if self.expect.surface_kind() == Surface::Plane {
            (!components.simple || vertices < 3).then_some(Unchecked::NotSimple)
        } else {
            Some(Unchecked::PlaneOnly)
        };
        if let Some(why) = why {
            self.findings.not_checked(Rule::T4, why);
            return Ok(());
        }
        let most = Bounds { most_edges: 3 * vertices - 6, most_faces: 2 * vertices - 4 };
        self.findings.checked(Rule::T4, 1);
        if edges > most.most_edges {
            self.findings.add(Violation::TooManyEdges { vertices, edges })?;
        }
        if faces > most.most_faces {
            self.findings.add(Violation::TooManyFaces { vertices, faces })?;
        }
        *bounds = Some(most);
        Ok(())
    }
}
