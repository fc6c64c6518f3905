//! Buffers that JavaScript fills and reads.

/// The number of a buffer.
pub type Id = u32;

/// Buffers by their numbers. A number is reused once its buffer is taken.
#[derive(Debug, Default)]
pub struct Buffers(Vec<Option<Vec<u8>>>);

impl Buffers {
    /// Adds a buffer.
    ///
    /// # Panics
    /// If there are 2³² of them, for which there is no memory.
    pub fn add(&mut self, bytes: Vec<u8>) -> Id {
        let place = self.0.iter().position(Option::is_none).unwrap_or(self.0.len());
        if place == self.0.len() {
            self.0.push(None);
        }
        self.0[place] = Some(bytes);
        Id::try_from(place).expect("fewer than 2^32 buffers")
    }

    /// Returns the bytes of a buffer; empty if it does not exist.
    #[must_use]
    pub fn get(&self, id: Id) -> &[u8] {
        self.0.get(id as usize).and_then(Option::as_deref).unwrap_or_default()
    }

    /// Removes a buffer and returns it; empty if it does not exist.
    pub fn take(&mut self, id: Id) -> Vec<u8> {
        self.0.get_mut(id as usize).and_then(Option::take).unwrap_or_default()
    }
}
