//! Drawing with rounding.
