//! Shelves for the features of a map: in memory, or on disk by tile for maps larger than memory.

use std::borrow::Cow;
use std::fs::File;
use std::io::{self, BufRead as _, BufReader, BufWriter, Read, Seek as _, SeekFrom, Write as _};
use std::sync::{Mutex, PoisonError};
use twinedge_coverage::tile::{Cuts, Grid, Piece, Tile};
use twinedge_geometry::Point;
use twinedge_map::{Feature, Shape};
use twinedge_report::words::{grouped, plain};
use twinedge_report::{Division, InMemory, Shelf};

/// The greatest number of bytes to collect before writing, and the part of the memory for them.
const COLLECTED: u64 = 32 << 20;
const PART: u64 = 8;

const POLYGON: u8 = 0;
const LINE: u8 = 1;
const POINT: u8 = 2;

/// Features in unnamed files, which disappear when the program ends: first sequentially, then the pieces of each tile in stretches.
pub(crate) struct OnDisk {
    all: BufWriter<File>,
    by_tiles: Mutex<File>,
    /// The stretches of the file for each tile, as offset and length.
    stretches: Vec<Vec<(u64, usize)>>,
    /// The number of bytes to collect before writing.
    collects: usize,
}

/// Returns an empty shelf for a division: on disk if memory is limited.
pub(crate) fn shelf_for(division: Division) -> io::Result<Box<dyn Shelf>> {
    Ok(match division {
        Division::Within(bytes) => Box::new(OnDisk::new((bytes / PART).min(COLLECTED) as usize)?),
        Division::Across(_) => Box::<InMemory>::default(),
    })
}

/// Says on standard error if the program used more memory than it was given. Only Linux tells.
pub(crate) fn tell_excess(name: &str, division: Division) {
    let Division::Within(bytes) = division else { return };
    let status = std::fs::read_to_string("/proc/self/status").unwrap_or_default();
    let peak = status.lines().find_map(|line| line.strip_prefix("VmHWM:")?.trim().strip_suffix(" kB")?.parse().ok());
    let used: u64 = peak.unwrap_or(0) * 1024;
    if used > bytes {
        let [used, given] = [used, bytes].map(|bytes| grouped(bytes.div_ceil(1 << 20)));
        eprintln!("twinedge: {}: {used} MiB of memory were used, where --memory gives {given}", plain(name));
    }
}

impl OnDisk {
    /// Creates an empty shelf in the folder for temporary files.
    fn new(collects: usize) -> io::Result<Self> {
        let all = BufWriter::new(tempfile::tempfile()?);
        Ok(Self { all, by_tiles: Mutex::new(tempfile::tempfile()?), stretches: Vec::new(), collects })
    }

    /// Calls `show` for each feature, in order.
    fn read_all(&mut self, show: &mut dyn FnMut(&Feature) -> io::Result<()>) -> io::Result<()> {
        self.all.flush()?;
        let mut reader = BufReader::new(self.all.get_ref());
        reader.rewind()?;
        while !reader.fill_buf()?.is_empty() {
            show(&read_feature(&mut reader)?)?;
        }
        Ok(())
    }
}

/// The unwritten pieces of each tile, and the file to write them to.
struct Collected {
    tiles: Vec<Vec<u8>>,
    size: usize,
    most: usize,
    file: File,
    end: u64,
    stretches: Vec<Vec<(u64, usize)>>,
}

impl Collected {
    fn new(tiles: usize, most: usize) -> io::Result<Self> {
        let (tiles, stretches) = (vec![Vec::new(); tiles], vec![Vec::new(); tiles]);
        Ok(Self { tiles, size: 0, most, file: tempfile::tempfile()?, end: 0, stretches })
    }

    /// Adds a piece to a tile, and writes everything collected if it is too much.
    fn add(&mut self, tile: usize, bytes: &[u8]) -> io::Result<()> {
        put_length(bytes.len(), &mut self.tiles[tile])?;
        self.tiles[tile].extend(bytes);
        self.size += bytes.len();
        if self.size > self.most { self.write() } else { Ok(()) }
    }

    fn write(&mut self) -> io::Result<()> {
        self.size = 0;
        for (bytes, stretches) in self.tiles.iter_mut().zip(&mut self.stretches).filter(|(bytes, _)| !bytes.is_empty())
        {
            self.file.write_all(bytes)?;
            stretches.push((self.end, bytes.len()));
            self.end += bytes.len() as u64;
            *bytes = Vec::new();
        }
        Ok(())
    }
}

