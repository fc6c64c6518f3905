//! Features are read ahead of their consumer.
//!
//! ```text
//!   this thread      read ─► read ─► read ─► …      a million points ahead, or one feature, and as many that come back to be freed
//!                        ╲       ╲       ╲
//!   one of its own        take ─► take ─► take ─► …
//! ```

use super::{HandOn, Take};
use std::sync::mpsc::{Receiver, SyncSender, sync_channel};
use std::thread::{Builder, scope};
use twinedge_layers::ReadError;
use twinedge_map::{Feature, Shape};

/// The number of points that fills a batch.
const BATCH: usize = 1 << 12;

/// The maximal number of waiting batches. A larger batch counts as several: empty batches follow it.
const AHEAD: usize = 1 << 8;

/// The number of bytes with the weight of a point.
const POINT: usize = 16;

/// Returns the number of points, plus one for the feature itself, each shape and ring, and each piece of text.
fn weight(feature: &Feature) -> usize {
    let of_shape = |shape: &Shape| match shape {
        Shape::Polygon(rings) => 1 + rings.iter().map(|ring| 1 + ring.len()).sum::<usize>(),
        Shape::Line(points) => 1 + points.len(),
        Shape::Point(_) => 1,
    };
    let texts = feature.name.iter().chain(&feature.id).map(|text| text.len() / POINT);
    1 + texts.sum::<usize>() + feature.shapes.iter().map(of_shape).sum::<usize>()
}

/// Reads features and hands each to `take`, in order, on a separate thread if possible. The result is as if each feature were taken before the next
/// is read: if a feature is refused and a later one cannot be read, the error is the refusal.
pub(crate) fn read_ahead<R>(
    take: &mut Take<'_>,
    read: impl FnOnce(&mut HandOn<'_>) -> Result<R, ReadError>,
) -> Result<R, ReadError> {
    let ahead = scope(|scope| {
        let (sender, receiver) = sync_channel::<Vec<Feature>>(AHEAD);
        let (give_back, given_back) = sync_channel::<Vec<Feature>>(AHEAD);
        let taker = || {
            let give_back = give_back;
            receiver.into_iter().try_for_each(|mut batch| {
                batch.iter_mut().try_for_each(&mut *take)?;
                // If too many batches wait already, this one is dropped here.
                let _ = give_back.try_send(batch);
                Ok(())
            })
        };
        let Ok(taker) = Builder::new().spawn_scoped(scope, taker) else { return Err(read) };
        let mut batches = Batches { sender, given_back, batch: Vec::new(), weight: 0 };
        let read = read(&mut |feature| batches.put(feature));
        // The features read before an error may still be refused.
        let _ = batches.hand_over();
        drop(batches);
        let taken = taker.join().unwrap_or_else(|panic| std::panic::resume_unwind(panic));
        Ok(taken.and(read))
    });
    ahead.unwrap_or_else(|read| read(&mut |mut feature| take(&mut feature)))
}

/// Features that are handed over and come back.
struct Batches {
    sender: SyncSender<Vec<Feature>>,
    /// Batches that come back: memory is freed on the thread that allocated it, so that the threads do not wait for each other.
    given_back: Receiver<Vec<Feature>>,
    batch: Vec<Feature>,
    weight: usize,
}

impl Batches {
    fn put(&mut self, feature: Feature) -> Result<(), ReadError> {
        self.given_back.try_iter().for_each(drop);
        self.weight += weight(&feature);
        self.batch.push(feature);
        while self.weight >= BATCH {
            self.hand_over()?;
            self.weight -= BATCH;
        }
        Ok(())
    }

    /// Hands over the current batch. Ignore its error: the taker is gone then, and its own error is returned.
    fn hand_over(&mut self) -> Result<(), ReadError> {
        let batch = std::mem::take(&mut self.batch);
        self.sender.send(batch).map_err(|_| ReadError::Refused("a feature was refused".into()))
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::sync::atomic::{AtomicUsize, Ordering};

    fn named(number: usize) -> Feature {
        Feature { name: Some(number.to_string()), ..Feature::default() }
    }

    #[test]
    fn features_are_taken_in_the_order_in_which_they_are_read() {
        let mut names = Vec::new();
        let mut take = |feature: &mut Feature| {
            names.extend(feature.name.take());
            Ok(())
        };
        let read = read_ahead(&mut take, |each| (0..3 * BATCH).map(named).try_for_each(each));
        assert!(read.is_ok());
        assert_eq!(names, (0..3 * BATCH).map(|number| number.to_string()).collect::<Vec<_>>());
    }

    #[test]
    fn a_feature_is_refused_though_what_follows_cannot_be_read() {
        for following in [4, 10, 10_000] {
            let mut count = 0;
            let mut take = |_: &mut Feature| {
                count += 1;
                if count == 5 { Err(ReadError::Refused("too many".into())) } else { Ok(()) }
            };
            let read: Result<(), _> = read_ahead(&mut take, |each| {
                (0..following).map(named).try_for_each(each)?;
                Err(ReadError::Empty)
            });
            let expected = if following < 5 { "the input is empty" } else { "too many" };
            assert_eq!(read.unwrap_err().to_string(), expected);
        }
    }

    #[test]
    fn reading_ends_when_a_feature_is_refused() {
        let mut take = |_: &mut Feature| Err(ReadError::Refused("none".into()));
        let read = read_ahead(&mut take, |each| (0..).map(named).try_for_each(each));
        assert_eq!(read.unwrap_err().to_string(), "none");
    }

    #[test]
    fn what_is_read_ahead_is_bounded() {
        let of_points = |ring: usize| vec![Shape::Polygon(vec![vec![[0.0, 0.0].into(); ring]])];
        let of_rings = |rings: usize| vec![Shape::Polygon(vec![Vec::new(); rings])];
        let (few, many, huge) = (10, 2 * BATCH - 4, 10 * BATCH);
        let each = [few, many, huge].map(|points| (of_points(points), points + 3));
        for (shapes, weight) in each.into_iter().chain([(of_rings(few), few + 2)]) {
            let feature = Feature { shapes, ..Feature::default() };
            let ahead = AtomicUsize::new(0);
            // Apart from the waiting batches, one is being taken, one handed over, and one filled.
            let most = (AHEAD + 3) * BATCH / weight + 1;
            let mut take = |_: &mut Feature| {
                std::thread::yield_now();
                let now = ahead.fetch_sub(1, Ordering::SeqCst);
                if now > most { Err(ReadError::Refused(format!("{now} of {most}").into())) } else { Ok(()) }
            };
            let read = read_ahead(&mut take, |each| {
                (0..4 * most).try_for_each(|_| {
                    ahead.fetch_add(1, Ordering::SeqCst);
                    each(feature.clone())
                })
            });
            assert!(read.is_ok(), "{read:?}");
        }
    }

    #[test]
    fn all_that_takes_memory_weighs() {
        let long = Some("x".repeat(100 * POINT));
        assert_eq!(weight(&Feature { name: long.clone(), id: long, ..Feature::default() }), 201);
    }
}
