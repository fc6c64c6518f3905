//! The bytes of buffers, and the numbers that accessors see in them.

use super::super::error::{Cause, Failure, Position};
use super::document::{Accessor, Document, View};
use base64::Engine as _;
use base64::engine::general_purpose::STANDARD;
use std::borrow::Cow;

const UNSIGNED_BYTE: u64 = 5121;
const UNSIGNED_SHORT: u64 = 5123;
const UNSIGNED_INT: u64 = 5125;
const FLOAT: u64 = 5126;

pub(super) struct Buffers<'a> {
    document: &'a Document<'a>,
    bytes: Vec<Cow<'a, [u8]>>,
}

fn wrong(text: String) -> Failure {
    Failure::new(Position::Byte(0), Cause::Document(text.into()))
}

fn unsupported(what: &'static str) -> Failure {
    Failure::new(Position::Byte(0), Cause::Unsupported(what))
}

impl<'a> Buffers<'a> {
    pub(super) fn new(document: &'a Document<'a>, binary: Option<&'a [u8]>) -> Result<Self, Failure> {
        let of = |(number, buffer): (usize, &'a super::document::Buffer<'a>)| match &buffer.uri {
            None if number == 0 => binary.map(Cow::Borrowed).ok_or_else(|| wrong("buffer 0 has no bytes".to_owned())),
            None => Err(wrong(format!("buffer {number} has no bytes"))),
            Some(uri) => {
                let data = uri.strip_prefix("data:").and_then(|data| data.split_once(";base64,")).map(|(_, data)| data);
                let data = data.ok_or_else(|| unsupported("a buffer in another file (as GLB it is in the same)"))?;
                STANDARD.decode(data).map(Cow::Owned).map_err(|error| wrong(format!("buffer {number}: {error}")))
            }
        };
        let bytes = document.buffers.iter().enumerate().map(of).collect::<Result<_, _>>()?;
        Ok(Self { document, bytes })
    }

    /// The number of all bytes.
    pub(super) fn length(&self) -> usize {
        self.bytes.iter().map(|bytes| bytes.len()).sum()
    }

    pub(super) fn places(&self, number: usize) -> Result<Vec<[f64; 3]>, Failure> {
        let (accessor, elements) = self.elements(number, "VEC3", 3)?;
        if accessor.component_type != FLOAT {
            return Err(unsupported("places that are no numbers of 32 bits with a point"));
        }
        let number = |bytes: &[u8], i: usize| {
            let four = bytes.get(4 * i..4 * i + 4).and_then(|four| four.try_into().ok()).unwrap_or_default();
            f64::from(f32::from_le_bytes(four))
        };
        Ok(elements.map(|bytes| [0, 1, 2].map(|i| number(bytes, i))).collect())
    }

    pub(super) fn indices(&self, number: usize) -> Result<Vec<u32>, Failure> {
        let (accessor, elements) = self.elements(number, "SCALAR", 1)?;
        if accessor.component_type == FLOAT {
            return Err(wrong(format!("accessor {number}: indices are whole numbers")));
        }
        Ok(elements.map(|bytes| bytes.iter().rev().fold(0, |index, byte| index << 8 | u32::from(*byte))).collect())
    }

    /// The bytes of each element of an accessor.
    fn elements(
        &self,
        number: usize,
        shape: &str,
        count: usize,
    ) -> Result<(&Accessor, impl Iterator<Item = &[u8]>), Failure> {
        let wrong = |text: &str| wrong(format!("accessor {number}: {text}"));
        let accessor = self.document.accessors.get(number).ok_or_else(|| wrong("there is none"))?;
        if accessor.sparse.is_some() {
            return Err(unsupported("a sparse accessor"));
        }
        let width = match accessor.component_type {
            UNSIGNED_BYTE => 1,
            UNSIGNED_SHORT => 2,
            UNSIGNED_INT | FLOAT => 4,
            _ => return Err(wrong("the type of its components is unknown")),
        };
        if accessor.shape != shape {
            return Err(wrong(&format!("its type is {}, not {shape}", accessor.shape)));
        }
        let size = width * count;
        let view = accessor.buffer_view.and_then(|view| self.document.buffer_views.get(view));
        let View { buffer, byte_offset, byte_length, byte_stride } = view.ok_or_else(|| wrong("it has no bytes"))?;
        let stride = byte_stride.unwrap_or(size);
        let bytes =
            self.bytes.get(*buffer).and_then(|bytes| bytes.get(*byte_offset..byte_offset.checked_add(*byte_length)?));
        let bytes = bytes.and_then(|bytes| bytes.get(accessor.byte_offset..));
        // The last element may end before its stride does.
        let needed = accessor.count.checked_sub(1).map_or(Some(0), |last| last.checked_mul(stride)?.checked_add(size));
        let bytes = bytes.zip(needed).and_then(|(bytes, needed)| bytes.get(..needed));
        let bytes = bytes.filter(|_| stride >= size).ok_or_else(|| wrong("it leads beyond its buffer"))?;
        Ok((accessor, bytes.chunks(stride).map(move |chunk| &chunk[..size])))
    }
}
