//! Features that are read, and meanwhile taken.
//!
//! ```text
//!   this thread      read ─► read ─► read ─► …      a million points ahead at most
//!                        ╲       ╲       ╲
//!   one of its own        take ─► take ─► take ─► …
//! ```

use twinedge::map::{Feature, Shape};
use twinedge_formats::layer::ReadError;

/// The number of points from which on a batch is handed over.
#[cfg(not(target_family = "wasm"))]
const BATCH: usize = 1 << 12;

/// The number of batches that wait to be taken, at most. One with more points has as many empty ones behind it.
#[cfg(not(target_family = "wasm"))]
const AHEAD: usize = 1 << 8;

/// Takes a feature, or refuses it.
pub(crate) type Take<'a> = dyn FnMut(Feature) -> Result<(), ReadError> + Send + 'a;

/// Reads features, and hands each to `take`, in order. The first error of the two that is met in this order ends it.
#[cfg(not(target_family = "wasm"))]
pub(crate) fn taken<R>(
    take: &mut Take<'_>,
    read: impl FnOnce(&mut dyn FnMut(Feature) -> Result<(), ReadError>) -> Result<R, ReadError>,
) -> Result<R, ReadError> {
    use std::sync::mpsc::sync_channel;
    use std::thread::{Builder, scope};

    scope(|scope| {
        let (sender, receiver) = sync_channel::<Vec<Feature>>(AHEAD);
        let all = move || receiver.into_iter().flatten().try_for_each(take);
        let taker = Builder::new().spawn_scoped(scope, all)?;
        let hand_over = |batch| sender.send(batch).map_err(|_| ReadError::Refused("a feature was refused".into()));
        let (mut batch, mut points) = (Vec::new(), 0);
        let read = read(&mut |feature| {
            points += 1 + feature.shapes.iter().map(points_of).sum::<usize>();
            batch.push(feature);
            if points < BATCH {
                return Ok(());
            }
            hand_over(std::mem::take(&mut batch))?;
            let of_large = std::mem::take(&mut points) / BATCH;
            (1..of_large).try_for_each(|_| hand_over(Vec::new()))
        });
        // What was read before an error may be refused.
        let last = hand_over(batch);
        drop(sender);
        taker.join().unwrap_or_else(|panic| std::panic::resume_unwind(panic))?;
        last.and(read)
    })
}

/// Reads features, and hands each to `take`, in order.
#[cfg(target_family = "wasm")]
pub(crate) fn taken<R>(
    take: &mut Take<'_>,
    read: impl FnOnce(&mut dyn FnMut(Feature) -> Result<(), ReadError>) -> Result<R, ReadError>,
) -> Result<R, ReadError> {
    read(take)
}

#[cfg(not(target_family = "wasm"))]
fn points_of(shape: &Shape) -> usize {
    match shape {
        Shape::Polygon(rings) => rings.iter().map(Vec::len).sum(),
        Shape::Line(points) => points.len(),
        Shape::Point(_) => 1,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A point at each of these places.
    fn points(at: impl Iterator<Item = u32>) -> impl Iterator<Item = Feature> {
        at.map(|x| Feature { shapes: vec![Shape::Point([f64::from(x), 0.0].into())], ..Feature::default() })
    }

    #[test]
    fn features_are_taken_in_the_order_in_which_they_are_read() {
        let mut names = Vec::new();
        let mut take = |feature: Feature| {
            names.extend(feature.name);
            Ok(())
        };
        let named = |number: usize| Feature { name: Some(number.to_string()), ..Feature::default() };
        let read = taken(&mut take, |each| (0..3 * BATCH).map(named).try_for_each(each));
        assert!(read.is_ok());
        assert_eq!(names, (0..3 * BATCH).map(|number| number.to_string()).collect::<Vec<_>>());
    }

    #[test]
    fn a_feature_is_refused_though_what_follows_cannot_be_read() {
        for following in [4, 10, 10_000] {
            let mut count = 0;
            let mut take = |_| {
                count += 1;
                if count == 5 { Err(ReadError::Refused("too many".into())) } else { Ok(()) }
            };
            let read: Result<(), _> = taken(&mut take, |each| {
                points(0..following).try_for_each(each)?;
                Err(ReadError::Empty)
            });
            let expected = if following < 5 { "the input is empty" } else { "too many" };
            assert_eq!(read.unwrap_err().to_string(), expected);
        }
    }

    #[test]
    fn reading_ends_when_a_feature_is_refused() {
        let mut read_on = 0;
        let mut take = |_| Err(ReadError::Refused("none".into()));
        let read = taken(&mut take, |each| points(0..).inspect(|_| read_on += 1).try_for_each(each));
        assert_eq!(read.unwrap_err().to_string(), "none");
        // No more are under way.
        assert!(read_on <= (AHEAD + 2) * BATCH, "{read_on}");
    }
}
