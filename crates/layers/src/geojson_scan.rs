//! The structure of a GeoJSON text, byte by byte, without parsing contents.
//!
//! Nothing is checked here: for text that is not JSON, the result is arbitrary.

/// The length of the longest searched name.
const LONGEST: usize = b"features".len();

#[derive(Clone, Copy, Default, PartialEq)]
enum Text {
    #[default]
    Outside,
    Inside,
    Escaped,
}

/// The position relative to the array `features` of the outermost object.
#[derive(Clone, Copy, Default, PartialEq)]
pub(super) enum Array {
    #[default]
    Before,
    Inside,
    Behind,
}

#[derive(Clone, Copy, PartialEq)]
pub(super) enum Turn {
    Opens,
    Closes,
    Neither,
}

#[derive(Default)]
pub(super) struct Scan {
    pub(super) depth: usize,
    pub(super) features: Array,
    /// The name of the current member of the outermost object, up to the longest searched name.
    pub(super) name: Vec<u8>,
    text: Text,
    /// True if the next string is a name of the outermost object, and not in a value of it.
    is_name: bool,
}

impl Scan {
    #[inline]
    pub(super) fn take(&mut self, byte: u8) -> Turn {
        if self.text != Text::Outside {
            self.take_in_text(byte);
            return Turn::Neither;
        }
        match byte {
            b'"' => {
                self.text = Text::Inside;
                if self.is_name {
                    self.name.clear();
                }
            }
            b',' if self.depth == 1 => self.is_name = true,
            b':' if self.depth == 1 => self.is_name = false,
            b'{' | b'[' => {
                self.open(byte);
                return Turn::Opens;
            }
            b'}' | b']' => {
                self.depth = self.depth.saturating_sub(1);
                if self.depth == 1 && self.features == Array::Inside {
                    self.features = Array::Behind;
                }
                return Turn::Closes;
            }
            _ => {}
        }
        Turn::Neither
    }

    fn take_in_text(&mut self, byte: u8) {
        match byte {
            _ if self.text == Text::Escaped => self.text = Text::Inside,
            b'\\' => self.text = Text::Escaped,
            b'"' => {
                self.text = Text::Outside;
                return;
            }
            _ => {}
        }
        if self.is_name && self.name.len() <= LONGEST {
            self.name.push(byte);
        }
    }

    fn open(&mut self, byte: u8) {
        match self.depth {
            0 => {
                self.features = Array::Before;
                self.is_name = true;
            }
            1 if byte == b'[' && self.name == b"features" => self.features = Array::Inside,
            _ => {}
        }
        self.depth += 1;
    }
}
