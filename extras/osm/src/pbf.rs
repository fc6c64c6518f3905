//! Reads the selected elements of a file in `.osm.pbf`.

use crate::elements::{Elements, Member, OsmError, Relation, Role};
use crate::filter::TagFilter;
use osmpbf::{BlobDecode, BlobReader, Element, ElementReader, RelMemberType};
use rustc_hash::FxHashSet;
use std::fs::File;
use std::io;
use std::panic::{AssertUnwindSafe, catch_unwind};
use std::path::Path;
use twinedge_geometry::Point;

/// The capabilities that a file may require and this reader has.
const KNOWN: [&str; 2] = ["OsmSchema-V0.6", "DenseNodes"];

/// The types of relations whose ways are borders.
const TYPES: [&str; 2] = ["boundary", "multipolygon"];

impl Elements {
    /// Reads the file in three passes, each by all threads.
    pub(crate) fn read(path: &Path, filter: &TagFilter) -> Result<Self, OsmError> {
        check_header(path)?;
        let mut relations = collect(path, |element, found| {
            if let Element::Relation(relation) = element {
                found.extend(relation_of(&relation, filter));
            }
        })?;
        relations.sort_by_key(|relation: &Relation| relation.id);
        relations.dedup_by_key(|relation| relation.id);
        if relations.is_empty() {
            return Err(OsmError::None(filter.clone()));
        }
        let wanted: FxHashSet<i64> =
            relations.iter().flat_map(|relation| relation.members.iter().map(|member| member.way)).collect();
        let ways = collect(path, |element, found| {
            if let Element::Way(way) = element
                && wanted.contains(&way.id())
            {
                found.push((way.id(), way.refs().collect::<Vec<_>>()));
            }
        })?;
        let wanted: FxHashSet<i64> = ways.iter().flat_map(|(_, nodes)| nodes.iter().copied()).collect();
        let nodes = collect(path, |element, found| {
            let (id, latitude, longitude) = match element {
                Element::Node(node) => (node.id(), node.nano_lat(), node.nano_lon()),
                Element::DenseNode(node) => (node.id(), node.nano_lat(), node.nano_lon()),
                _ => return,
            };
            if wanted.contains(&id) {
                // The quotient is rounded once: it is the double of the decimal.
                found.push((id, Point::new(longitude as f64 / 1e9, latitude as f64 / 1e9)));
            }
        })?;
        Ok(Self { relations, ways: ways.into_iter().collect(), nodes: nodes.into_iter().collect() })
    }
}

fn relation_of(relation: &osmpbf::Relation<'_>, filter: &TagFilter) -> Option<Relation> {
    let tags: Vec<(&str, &str)> = relation.tags().collect();
    let is_border = tags.iter().any(|(key, value)| *key == "type" && TYPES.contains(value));
    if !is_border || !filter.accepts(&tags) {
        return None;
    }
    let members = relation.members().filter(|member| member.member_type == RelMemberType::Way);
    let members = members.filter_map(|member| {
        let role = match member.role().unwrap_or_default() {
            "" => Role::Any,
            "outer" => Role::Outer,
            "inner" => Role::Inner,
            // A role such as `label` is no border.
            _ => return None,
        };
        Some(Member { way: member.member_id, role })
    });
    let owned = |(key, value): (&str, &str)| (key.to_owned(), value.to_owned());
    Some(Relation { id: relation.id(), tags: tags.iter().copied().map(owned).collect(), members: members.collect() })
}

/// Collects all finds of a pass over the elements of a file, in any order.
fn collect<T: Send>(path: &Path, find: impl Fn(Element<'_>, &mut Vec<T>) + Sync + Send) -> Result<Vec<T>, OsmError> {
    let file = io::BufReader::new(File::open(path)?);
    let one = |element: Element<'_>| {
        let mut found = Vec::new();
        find(element, &mut found);
        found
    };
    let both = |mut a: Vec<T>, mut b: Vec<T>| {
        a.append(&mut b);
        a
    };
    ask(|| ElementReader::new(file).par_map_reduce(one, Vec::new, both))
}

/// Refuses a file whose elements have meanings that this reader does not support.
fn check_header(path: &Path) -> Result<(), OsmError> {
    let mut blobs = BlobReader::new(io::BufReader::new(File::open(path)?));
    let needed = ask(|| {
        let Some(blob) = blobs.next().transpose()? else { return Ok(None) };
        Ok(match blob.decode()? {
            BlobDecode::OsmHeader(header) => Some(header.required_features().to_vec()),
            _ => None,
        })
    })?;
    let needed = needed.ok_or_else(|| OsmError::Content("it does not begin with a header".to_owned()))?;
    let unknown = needed.into_iter().find(|feature| !KNOWN.contains(&feature.as_str()));
    unknown.map_or(Ok(()), |feature| Err(OsmError::Needs(feature)))
}

/// Runs a call of the crate, which panics at some numbers that the format does not have.
fn ask<T>(question: impl FnOnce() -> osmpbf::Result<T>) -> Result<T, OsmError> {
    match catch_unwind(AssertUnwindSafe(question)) {
        Ok(answer) => answer.map_err(|error| OsmError::Content(error.to_string())),
        Err(_) => Err(OsmError::Content("a number is none of the format".to_owned())),
    }
}
