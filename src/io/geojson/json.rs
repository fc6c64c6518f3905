//! Serde's visitors, cut down to what JSON has, and a reader that knows where it is.

use core::cell::Cell;
use core::fmt;
use core::mem;
use core::ops::Range;
use std::io::{self, Read};

use serde::de::{DeserializeSeed, Deserializer, Error, IgnoredAny, MapAccess, SeqAccess, Visitor};
use serde_json::Number;

use super::error::Place;

/// One way to take a JSON value. What an implementation does not take, it is told of by [`Value::other`], and the value
/// is skipped without recursion and without memory in proportion to its size.
pub(super) trait Value: Sized {
    type Out;

    /// Any kind of value without a method of its own below.
    fn other(self) -> Self::Out;

    fn null(self) -> Self::Out {
        self.other()
    }

    fn number(self, _: &Number) -> Self::Out {
        self.other()
    }

    fn text(self, _: &str) -> Self::Out {
        self.other()
    }

    fn array<'de, A: SeqAccess<'de>>(self, mut array: A) -> Result<Self::Out, A::Error> {
        let out = self.other();
        skip_array(&mut array)?;
        Ok(out)
    }

    fn object<'de, A: MapAccess<'de>>(self, mut object: A) -> Result<Self::Out, A::Error> {
        let out = match object.next_key_seed(Any(IsNumber))? {
            // With the feature `arbitrary_precision`, which any crate of a program can turn on for all of them,
            // `serde_json` hands over numbers as objects with this one member.
            Some(true) => match object.next_value_seed(Any(Text))?.and_then(|digits| digits.parse().ok()) {
                Some(number) => self.number(&number),
                None => self.other(),
            },
            Some(false) => {
                let out = self.other();
                object.next_value::<IgnoredAny>()?;
                out
            }
            None => self.other(),
        };
        skip_object(&mut object)?;
        Ok(out)
    }
}

/// Lends serde's traits to a [`Value`].
pub(super) struct Any<T>(pub(super) T);

impl<'de, T: Value> DeserializeSeed<'de> for Any<T> {
    type Value = T::Out;

    fn deserialize<D: Deserializer<'de>>(self, deserializer: D) -> Result<T::Out, D::Error> {
        deserializer.deserialize_any(self)
    }
}

impl<'de, T: Value> Visitor<'de> for Any<T> {
    type Value = T::Out;

    fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str("a JSON value")
    }

    fn visit_unit<E>(self) -> Result<T::Out, E> {
        Ok(self.0.null())
    }

    fn visit_bool<E>(self, _: bool) -> Result<T::Out, E> {
        Ok(self.0.other())
    }

    fn visit_u64<E>(self, value: u64) -> Result<T::Out, E> {
        Ok(self.0.number(&value.into()))
    }

    fn visit_i64<E>(self, value: i64) -> Result<T::Out, E> {
        Ok(self.0.number(&value.into()))
    }

    fn visit_f64<E: Error>(self, value: f64) -> Result<T::Out, E> {
        Number::from_f64(value).map(|number| self.0.number(&number)).ok_or_else(|| E::custom("not finite"))
    }

    fn visit_str<E>(self, value: &str) -> Result<T::Out, E> {
        Ok(self.0.text(value))
    }

    fn visit_seq<A: SeqAccess<'de>>(self, array: A) -> Result<T::Out, A::Error> {
        self.0.array(array)
    }

    fn visit_map<A: MapAccess<'de>>(self, object: A) -> Result<T::Out, A::Error> {
        self.0.object(object)
    }
}

/// A string, or nothing.
pub(super) struct Text;

impl Value for Text {
    type Out = Option<String>;

    fn other(self) -> Self::Out {
        None
    }

    fn text(self, text: &str) -> Self::Out {
        Some(text.to_owned())
    }
}

/// A string, or a number as it would be written, or nothing.
pub(super) struct Label;

impl Value for Label {
    type Out = Option<String>;

    fn other(self) -> Self::Out {
        None
    }

    fn number(self, number: &Number) -> Self::Out {
        Some(number.to_string())
    }

    fn text(self, text: &str) -> Self::Out {
        Some(text.to_owned())
    }
}

/// Whether the key of an object's member says that the object stands for a number.
struct IsNumber;

impl Value for IsNumber {
    type Out = bool;

