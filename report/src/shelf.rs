//! Places that keep the features of a map until its tiles are judged.

use std::borrow::Cow;
use std::io;
use twinedge_geometry::Point;
use twinedge_map::Feature;

/// A place that keeps the features of a map, and gives out those of a tile.
pub trait Shelf: Send + Sync {
    /// Keeps a feature, the next in order.
    ///
    /// # Errors
    /// That of the place.
    fn put(&mut self, feature: Feature) -> io::Result<()>;

    /// Shows all features, in order.
    ///
    /// # Errors
    /// That of the place.
    fn each(&mut self, show: &mut dyn FnMut(&Feature)) -> io::Result<()>;

    /// Files each feature under its tiles. `windows` has for each tile the corners of a box around all features that are to be filed under it.
    ///
    /// # Errors
    /// That of the place.
    fn file(&mut self, windows: &[[Point; 2]], tiles_of: &dyn Fn(&Feature) -> Vec<usize>) -> io::Result<()>;

    /// The features that were filed under a tile, with their numbers, in order, and perhaps others.
    ///
    /// # Errors
    /// That of the place.
    fn of_tile(&self, tile: usize) -> io::Result<Vec<(u32, Cow<'_, Feature>)>>;
}

/// Features in memory.
#[derive(Debug, Default)]
pub struct InMemory {
    features: Vec<Feature>,
    filed: Vec<Vec<u32>>,
}

impl InMemory {
    /// All features, in order.
    #[must_use]
    pub fn features(&self) -> &[Feature] {
        &self.features
    }

    /// All features, in order.
    #[must_use]
    pub fn into_features(self) -> Vec<Feature> {
        self.features
    }
}

impl Shelf for InMemory {
    fn put(&mut self, feature: Feature) -> io::Result<()> {
        self.features.push(feature);
        Ok(())
    }

    fn each(&mut self, show: &mut dyn FnMut(&Feature)) -> io::Result<()> {
        self.features.iter().for_each(show);
        Ok(())
    }

    fn file(&mut self, windows: &[[Point; 2]], tiles_of: &dyn Fn(&Feature) -> Vec<usize>) -> io::Result<()> {
        self.filed = vec![Vec::new(); windows.len()];
        for (number, feature) in (0..).zip(&self.features) {
            for tile in tiles_of(feature) {
                self.filed[tile].push(number);
            }
        }
        Ok(())
    }

    fn of_tile(&self, tile: usize) -> io::Result<Vec<(u32, Cow<'_, Feature>)>> {
        let filed = self.filed.get(tile).into_iter().flatten();
        Ok(filed.map(|number| (*number, Cow::Borrowed(&self.features[*number as usize]))).collect())
    }
}
