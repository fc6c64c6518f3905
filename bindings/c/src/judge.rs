//! From the plan to the report.

use crate::callbacks::Answers;
use crate::cells::{Atomic, Width};
use crate::failure::{Failure, Status};
use crate::names::{Link, Record};
use crate::plan::Plan;
use crate::words::Words;
use std::sync::atomic::{AtomicI32, AtomicI64, AtomicU32, AtomicU64};
use twinedge::validate::{Collect, Expectation, Report};
use twinedge_columns::{Boundaries, Cell, Column, Columns};

/// The columns of a structure, and the numbers of records that the caller has set.
struct Arguments<'a, T> {
    columns: [Option<Column<'a, T>>; Link::KINDS],
    counts: [Option<usize>; Record::KINDS],
    live: [Option<Vec<bool>>; Record::KINDS],
}

/// Returns the report of the structure that the plan describes.
///
/// # Safety
/// The memory of its columns and records exists, and its functions may be called.
pub(crate) unsafe fn judge(plan: &Plan) -> Result<(Report, Words), Failure> {
    let expectation = plan.asked.expectation()?;
    let collect = plan.asked.collect();
    // SAFETY: as the caller promises.
    let live = unsafe { flags(plan) }?;
    if plan.is_of_pointers()? {
        plan.pointers_are_complete()?;
        // SAFETY: as the caller promises.
        let answers = unsafe { Answers::of(plan.records, &plan.links, plan.inner) }?;
        let given = Arguments { columns: answers.columns(), counts: answers.counts().map(Some), live };
        let report = given.judge(expectation, collect)?;
        let words = Words::new(plan, &report, |_, _| None);
        return Ok((report, words));
    }
    // SAFETY: as the caller promises; every column has this width.
    unsafe {
        match plan.width.unwrap_or(Width::I32) {
            Width::I32 => of_type::<AtomicI32>(plan, live, expectation, collect),
            Width::I64 => of_type::<AtomicI64>(plan, live, expectation, collect),
            Width::U32 => of_type::<AtomicU32>(plan, live, expectation, collect),
            Width::U64 => of_type::<AtomicU64>(plan, live, expectation, collect),
        }
    }
}

/// # Safety
/// The memory is there.
unsafe fn flags(plan: &Plan) -> Result<[Option<Vec<bool>>; Record::KINDS], Failure> {
    let mut flags = [const { None }; Record::KINDS];
    for (flags, cells) in flags.iter_mut().zip(&plan.live) {
        if let Some(cells) = cells {
            // SAFETY: as the caller promises; `live` holds cells of bytes.
            *flags = Some(unsafe { cells.flags() }?);
        }
    }
    Ok(flags)
}

/// # Safety
/// The memory is there, and `T` has the width of the plan.
unsafe fn of_type<T: Atomic>(
    plan: &Plan,
    live: [Option<Vec<bool>>; Record::KINDS],
    expectation: Expectation,
    collect: Collect,
) -> Result<(Report, Words), Failure> {
    let mut columns = [const { None }; Link::KINDS];
    for (column, cells) in columns.iter_mut().zip(&plan.columns) {
        if let Some(cells) = cells {
            // SAFETY: as the caller promises. The slices live in this function only, as `columns` does.
            *column = Some(unsafe { cells.column::<T>() }?);
        }
    }
    let report = Arguments { columns, counts: plan.counts, live }.judge(expectation, collect)?;
    // SAFETY: as for the columns.
    let number = |link: Link, at| plan.columns[link as usize].and_then(|cells| unsafe { cells.number::<T>(at) });
    let words = Words::new(plan, &report, number);
    Ok((report, words))
}

