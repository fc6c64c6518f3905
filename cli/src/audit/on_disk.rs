//! The features of a map on disk, tile by tile, for maps that are larger than memory.

use std::borrow::Cow;
use std::fs::{File, OpenOptions, remove_file};
use std::io::{self, BufRead as _, BufReader, BufWriter, Read, Write as _};
use std::path::PathBuf;
use tempfile::TempDir;
use twinedge::geometry::Point;
use twinedge::map::{Feature, Shape};
use twinedge_report::Shelf;

/// The number of bytes that are collected before they are written to the files of their tiles.
const COLLECTED: usize = 32 << 20;

const POLYGON: u8 = 0;
const LINE: u8 = 1;
const POINT: u8 = 2;

/// Features in files of a folder of its own, which goes with it: first all in one, then those of each tile in one.
pub(super) struct OnDisk {
    folder: TempDir,
    all: Option<BufWriter<File>>,
}

impl OnDisk {
    /// Nothing yet, in the folder for temporary files.
    pub(super) fn new() -> io::Result<Self> {
        let folder = tempfile::Builder::new().prefix("twinedge-").tempdir()?;
        let all = Some(BufWriter::new(File::create_new(folder.path().join("all"))?));
        Ok(Self { folder, all })
    }

    fn path_of_all(&self) -> PathBuf {
        self.folder.path().join("all")
    }

    fn path(&self, tile: usize) -> PathBuf {
        self.folder.path().join(tile.to_string())
    }

    /// Shows all features in order, each with its bytes.
    fn read_all(&self, show: &mut dyn FnMut(&Feature, &[u8]) -> io::Result<()>) -> io::Result<()> {
        let mut reader = BufReader::new(File::open(self.path_of_all())?);
        while !reader.fill_buf()?.is_empty() {
            let feature = read_feature(&mut reader)?;
            show(&feature, &bytes(&feature)?)?;
        }
        Ok(())
    }

    fn append(&self, tile: usize, bytes: &mut Vec<u8>) -> io::Result<()> {
        OpenOptions::new().append(true).create(true).open(self.path(tile))?.write_all(bytes)?;
        *bytes = Vec::new();
        Ok(())
    }
}

impl Shelf for OnDisk {
    fn put(&mut self, feature: Feature) -> io::Result<()> {
        let bytes = bytes(&feature)?;
        self.all.as_mut().map_or(Ok(()), |all| all.write_all(&bytes))
    }

    fn each(&mut self, show: &mut dyn FnMut(&Feature)) -> io::Result<()> {
        self.all.as_mut().map_or(Ok(()), io::Write::flush)?;
        self.read_all(&mut |feature, _| {
            show(feature);
            Ok(())
        })
    }

    fn file(&mut self, tiles: usize, tiles_of: &dyn Fn(&Feature) -> Vec<usize>) -> io::Result<()> {
        // Nothing is put down any more.
        self.all.take().map_or(Ok(()), |mut all| all.flush())?;
        let mut collected: Vec<Vec<u8>> = vec![Vec::new(); tiles];
        let (mut size, mut number) = (0, 0_u32);
        self.read_all(&mut |feature, bytes| {
            for tile in tiles_of(feature) {
                collected[tile].extend(number.to_le_bytes());
                collected[tile].extend(bytes);
                size += bytes.len();
            }
            number += 1;
            if size > COLLECTED {
                size = 0;
                for (tile, bytes) in collected.iter_mut().enumerate().filter(|(_, bytes)| !bytes.is_empty()) {
                    self.append(tile, bytes)?;
                }
            }
            Ok(())
        })?;
        for (tile, bytes) in collected.iter_mut().enumerate() {
            self.append(tile, bytes)?;
        }
        remove_file(self.path_of_all())
    }

    fn of_tile(&self, tile: usize) -> io::Result<Vec<(u32, Cow<'_, Feature>)>> {
        let mut reader = BufReader::new(File::open(self.path(tile))?);
        let mut features = Vec::new();
        while !reader.fill_buf()?.is_empty() {
            let number = read_number(&mut reader)?;
            features.push((number, Cow::Owned(read_feature(&mut reader)?)));
        }
        Ok(features)
    }
}

