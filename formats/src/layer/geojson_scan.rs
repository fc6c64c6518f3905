//! The structure of a text of GeoJSON, byte by byte, without reading what it holds.
//!
//! Nothing is checked here: of a text that is no JSON, any structure may be told.

/// The longest name that is looked for.
const LONGEST: usize = b"features".len();

/// The place with respect to texts.
#[derive(Clone, Copy, Default, PartialEq)]
enum Text {
    #[default]
    Outside,
    Inside,
    /// Behind a backslash.
    Escaped,
}

/// The place with respect to the array `features` of the outermost object.
#[derive(Clone, Copy, Default, PartialEq)]
pub(super) enum Array {
    #[default]
    Before,
    Inside,
    Behind,
}

/// The effect of a byte.
#[derive(Clone, Copy, PartialEq)]
pub(super) enum Turn {
    /// It opens an object or an array.
    Opens,
    /// It closes one.
    Closes,
    Neither,
}

/// The state between two bytes.
#[derive(Default)]
pub(super) struct Scan {
    /// The number of objects and arrays that are open.
    pub(super) depth: usize,
    pub(super) features: Array,
    /// The name of the member of the outermost object, as far as it is looked for.
    pub(super) name: Vec<u8>,
    text: Text,
    /// True if the next text is a name of the outermost object, and not in a value of it.
    is_name: bool,
}

impl Scan {
    /// Takes the next byte.
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