impl<'a, T: Cell> Arguments<'a, T> {
    fn column(&self, link: Link) -> Option<Column<'a, T>> {
        self.columns[link as usize]
    }

    fn needed(&self, link: Link) -> Result<Column<'a, T>, Failure> {
        self.column(link).ok_or_else(|| Failure::new(Status::Missing, format!("{}: missing", link.name())))
    }

    /// Returns the number of records of a kind: the caller's number, or the length of one of these columns, or of the
    /// marks of live records.
    fn count(&self, kind: Record, links: &[Link]) -> Option<usize> {
        let marks = self.live[kind as usize].as_ref().map(Vec::len);
        let columns = || links.iter().find_map(|link| self.column(*link).map(|column| column.len()));
        self.counts[kind as usize].or_else(columns).or(marks)
    }

    fn judge(&self, expectation: Expectation, collect: Collect) -> Result<Report, Failure> {
        let next = self.needed(Link::Next)?;
        let by_target = self.column(Link::Target).is_some();
        let ends = match (self.column(Link::Origin), self.column(Link::Target)) {
            (Some(ends), None) | (None, Some(ends)) => ends,
            (None, None) => return Err(Failure::new(Status::Missing, "give either origin or target")),
            (Some(_), Some(_)) => return Err(Failure::new(Status::Conflict, "give either origin or target")),
        };
        self.columns(ends, next, by_target)?.validate(expectation, collect).ok_or_else(Failure::memory)
    }

    fn columns(&self, ends: Column<'a, T>, next: Column<'a, T>, by_target: bool) -> Result<Columns<'_, T>, Failure> {
        // A link beyond the end dangles, and must not raise the number of records.
        let slots = |column: Column<'_, T>| column.slots().min(next.len());
        let vertices = self.count(Record::Vertex, &[Link::Leaving, Link::Isolated]).unwrap_or_else(|| slots(ends));
        let mut columns = Columns::paired(vertices, ends, next).map_err(|error| {
            // The column has one of two names.
            let name = if by_target { "`target`" } else { "`origin`" };
            Failure::new(Status::Length, error.to_string().replacen("`origin`", name, 1))
        })?;
        if let Some(twin) = self.column(Link::Twin) {
            columns = Columns::new(vertices, ends, twin, next)?;
        }
        if by_target {
            columns = columns.by_target();
        }
        if let Some(half_edges) = self.counts[Record::HalfEdge as usize].filter(|count| *count != next.len()) {
            let message = format!("the column `next` has length {}, where {half_edges} is expected", next.len());
            return Err(Failure::new(Status::Length, message));
        }
        if let Some(prev) = self.column(Link::Prev) {
            columns = columns.with_prev(prev)?;
        }
        if let Some(leaving) = self.column(Link::Leaving) {
            columns = columns.with_leaving(leaving)?;
        }
        columns = self.with_faces(columns, slots)?;
        let [vertices, half_edges, boundaries, faces] = &self.live;
        if let Some(live) = vertices {
            columns = columns.with_live_vertices(live)?;
        }
        if let Some(live) = half_edges {
            columns = columns.with_live_half_edges(live)?;
        }
        if let Some(live) = boundaries {
            columns = columns.with_live_boundaries(live)?;
        }
        if let Some(live) = faces {
            columns = columns.with_live_faces(live)?;
        }
        Ok(columns)
    }

    /// Adds the columns by which half-edges and faces name each other: directly, or by records of boundary components.
    fn with_faces<'b>(
        &self,
        columns: Columns<'b, T>,
        slots: impl Fn(Column<'_, T>) -> usize,
    ) -> Result<Columns<'b, T>, Failure>
    where
        'a: 'b,
    {
        let of_boundaries = [
            Link::Boundary,
            Link::Isolated,
            Link::Outer,
            Link::InnerFirst,
            Link::Inner,
            Link::BoundaryFace,
            Link::BoundaryHalfEdge,
            Link::BoundaryVertex,
        ];
        let face = self.column(Link::Face);
        let kept = self.column(Link::FaceHalfEdge);
        if let Some(link) = of_boundaries.into_iter().find(|link| self.column(*link).is_some()) {
            if face.is_some() || kept.is_some() {
                let message =
                    format!("{}: with boundary components, faces have no half-edges of their own", link.name());
                return Err(Failure::new(Status::Conflict, message));
            }
            let boundaries = Boundaries {
                boundary: self.needed(Link::Boundary)?,
                isolated: self.column(Link::Isolated),
                face: self.needed(Link::BoundaryFace)?,
                half_edge: self.needed(Link::BoundaryHalfEdge)?,
                vertex: self.column(Link::BoundaryVertex),
                outer: self.needed(Link::Outer)?,
                inner_first: self.needed(Link::InnerFirst)?,
                inner: self.needed(Link::Inner)?,
            };
            let faces = self.count(Record::Face, &[Link::Outer]).unwrap_or_default();
            let expected = self.counts[Record::Boundary as usize];
            if let Some(count) = expected.filter(|count| *count != boundaries.face.len()) {
                let found = boundaries.face.len();
                let message = format!("the column `boundary_face` has length {found}, where {count} is expected");
                return Err(Failure::new(Status::Length, message));
            }
            return Ok(columns.with_boundaries(faces, boundaries)?);
        }
        match (face, kept) {
            (None, None) => Ok(columns),
            (None, Some(_)) => Err(Failure::new(Status::Missing, "face_half_edge: needs face")),
            (Some(face), kept) => {
                let faces = self.count(Record::Face, &[Link::FaceHalfEdge]).unwrap_or_else(|| slots(face));
                let columns = columns.with_faces(faces, face)?;
                Ok(match kept {
                    Some(kept) => columns.with_outer_half_edge(kept)?,
                    None => columns,
                })
            }
        }
    }
}