/// The shapes of a feature. Numbers are little-endian.
fn bytes(feature: &Feature) -> io::Result<Vec<u8>> {
    let mut bytes = Vec::new();
    put_length(feature.shapes.len(), &mut bytes)?;
    for shape in &feature.shapes {
        match shape {
            Shape::Polygon(rings) => {
                bytes.push(POLYGON);
                put_length(rings.len(), &mut bytes)?;
                rings.iter().try_for_each(|ring| put_chain(ring, &mut bytes))?;
            }
            Shape::Line(points) => {
                bytes.push(LINE);
                put_chain(points, &mut bytes)?;
            }
            Shape::Point(point) => {
                bytes.push(POINT);
                put_point(*point, &mut bytes);
            }
        }
    }
    Ok(bytes)
}

fn put_length(length: usize, bytes: &mut Vec<u8>) -> io::Result<()> {
    let length = u32::try_from(length).map_err(|_| io::Error::other("a feature has 2^32 parts or more"))?;
    bytes.extend(length.to_le_bytes());
    Ok(())
}

fn put_chain(points: &[Point], bytes: &mut Vec<u8>) -> io::Result<()> {
    put_length(points.len(), bytes)?;
    points.iter().for_each(|point| put_point(*point, bytes));
    Ok(())
}

fn put_point(point: Point, bytes: &mut Vec<u8>) {
    bytes.extend(point.x.to_le_bytes());
    bytes.extend(point.y.to_le_bytes());
}

fn read_feature(reader: &mut impl Read) -> io::Result<Feature> {
    let shapes = (0..read_number(reader)?).map(|_| read_shape(reader)).collect::<io::Result<_>>()?;
    Ok(Feature { shapes, ..Feature::default() })
}

fn read_shape(reader: &mut impl Read) -> io::Result<Shape> {
    let mut kind = [0];
    reader.read_exact(&mut kind)?;
    Ok(match kind[0] {
        POLYGON => Shape::Polygon((0..read_number(reader)?).map(|_| read_chain(reader)).collect::<io::Result<_>>()?),
        LINE => Shape::Line(read_chain(reader)?),
        POINT => Shape::Point(read_point(reader)?),
        _ => return Err(io::ErrorKind::InvalidData.into()),
    })
}

fn read_chain(reader: &mut impl Read) -> io::Result<Vec<Point>> {
    (0..read_number(reader)?).map(|_| read_point(reader)).collect()
}

fn read_point(reader: &mut impl Read) -> io::Result<Point> {
    let [mut x, mut y] = [[0; 8]; 2];
    reader.read_exact(&mut x)?;
    reader.read_exact(&mut y)?;
    Ok(Point::new(f64::from_le_bytes(x), f64::from_le_bytes(y)))
}

fn read_number(reader: &mut impl Read) -> io::Result<u32> {
    let mut number = [0; 4];
    reader.read_exact(&mut number)?;
    Ok(u32::from_le_bytes(number))
}

#[cfg(test)]
mod tests {
    use super::{OnDisk, Shelf as _};
    use twinedge::geometry::Point;
    use twinedge::map::{Feature, Shape};

    #[test]
    fn features_come_back_by_tiles_as_they_were_and_leave_no_file() {
        let hole = [[0.1, -0.0], [1e-300, 2.0], [3.0, 4.0]];
        let shapes = [
            Shape::polygon([[0.0, 0.0], [9.0, 0.0], [0.0, 9.0]]).hole(hole),
            Shape::line([[1.0, 1.0], [2.0, 2.0]]),
            Shape::Point(Point::new(7.0, -7.0)),
        ];
        let of = |shapes: &[Shape]| Feature { shapes: shapes.to_vec(), ..Feature::default() };
        let features = [of(&shapes), of(&[]), of(&shapes[1..])];
        let mut shelf = OnDisk::new().expect("there is room");
        for feature in &features {
            shelf.put(feature.clone()).expect("there is room");
        }
        let mut seen = Vec::new();
        shelf.each(&mut |feature| seen.push(feature.clone())).expect("it was written");
        assert_eq!(seen, features);
        // The first in two tiles, the second in none.
        let tiles_of = |feature: &Feature| match feature.shapes.len() {
            3 => vec![0, 2],
            2 => vec![2],
            _ => Vec::new(),
        };
        shelf.file(3, &tiles_of).expect("there is room");
        let numbers = |tile: usize| {
            let of_tile = shelf.of_tile(tile).expect("it was written");
            assert!(of_tile.iter().all(|(number, feature)| **feature == features[*number as usize]));
            of_tile.iter().map(|(number, _)| *number).collect::<Vec<_>>()
        };
        assert_eq!([0, 1, 2].map(numbers), [vec![0], vec![], vec![0, 2]]);
        let folder = shelf.folder.path().to_owned();
        drop(shelf);
        assert!(!folder.exists());
    }
}