impl Shelf for OnDisk {
    fn put(&mut self, feature: Feature) -> io::Result<()> {
        self.all.write_all(&bytes(&feature)?)
    }

    fn each(&mut self, show: &mut dyn FnMut(&Feature)) -> io::Result<()> {
        self.read_all(&mut |feature| {
            show(feature);
            Ok(())
        })
    }

    fn file(&mut self, grid: &Grid, cuts: &Cuts) -> io::Result<()> {
        let mut collected = Collected::new(grid.len(), self.collects)?;
        let mut number = 0;
        self.read_all(&mut |feature| {
            for piece in cuts.pieces(grid, number, feature).map_err(io::Error::other)? {
                collected.add(piece.tile().0 as usize, &piece.to_bytes())?;
            }
            number += 1;
            Ok(())
        })?;
        collected.write()?;
        let Collected { file, stretches, .. } = collected;
        // This frees the space of the previous file.
        *self = Self { by_tiles: Mutex::new(file), stretches, ..Self::new(self.collects)? };
        Ok(())
    }

    fn of_tile(&self, tile: Tile) -> io::Result<Vec<Cow<'_, Piece>>> {
        let mut bytes = Vec::new();
        let mut file = self.by_tiles.lock().unwrap_or_else(PoisonError::into_inner);
        for (start, length) in self.stretches.get(tile.0 as usize).into_iter().flatten() {
            let before = bytes.len();
            bytes.resize(before + length, 0);
            file.seek(SeekFrom::Start(*start))?;
            file.read_exact(&mut bytes[before..])?;
        }
        drop(file);
        let (mut rest, mut pieces) = (&bytes[..], Vec::new());
        while !rest.is_empty() {
            let length = read_number(&mut rest)? as usize;
            let (piece, others) = rest.split_at_checked(length).ok_or(io::ErrorKind::UnexpectedEof)?;
            pieces.push(Cow::Owned(Piece::from_bytes(piece).map_err(io::Error::other)?));
            rest = others;
        }
        Ok(pieces)
    }
}

/// Encodes the shapes of a feature; numbers are little-endian.
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
    for point in points {
        put_point(*point, bytes);
    }
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
    use super::{Collected, OnDisk, Shelf as _};
    use std::borrow::Cow;
    use twinedge_coverage::tile::{Cuts, Grid};
    use twinedge_geometry::Point;
    use twinedge_map::{Feature, Shape};
    use twinedge_report::InMemory;

    #[test]
    fn features_and_their_pieces_come_back_as_they_were() {
        let hole = [[0.1, -0.0], [1e-100, 2.0], [3.0, 4.0]];
        let shapes = [
            Shape::polygon([[0.0, 0.0], [9.0, 0.0], [0.0, 9.0]]).hole(hole),
            Shape::line([[1.0, 1.0], [2.0, 2.0]]),
            Shape::Point(Point::new(7.0, -7.0)),
        ];
        let of = |shapes: &[Shape]| Feature { shapes: shapes.to_vec(), ..Feature::default() };
        let features = [of(&shapes), of(&[]), of(&shapes[1..])];
        // Each piece is written at once.
        let (mut shelf, mut in_memory) = (OnDisk::new(1).expect("there is room"), InMemory::default());
        for feature in &features {
            shelf.put(feature.clone()).expect("there is room");
            in_memory.put(feature.clone()).expect("there is room");
        }
        let mut seen = Vec::new();
        shelf.each(&mut |feature| seen.push(feature.clone())).expect("it was written");
        assert_eq!(seen, features);
        let grid = Grid::new([0.0, 0.0], [4.0, 4.0], 2, 2).expect("a grid");
        let cuts = Cuts::new(9.0).expect("finite");
        shelf.file(&grid, &cuts).expect("there is room");
        in_memory.file(&grid, &cuts).expect("there is room");
        for tile in grid.tiles() {
            let [these, those] = [shelf.of_tile(tile), in_memory.of_tile(tile)]
                .map(|found| found.expect("it was written").into_iter().map(Cow::into_owned).collect::<Vec<_>>());
            assert!(!these.is_empty() && these == those, "{tile}");
        }
    }

    #[test]
    fn a_large_feature_is_not_held_once_for_each_of_its_tiles() {
        let most = 1 << 10;
        let mut collected = Collected::new(5, most).expect("there is room");
        for tile in 0..5 {
            collected.add(tile, &vec![0; most / 4 * 3]).expect("there is room");
            let held: usize = collected.tiles.iter().map(Vec::len).sum();
            assert!(held <= most, "{held}");
        }
    }
}
