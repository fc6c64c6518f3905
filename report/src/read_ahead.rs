//! Features that are read ahead of whoever takes them.
//!
//! ```text
//!   this thread      read ─► read ─► read ─► …      a million points ahead, or one feature
//!                        ╲       ╲       ╲
//!   one of its own        take ─► take ─► take ─► …
//! ```

#[cfg(not(target_family = "wasm"))]
use std::sync::mpsc::{Receiver, SyncSender};
use twinedge::map::{Feature, Shape};
use twinedge_formats::layer::{Feature as LayerFeature, Line, ReadError, Shape as LayerShape};

/// The number of points from which on a batch is handed over.
#[cfg(not(target_family = "wasm"))]
const BATCH: usize = 1 << 12;

/// The number of batches that wait to be taken, at most. A larger batch counts as several: empty ones follow it.
#[cfg(not(target_family = "wasm"))]
const AHEAD: usize = 1 << 8;

/// Takes a feature, or refuses it. What it leaves is dropped.
pub(crate) type Take<'a, T = Feature> = dyn FnMut(&mut T) -> Result<(), ReadError> + Send + 'a;

/// Hands a feature on, unless one was refused.
pub(crate) type HandOn<'a, T> = dyn FnMut(T) -> Result<(), ReadError> + Send + 'a;

/// A feature that is read ahead.
pub(crate) trait Ahead: Send {
    /// The number of its points, where the feature itself, each of its shapes and each ring count as one, too.
    fn weight(&self) -> usize;
}

impl Ahead for Feature {
    fn weight(&self) -> usize {
        let of_shape = |shape: &Shape| match shape {
            Shape::Polygon(rings) => 1 + rings.iter().map(|ring| 1 + ring.len()).sum::<usize>(),
            Shape::Line(points) => 1 + points.len(),
            Shape::Point(_) => 1,
        };
        1 + self.shapes.iter().map(of_shape).sum::<usize>()
    }
}

impl Ahead for LayerFeature {
    fn weight(&self) -> usize {
        fn of(shape: &LayerShape) -> usize {
            let rings = |lines: &Vec<Line>| 1 + lines.iter().map(|line| 1 + line.len()).sum::<usize>();
            match shape {
                LayerShape::Point(_) => 1,
                LayerShape::MultiPoint(points) | LayerShape::Line(points) => 1 + points.len(),
                LayerShape::MultiLine(lines) | LayerShape::Polygon(lines) => rings(lines),
                LayerShape::MultiPolygon(polygons) => 1 + polygons.iter().map(rings).sum::<usize>(),
                LayerShape::Collection(geometries) => 1 + geometries.iter().map(|one| of(&one.shape)).sum::<usize>(),
                _ => 1,
            }
        }
        1 + self.attributes.len() + self.geometry.as_ref().map_or(0, |geometry| of(&geometry.shape))
    }
}

/// Reads features, and hands each to `take`, in order, on a thread of its own if one is to be had. The result is as if each were taken before
/// the next is read: if a feature is refused and what follows cannot be read, the error is that of the former.
#[cfg(not(target_family = "wasm"))]
pub(crate) fn read_ahead<T: Ahead, R>(
    take: &mut Take<'_, T>,
    read: impl FnOnce(&mut HandOn<'_, T>) -> Result<R, ReadError>,
) -> Result<R, ReadError> {
    use std::sync::mpsc::sync_channel;
    use std::thread::{Builder, scope};

    let ahead = scope(|scope| {
        let (sender, receiver) = sync_channel::<Vec<T>>(AHEAD);
        let (give_back, given_back) = sync_channel::<Vec<T>>(AHEAD);
        let taker = || {
            let give_back = give_back;
            receiver.into_iter().try_for_each(|mut batch| {
                batch.iter_mut().try_for_each(&mut *take)?;
                // If too many wait already, it is dropped here.
                let _ = give_back.try_send(batch);
                Ok(())
            })
        };
        let Ok(taker) = Builder::new().spawn_scoped(scope, taker) else { return Err(read) };
        let mut batches = Batches { sender, given_back, batch: Vec::new(), weight: 0 };
        let read = read(&mut |feature| batches.put(feature));
        // Features that were read before an error may be refused.
        let _ = batches.hand_over();
        drop(batches);
        let taken = taker.join().unwrap_or_else(|panic| std::panic::resume_unwind(panic));
        Ok(taken.and(read))
    });
    ahead.unwrap_or_else(|read| read(&mut |mut feature| take(&mut feature)))
}

/// What is handed over, and comes back.
#[cfg(not(target_family = "wasm"))]
struct Batches<T> {
    sender: SyncSender<Vec<T>>,
    /// Batches that were taken. What was allocated on a thread is freed on it, so that two do not wait for one another.
    given_back: Receiver<Vec<T>>,
    batch: Vec<T>,
    weight: usize,
}

#[cfg(not(target_family = "wasm"))]
impl<T: Ahead> Batches<T> {
    fn put(&mut self, feature: T) -> Result<(), ReadError> {
        self.given_back.try_iter().for_each(drop);
        self.weight += feature.weight();
        self.batch.push(feature);
        while self.weight >= BATCH {
            self.hand_over()?;
            self.weight -= BATCH;
        }
        Ok(())
    }

    /// The error is of no account: that of the taker, who is gone then, is returned.
    fn hand_over(&mut self) -> Result<(), ReadError> {
        let batch = std::mem::take(&mut self.batch);
        self.sender.send(batch).map_err(|_| ReadError::Refused("a feature was refused".into()))
    }
}

/// Reads features, and hands each to `take`, in order.
#[cfg(target_family = "wasm")]
pub(crate) fn read_ahead<T: Ahead, R>(
    take: &mut Take<'_, T>,
    read: impl FnOnce(&mut HandOn<'_, T>) -> Result<R, ReadError>,
) -> Result<R, ReadError> {
    read(&mut |mut feature| take(&mut feature))
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::sync::atomic::{AtomicUsize, Ordering};
    use twinedge::map::Shape;

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
            // Beside those that wait, one batch is taken, one is handed over, and one is not full.
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
}
