//! The index of `FlatGeobuf`: a tree of boxes that finds the features in a window without reading others.
//!
//! Features are numbered in file order. Leaves must be in the same order, so that both have equal numbers; all known writers do
//! this, and anything else is an error.

use super::super::each::EachGeometry;
use super::super::error::{Cause, Place, ReadError};
use super::super::extent::Extent;
use super::super::model::{Geometry, Header};
use super::read::{content, geometry_of, header_bytes, header_of, invalid, of_header};
use super::tree::{NODE, Tree};
use crate::windows::Windows;
use ::flatgeobuf::GeometryType as Kind;
use std::fs::File;
use std::io::{BufReader, Read, Seek, SeekFrom};
use std::ops::Range;
use std::path::Path;

#[derive(Clone, Copy)]
struct Node {
    extent: Extent,
    /// For a leaf, the offset of its feature after the index.
    offset: u64,
}

pub(crate) struct IndexedFile {
    file: File,
    length: u64,
    header: Vec<u8>,
    tree: Tree,
    /// The offsets of the index and of the features.
    index: u64,
    features: u64,
    root: Extent,
    read: u64,
}

impl IndexedFile {
    /// Opens a file; `None` if it has no index.
    pub(crate) fn open(path: &Path) -> Result<Option<Self>, ReadError> {
        let file = File::open(path)?;
        let length = file.metadata()?.len();
        let header = header_bytes(&mut BufReader::new(&file))?;
        let tree = Tree::of_header(&header_of(&header)?).map_err(|cause| content(Place::Header, cause))?;
        let Some(tree) = tree else { return Ok(None) };
        let index = 8 + header.len() as u64;
        let features = index.saturating_add(tree.bytes());
        let mut found = Self { file, length, header, tree, index, features, root: Extent::NOTHING, read: index };
        found.root = found.nodes(found.tree.level_count() - 1, 0..1)?[0].extent;
        Ok(Some(found))
    }
}

impl Windows for IndexedFile {
    fn extent(&self) -> Extent {
        self.root
    }

    fn header(&self) -> Result<Header, ReadError> {
        Ok(of_header(&header_of(&self.header)?, Vec::new()))
    }

    fn has_only_points(&self) -> Result<bool, ReadError> {
        Ok(matches!(header_of(&self.header)?.geometry_type(), Kind::Point | Kind::MultiPoint))
    }

    fn count(&self) -> u64 {
        self.tree.count()
    }

    fn bytes(&self) -> [u64; 2] {
        [self.read, self.length]
    }

    /// Passes on the geometries that may meet a window, with the numbers of their features in order. Memory O(largest feature).
    fn read(
        &mut self,
        window: &Extent,
        is_wanted: &mut dyn FnMut(u64) -> bool,
        each: &mut EachGeometry<'_>,
    ) -> Result<(), ReadError> {
        let mut ahead = vec![(self.tree.level_count() - 1, 0, self.root)];
        while let Some((level, node, around)) = ahead.pop() {
            let below = self.tree.below(level, node);
            // Includes the leaf after the last one, as a feature ends where the next one begins.
            let to = if level == 1 { (below.end + 1).min(self.count()) } else { below.end };
            let nodes = self.nodes(level - 1, below.start..to)?;
            let mut met = Vec::new();
            for (number, place) in below.zip(0..) {
                let extent = nodes[place].extent;
                let at = if level == 1 { Place::Feature(number as usize) } else { Place::Header };
                around.check(&extent).map_err(|cause| content(at, cause))?;
                let extent = extent.or(around);
                if !nodes[place].extent.may_meet(window) {
                    continue;
                }
                if level > 1 {
                    met.push((level - 1, number, extent));
                } else if is_wanted(number) {
                    let end = nodes.get(place + 1).map(|node| node.offset);
                    let geometry = self.feature(number, nodes[place].offset, end)?;
                    if let Some(geometry) = &geometry {
                        extent.check_geometry(geometry).map_err(|cause| content(at, cause))?;
                    }
                    each(number, geometry);
                }
            }
            ahead.extend(met.into_iter().rev());
        }
        Ok(())
    }

    /// None: the index locates each feature.
    fn passed(&self, _: &Extent) -> u64 {
        0
    }
}

impl IndexedFile {
    fn nodes(&mut self, level: usize, nodes: Range<u64>) -> Result<Vec<Node>, ReadError> {
        let at = self.index + (self.tree.start(level) + nodes.start) * NODE;
        let bytes = self.bytes_at(at, (nodes.end - nodes.start) * NODE, Place::Header, "the index")?;
        let number = |bytes: &[u8], i: usize| {
            let mut number = [0; 8];
            number.copy_from_slice(&bytes[8 * i..8 * i + 8]);
            number
        };
        let node = |bytes: &[u8]| Node {
            extent: Extent::new([0, 1, 2, 3].map(|i| f64::from_le_bytes(number(bytes, i)))),
            offset: u64::from_le_bytes(number(bytes, 4)),
        };
        Ok(bytes.chunks_exact(NODE as usize).map(node).collect())
    }

    /// Reads the geometry of the feature between two offsets after the index; `None` as the second means the end of the file.
    fn feature(&mut self, number: u64, start: u64, end: Option<u64>) -> Result<Option<Geometry>, ReadError> {
        let place = Place::Feature(number as usize);
        let refused = |cause| content(place, cause);
        let end = end.unwrap_or(self.length.saturating_sub(self.features));
        let length = end.checked_sub(start).filter(|_| (number == 0) == (start == 0));
        let out_of_order = || refused(invalid("the index does not list the features in their order"));
        let length = length.ok_or_else(out_of_order)?;
        let body = self.bytes_at(self.features.saturating_add(start), length, place, "a table")?;
        let prefix = body.first_chunk().map(|bytes| u64::from(u32::from_le_bytes(*bytes)) + 4);
        if prefix != Some(length) {
            return Err(out_of_order());
        }
        geometry_of(&header_of(&self.header)?, &body).map_err(refused)
    }

    fn bytes_at(&mut self, at: u64, length: u64, place: Place, what: &'static str) -> Result<Vec<u8>, ReadError> {
        if at.checked_add(length).is_none_or(|end| end > self.length) {
            return Err(content(place, Cause::Truncated(what)));
        }
        let mut bytes = vec![0; length as usize];
        self.file.seek(SeekFrom::Start(at))?;
        self.file.read_exact(&mut bytes)?;
        self.read += length;
        Ok(bytes)
    }
}
