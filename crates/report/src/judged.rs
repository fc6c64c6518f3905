//! The number and SHA-256 of the judged bytes.

use crate::verdict::Judged;
use sha2::{Digest as _, Sha256};
use std::cell::RefCell;
use std::io::{self, BufRead, Read};
use std::rc::Rc;

#[derive(Debug, Default)]
struct Count {
    digest: Sha256,
    bytes: u64,
}

impl Count {
    fn add(&mut self, bytes: &[u8]) {
        self.digest.update(bytes);
        self.bytes += bytes.len() as u64;
    }

    fn judged(self) -> Judged {
        let digits = self.digest.finalize().iter().fold(String::new(), |digits, byte| format!("{digits}{byte:02x}"));
        Judged { sha256: digits, bytes: self.bytes }
    }
}

impl Judged {
    /// Digests bytes in memory. O(bytes).
    #[must_use]
    pub fn of_bytes(bytes: &[u8]) -> Self {
        let mut count = Count::default();
        count.add(bytes);
        count.judged()
    }

    /// Digests all bytes of a reader. O(bytes).
    ///
    /// # Errors
    /// Returns the reader's errors.
    pub fn of(mut reader: impl BufRead) -> io::Result<Self> {
        let mut count = Count::default();
        loop {
            let bytes = reader.fill_buf()?;
            if bytes.is_empty() {
                return Ok(count.judged());
            }
            count.add(bytes);
            let length = bytes.len();
            reader.consume(length);
        }
    }
}

/// The digest of the bytes read through a [`Counted`] reader.
#[derive(Debug)]
pub struct Counter(Rc<RefCell<Count>>);

impl Counter {
    /// Returns the digest of the bytes read so far.
    #[must_use]
    pub fn judged(self) -> Judged {
        self.0.take().judged()
    }
}

/// A reader that digests the bytes it reads. On drop, it reads the remaining bytes.
#[derive(Debug)]
pub struct Counted<R: BufRead> {
    inner: R,
    count: Rc<RefCell<Count>>,
}

impl<R: BufRead> Counted<R> {
    /// Wraps a reader, and returns its counter.
    pub fn new(inner: R) -> (Self, Counter) {
        let count = Rc::new(RefCell::new(Count::default()));
        (Self { inner, count: Rc::clone(&count) }, Counter(count))
    }
}

impl<R: BufRead> Read for Counted<R> {
    fn read(&mut self, into: &mut [u8]) -> io::Result<usize> {
        let length = self.fill_buf()?.read(into)?;
        self.consume(length);
        Ok(length)
    }
}

impl<R: BufRead> BufRead for Counted<R> {
    fn fill_buf(&mut self) -> io::Result<&[u8]> {
        self.inner.fill_buf()
    }

    fn consume(&mut self, length: usize) {
        // All consumed bytes are in the buffer, so this reads nothing.
        if let Ok(bytes) = self.inner.fill_buf() {
            self.count.borrow_mut().add(&bytes[..length.min(bytes.len())]);
        }
        self.inner.consume(length);
    }
}

impl<R: BufRead> Drop for Counted<R> {
    fn drop(&mut self) {
        while let Ok(length @ 1..) = self.fill_buf().map(<[u8]>::len) {
            self.consume(length);
        }
    }
}

#[cfg(test)]
mod tests {
    use super::Counted;
    use crate::verdict::Judged;
    use std::io::Read as _;

    /// FIPS 180-2 lists the digest of `abc` as an example.
    #[test]
    fn what_nobody_reads_counts_and_nothing_counts_twice() {
        let abc = "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad";
        for read in 0..=3 {
            let (mut reader, counter) = Counted::new(&b"abc"[..]);
            reader.read_exact(&mut vec![0; read]).expect("there is so much");
            drop(reader);
            let judged = counter.judged();
            assert_eq!((&*judged.sha256, judged.bytes), (abc, 3), "{read}");
        }
        assert_eq!(Judged::of(&b"abc"[..]).expect("it is in memory").sha256, abc);
    }
}
