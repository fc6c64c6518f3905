//! Segments and vertices, filed under the parts of a block that contain them.

use crate::noding::pixel::Block;

/// A part without anything to find.
const NOWHERE: usize = usize::MAX;

/// The number of segments and vertices in a part of a block, and a box around the segments.
#[derive(Clone, Copy)]
pub(super) struct Content {
    pub(super) segments: usize,
    pub(super) vertices: usize,
    /// The smallest block around the segments. They visit no vertex outside of it.
    pub(super) around: Block,
}

/// Nothing, with a block that is no larger than any other.
const EMPTY: Content = Content { segments: 0, vertices: 0, around: Block { low: [i64::MAX; 2], high: [i64::MIN; 2] } };

/// The contents of each part. The memory is reused from block to block.
#[derive(Default)]
pub(super) struct Filing {
    contents: Vec<Content>,
    segments: Vec<[u32; 2]>,
    vertices: Vec<[u32; 2]>,
}

/// The contents filed under a part, at the top of the two pools.
pub(super) struct PartFiling {
    pub(super) part: usize,
    pub(super) content: Content,
    pub(super) segments_from: usize,
    pub(super) vertices_from: usize,
}

impl Filing {
    pub(super) fn clear(&mut self, parts: usize) {
        self.contents.clear();
        self.contents.resize(parts, EMPTY);
        self.segments.clear();
        self.vertices.clear();
    }

    pub(super) fn contents(&self) -> &[Content] {
        &self.contents
    }

    /// Files a segment, with the smallest block that contains it.
    #[inline]
    pub(super) fn segment(&mut self, part: usize, id: u32, around: Block) {
        self.segments.push([part as u32, id]);
        let content = &mut self.contents[part];
        content.segments += 1;
        content.around = content.around.join(&around);
    }

    #[inline]
    pub(super) fn vertex(&mut self, part: usize, id: u32) {
        self.vertices.push([part as u32, id]);
        self.contents[part].vertices += 1;
    }

    /// Moves the contents of the parts that are worth searching to the top of the two pools, part after part.
    pub(super) fn pour(
        &mut self,
        segments: &mut Vec<u32>,
        vertices: &mut Vec<u32>,
        worth: impl Fn(&Content) -> bool,
        mut each: impl FnMut(PartFiling),
    ) {
        let (mut segments_to, mut vertices_to) = (segments.len(), vertices.len());
        for (part, content) in self.contents.iter_mut().enumerate() {
            if !worth(content) {
                (content.segments, content.vertices) = (NOWHERE, NOWHERE);
                continue;
            }
            each(PartFiling { part, content: *content, segments_from: segments_to, vertices_from: vertices_to });
            // From here on, the insertion indices.
            let places = (segments_to, vertices_to);
            segments_to += content.segments;
            vertices_to += content.vertices;
            (content.segments, content.vertices) = places;
        }
        segments.resize(segments_to, 0);
        for &[part, id] in &self.segments {
            let place = &mut self.contents[part as usize].segments;
            if *place != NOWHERE {
                segments[*place] = id;
                *place += 1;
            }
        }
        vertices.resize(vertices_to, 0);
        for &[part, id] in &self.vertices {
            let place = &mut self.contents[part as usize].vertices;
            if *place != NOWHERE {
                vertices[*place] = id;
                *place += 1;
            }
        }
    }
}
