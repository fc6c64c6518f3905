//! Detecting the format from the content.

use super::format::Format;

impl Format {
    /// Returns the format that the content indicates. PLY and OFF start with their name, STL has its name or its length, and
    /// content that starts with a statement of OBJ is taken for OBJ. O(length of the comments at the start).
    #[must_use]
    pub fn of_content(bytes: &[u8]) -> Option<Self> {
        Self::ALL.iter().copied().find(|format| format.fits(bytes))
    }

    fn fits(self, bytes: &[u8]) -> bool {
        match self {
            #[cfg(feature = "obj")]
            Self::Obj => {
                const STARTS: [&[u8]; 12] =
                    [b"v", b"vt", b"vn", b"vp", b"f", b"l", b"p", b"o", b"g", b"s", b"mtllib", b"usemtl"];
                let word = super::text::Text::new(bytes).with_comments(b'#').any_word();
                word.is_some_and(|word| STARTS.contains(&word))
            }
            #[cfg(feature = "off")]
            Self::Off => {
                let word = super::text::Text::new(bytes).with_comments(b'#').any_word();
                word.is_some_and(super::off::is_keyword)
            }
            #[cfg(feature = "ply")]
            Self::Ply => matches!(bytes, [b'p', b'l', b'y', b'\n' | b'\r', ..]),
            #[cfg(feature = "stl")]
            Self::Stl => {
                super::stl::is_named_solid(bytes) || super::stl::expected_length(bytes) == Some(bytes.len() as u64)
            }
        }
    }
}
