//! Columns in any kind of storage.

use super::columns::{Column, Labels};
use crate::NIL;

/// The columns of a certificate, in any kind of storage: [`Labels`] and [`Drawing`](super::Drawing) keep them in memory; others
/// may read them page by page from larger files.
///
/// The answers may be arbitrary. The checkers return even if answers change from call to call.
///
/// ```
/// use twinedge::validate::Table;
/// use twinedge_certificate::{Certificate, Column, Columns, Labels, Numbers};
///
/// /// The columns of a small certificate, in 16 bits.
/// struct Narrow(Vec<Vec<u16>>);
/// #[derive(Clone, Copy)]
/// struct NarrowColumn<'a>(&'a [u16]);
///
/// impl Columns for Narrow {
///     type Numbers<'a> = NarrowColumn<'a>;
///     fn column(&self, column: Column) -> NarrowColumn<'_> {
///         NarrowColumn(&self.0[column as usize])
///     }
/// }
/// impl Numbers for NarrowColumn<'_> {
///     fn count(self) -> usize {
///         self.0.len()
///     }
///     fn at(self, i: usize) -> Option<u32> {
///         let number = *self.0.get(i)?;
///         Some(if number == u16::MAX { u32::MAX } else { number.into() })
///     }
/// }
///
/// let edge: Table = "V 2 0 - 1 - H 2 0 1 1 1 0 1 0 0 0 0 B 1 0 h0 i0 F 1 - 1 0".parse()?;
/// let certificate = Certificate::new(&edge, &Labels::new(&edge)?)?;
/// let narrow = |column: Column| certificate.columns().column(column).iter().map(|number| *number as u16).collect();
/// let narrow = Narrow(Column::ALL.into_iter().map(narrow).collect());
/// let certificate = Certificate::from_columns(narrow).expect("its columns fit together");
/// assert_eq!(certificate.check(), Ok(()));
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub trait Columns {
    /// One column.
    type Numbers<'a>: Numbers
    where
        Self: 'a;

    /// Returns the numbers of a column; empty if the column is absent.
    fn column(&self, column: Column) -> Self::Numbers<'_>;

    /// Returns the number of points of a drawing.
    fn points(&self) -> usize {
        0
    }

    /// Returns the coordinates of a point of a drawing; `None` beyond the last.
    fn point(&self, _point: usize) -> Option<[i64; 2]> {
        None
    }
}

/// The numbers of one column of a certificate.
pub trait Numbers: Copy {
    /// Returns the length of the column.
    fn count(self) -> usize;

    /// Returns the number of a record; `None` beyond the last.
    fn at(self, i: usize) -> Option<u32>;
}

impl Numbers for &[u32] {
    #[inline(always)]
    fn count(self) -> usize {
        self.len()
    }
    #[inline(always)]
    fn at(self, i: usize) -> Option<u32> {
        self.get(i).copied()
    }
}

impl Columns for Labels {
    type Numbers<'a> = &'a [u32];

    #[inline(always)]
    fn column(&self, column: Column) -> &[u32] {
        self.column(column)
    }
}

impl<C: Columns> Columns for &C {
    type Numbers<'a>
        = C::Numbers<'a>
    where
        Self: 'a;

    #[inline(always)]
    fn column(&self, column: Column) -> Self::Numbers<'_> {
        (**self).column(column)
    }
    fn points(&self) -> usize {
        (**self).points()
    }
    #[inline(always)]
    fn point(&self, i: usize) -> Option<[i64; 2]> {
        (**self).point(i)
    }
}

pub(super) trait Entries: Columns {
    /// Returns the stored entry; nil beyond the end.
    #[inline(always)]
    fn number(&self, column: Column, i: usize) -> u32 {
        self.column(column).at(i).unwrap_or(NIL)
    }

    #[inline(always)]
    fn link(&self, column: Column, i: usize) -> Option<usize> {
        let number = self.number(column, i);
        (number != NIL).then_some(number as usize)
    }

    /// Returns the range of the face's list in the column of inner boundary components.
    fn list(&self, face: usize) -> (usize, usize) {
        let before = face.checked_sub(1).map_or(0, |before| self.number(Column::FaceEnd, before));
        (before as usize, self.number(Column::FaceEnd, face) as usize)
    }
}

impl<C: Columns> Entries for C {}