    fn other(self) -> bool {
        false
    }

    fn text(self, key: &str) -> bool {
        key == "$serde_json::private::Number"
    }
}

/// Skips the rest of an array.
pub(super) fn skip_array<'de, A: SeqAccess<'de>>(array: &mut A) -> Result<(), A::Error> {
    while array.next_element::<IgnoredAny>()?.is_some() {}
    Ok(())
}

/// Skips the rest of an object.
pub(super) fn skip_object<'de, A: MapAccess<'de>>(object: &mut A) -> Result<(), A::Error> {
    while object.next_entry::<IgnoredAny, IgnoredAny>()?.is_some() {}
    Ok(())
}

/// How far a text has been read. Shared by the reader, which moves on, and the visitors, which want to know.
pub(super) struct Progress {
    line: Cell<usize>,
    column: Cell<usize>,
    blank: Cell<bool>,
    ended: Cell<bool>,
}

impl Progress {
    pub(super) fn new() -> Self {
        Self { line: Cell::new(1), column: Cell::new(0), blank: Cell::new(true), ended: Cell::new(false) }
    }

    /// The last byte read.
    pub(super) fn at(&self) -> Place {
        Place { line: self.line.get(), column: self.column.get() }
    }

    /// Whether there was nothing but white space so far.
    pub(super) fn is_blank(&self) -> bool {
        self.blank.get()
    }

    /// Whether the end has been met.
    pub(super) fn is_ended(&self) -> bool {
        self.ended.get()
    }

    fn pass(&self, byte: u8) {
        if byte == b'\n' {
            self.line.set(self.line.get() + 1);
            self.column.set(0);
        } else {
            self.column.set(self.column.get() + 1);
        }
        if self.blank.get() {
            self.blank.set(matches!(byte, b' ' | b'\t' | b'\r' | b'\n'));
        }
    }
}

/// Hands out the bytes of a reader one at a time (which is how `serde_json` asks for them), keeps count of lines and
/// columns as `serde_json` does, and skips a byte order mark.
pub(super) struct Tracked<'p, R> {
    /// Nothing once it has ended or failed, so that nobody reads on behind that.
    reader: Option<R>,
    buffer: Box<[u8]>,
    /// The part of the buffer that is still to be handed out.
    unread: Range<usize>,
    /// Whether the first bytes have been looked at.
    started: bool,
    progress: &'p Progress,
}

impl<'p, R: Read> Tracked<'p, R> {
    pub(super) fn new(reader: R, progress: &'p Progress) -> Self {
        let buffer = vec![0; 1 << 14].into_boxed_slice();
        Self { reader: Some(reader), buffer, unread: 0..0, started: false, progress }
    }

    /// Gets at least one more byte of text from the reader, unless it has ended.
    #[cold]
    fn refill(&mut self) -> io::Result<()> {
        const MARK: &[u8] = b"\xEF\xBB\xBF";
        self.unread = 0..0;
        while let Some(reader) = &mut self.reader {
            match reader.read(&mut self.buffer[self.unread.end..]) {
                Ok(0) => self.reader = None,
                Ok(len) => self.unread.end = self.buffer.len().min(self.unread.end.saturating_add(len)),
                Err(error) if error.kind() == io::ErrorKind::Interrupted => continue,
                Err(error) => {
                    self.reader = None;
                    return Err(error);
                }
            }
            let text = &self.buffer[..self.unread.end];
            if !self.started && text.len() < MARK.len() && MARK.starts_with(text) {
                continue;
            }
            if !mem::replace(&mut self.started, true) && text.starts_with(MARK) {
                self.unread.start = MARK.len();
            }
            if !self.unread.is_empty() {
                return Ok(());
            }
            self.unread = 0..0;
        }
        Ok(())
    }
}

impl<R: Read> Read for Tracked<'_, R> {
    #[inline]
    fn read(&mut self, out: &mut [u8]) -> io::Result<usize> {
        if self.unread.is_empty() {
            self.refill()?;
        }
        let Some(slot) = out.first_mut() else { return Ok(0) };
        let Some(&byte) = self.buffer[self.unread.clone()].first() else {
            self.progress.ended.set(true);
            return Ok(0);
        };
        self.unread.start += 1;
        *slot = byte;
        self.progress.pass(byte);
        Ok(1)
    }
}
