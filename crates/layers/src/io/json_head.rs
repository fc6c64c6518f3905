//! The beginning of a JSON text, scanned without a parser: the members of its outermost object, and any following object.

/// The parsed beginning of a JSON text, which may be cut anywhere.
#[derive(Debug, Default)]
pub(super) struct JsonHead<'t> {
    /// The members of the outermost object whose value is a string without escapes.
    members: Vec<(&'t str, &'t str)>,
    /// The bytes after the end of the outermost object, if it ends.
    rest: Option<&'t [u8]>,
}

impl<'t> JsonHead<'t> {
    /// Scans a text. O(bytes).
    pub(super) fn scan(text: &'t [u8]) -> Self {
        let mut head = Self::default();
        let mut depth = 0_usize;
        // The last string at depth 1, and true once a colon has followed it.
        let mut key: Option<(&str, bool)> = None;
        let mut at = 0;
        while let Some(byte) = text.get(at) {
            at += 1;
            match byte {
                b'"' => {
                    let Some(end) = end_of_string(&text[at..]) else { break };
                    let string = core::str::from_utf8(&text[at..at + end]).unwrap_or_default();
                    at += end + 1;
                    if depth == 1 {
                        match key {
                            Some((name, true)) => {
                                head.members.push((name, string));
                                key = None;
                            }
                            _ => key = Some((string, false)),
                        }
                    }
                }
                b':' if depth == 1 => key = key.map(|(name, _)| (name, true)),
                b',' if depth == 1 => key = None,
                b'{' | b'[' => depth += 1,
                b'}' | b']' => {
                    depth = depth.saturating_sub(1);
                    if depth == 0 {
                        head.rest = Some(&text[at..]);
                        break;
                    }
                }
                _ => {}
            }
        }
        head
    }

    /// Returns the value of a member of the outermost object, if it is a string.
    pub(super) fn member(&self, name: &str) -> Option<&'t str> {
        self.members.iter().find(|(key, _)| *key == name).map(|(_, value)| *value)
    }

    /// Returns true if another object follows the outermost one.
    pub(super) fn goes_on(&self) -> bool {
        let next = |rest: &[u8]| rest.iter().copied().find(|byte| !byte.is_ascii_whitespace() && *byte != 0x1E);
        self.rest.and_then(next) == Some(b'{')
    }
}

/// Returns the end of a string, after its opening quote.
fn end_of_string(text: &[u8]) -> Option<usize> {
    let mut escaped = false;
    text.iter().position(|byte| {
        let ends = *byte == b'"' && !escaped;
        escaped = *byte == b'\\' && !escaped;
        ends
    })
}
