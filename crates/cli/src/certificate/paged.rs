//! The columns of a certificate, read from its folder page by page.

use crate::output::Failure;
use std::cell::{OnceCell, RefCell};
use std::fs::File;
use std::io::{self, Read, Seek, SeekFrom};
use std::path::{Path, PathBuf};
use twinedge_certificate::{Column, Columns, Numbers};
use twinedge_report::certificate::{POINT_FILES, file_name};

/// The number of entries on a page.
const PAGE: usize = 4096;

/// The columns, cached as far as memory permits.
pub(super) struct Paged {
    /// The columns by number; `None` for columns that the claim does not have.
    columns: Vec<Option<Numbered<4>>>,
    points: Option<[Numbered<8>; 2]>,
}

impl Paged {
    /// Opens the files of these columns. The cached pages take at most `memory` bytes, plus one page for each file.
    pub(super) fn open(folder: &Path, wanted: &[Column], has_points: bool, memory: u64) -> Result<Self, Failure> {
        let files = wanted.len() + if has_points { 2 * POINT_FILES.len() } else { 0 };
        let share = memory / files.max(1) as u64;
        let mut columns: Vec<_> = Column::ALL.iter().map(|_| None).collect();
        for column in wanted {
            columns[*column as usize] = Some(Numbered::open(folder.join(file_name(*column)), share)?);
        }
        let points = if has_points {
            let [x, y] = POINT_FILES.map(|name| Numbered::open(folder.join(name), 2 * share));
            let (x, y) = (x?, y?);
            if x.count != y.count {
                return Err(Failure(format!("{}: the columns of points have different lengths", folder.display())));
            }
            Some([x, y])
        } else {
            None
        };
        Ok(Self { columns, points })
    }

    /// Returns the error of the first page that could not be read. Then the check proves nothing about the certificate.
    pub(super) fn failure(self) -> Option<Failure> {
        let columns = self.columns.into_iter().flatten().find_map(|column| column.failure());
        columns.or_else(|| self.points?.into_iter().find_map(|column| column.failure()))
    }
}

/// A file of numbers of `BYTES` bytes each, the least significant first.
struct Numbered<const BYTES: usize> {
    path: PathBuf,
    file: File,
    count: usize,
    frames: RefCell<Vec<Frame<BYTES>>>,
    error: OnceCell<io::Error>,
}

/// Room for one page. Each page has its frame; if there are more pages than frames, pages share frames.
struct Frame<const BYTES: usize> {
    page: Option<usize>,
    numbers: Vec<[u8; BYTES]>,
}

impl<const BYTES: usize> Numbered<BYTES> {
    fn open(path: PathBuf, memory: u64) -> Result<Self, Failure> {
        let failed = |error: &dyn std::fmt::Display| Failure(format!("{}: {error}", path.display()));
        let file = File::open(&path).map_err(|error| failed(&error))?;
        let length = file.metadata().map_err(|error| failed(&error))?.len();
        if length % BYTES as u64 != 0 {
            return Err(failed(&"ends in the middle of a number"));
        }
        let count = usize::try_from(length / BYTES as u64).map_err(|_| failed(&"is too large"))?;
        let room = usize::try_from(memory / (PAGE * BYTES) as u64).unwrap_or(usize::MAX);
        let frames = count.div_ceil(PAGE).min(room).max(1);
        let frames = RefCell::new((0..frames).map(|_| Frame { page: None, numbers: Vec::new() }).collect());
        Ok(Self { path, file, count, frames, error: OnceCell::new() })
    }

    #[inline]
    fn get(&self, i: usize) -> Option<[u8; BYTES]> {
        let (page, place) = (i / PAGE, i % PAGE);
        let mut frames = self.frames.borrow_mut();
        let room = frames.len();
        let frame = frames.get_mut(page % room)?;
        if frame.page != Some(page) {
            self.load(page, frame)?;
        }
        frame.numbers.get(place).copied()
    }

    /// Reads a page. After an error, nothing is read any more, so that the check ends.
    #[cold]
    fn load(&self, page: usize, frame: &mut Frame<BYTES>) -> Option<()> {
        if self.error.get().is_some() || page >= self.count.div_ceil(PAGE) {
            return None;
        }
        frame.page = None;
        frame.numbers.resize(PAGE.min(self.count - page * PAGE), [0; BYTES]);
        let read = self.read(page, &mut frame.numbers);
        read.map_err(|error| self.error.set(error)).ok()?;
        frame.page = Some(page);
        Some(())
    }

    fn read(&self, page: usize, numbers: &mut [[u8; BYTES]]) -> io::Result<()> {
        let mut file = &self.file;
        file.seek(SeekFrom::Start((page * PAGE * BYTES) as u64))?;
        file.read_exact(numbers.as_flattened_mut())
    }

    fn failure(self) -> Option<Failure> {
        let error = self.error.into_inner()?;
        Some(Failure(format!("{}: {error}", self.path.display())))
    }
}

#[derive(Clone, Copy)]
pub(super) struct PagedColumn<'a>(Option<&'a Numbered<4>>);

impl Numbers for PagedColumn<'_> {
    fn count(self) -> usize {
        self.0.map_or(0, |column| column.count)
    }
    #[inline]
    fn at(self, i: usize) -> Option<u32> {
        self.0?.get(i).map(u32::from_le_bytes)
    }
}

impl Columns for Paged {
    type Numbers<'a> = PagedColumn<'a>;

    #[inline]
    fn column(&self, column: Column) -> PagedColumn<'_> {
        PagedColumn(self.columns.get(column as usize).and_then(Option::as_ref))
    }
    fn points(&self) -> usize {
        self.points.as_ref().map_or(0, |[x, _]| x.count)
    }
    #[inline]
    fn point(&self, i: usize) -> Option<[i64; 2]> {
        let [x, y] = self.points.as_ref()?;
        Some([i64::from_le_bytes(x.get(i)?), i64::from_le_bytes(y.get(i)?)])
    }
}
