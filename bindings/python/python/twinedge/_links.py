"""Links in arrays, as columns for the validator."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

import numpy as np
import numpy.typing as npt

from . import _twinedge
from ._options import _MOST, _asked, _count, _refuse_masked
from ._report import Report

#: The types accepted as a column of links.
Links = npt.NDArray[np.integer[Any]] | Sequence[int]

#: The columns with an element for each half-edge.
_OF_HALF_EDGES = ("origin", "target", "twin", "next", "prev", "face")
_NATIVE = [np.dtype(t) for t in (np.int32, np.int64, np.uint32, np.uint64)]


def _links(name: str, value: Any) -> npt.NDArray[Any]:
    _refuse_masked(name, value)
    try:
        array = np.asarray(value)
    except ValueError as error:
        raise ValueError(f"{name}: {error}") from None
    if array.ndim != 1:
        raise ValueError(f"{name}: expected one dimension, not the shape {array.shape}")
    if array.dtype.kind not in "iu":
        if array.size == 0 and not isinstance(value, np.ndarray):
            return array.astype(np.int64)
        raise TypeError(f"{name}: expected integers, not {array.dtype}")
    return array


def _in_place(array: npt.NDArray[Any]) -> bool:
    return (
        array.dtype.isnative
        and array.dtype in _NATIVE
        and bool(array.flags.aligned)
        and array.strides[0] % array.itemsize == 0
    )


def _copied(array: npt.NDArray[Any]) -> npt.NDArray[np.int64]:
    """The same links with 64 bits: nil is −1, and what does not fit is −2, which dangles."""
    if array.dtype.kind == "i":
        return array.astype(np.int64)
    copy = array.astype(np.uint64)
    nil, large = array == np.iinfo(array.dtype).max, copy > np.uint64(np.iinfo(np.int64).max)
    signed = copy.astype(np.int64)
    signed[large] = -2
    signed[nil] = -1
    return signed


def _signed(array: npt.NDArray[Any]) -> npt.NDArray[Any]:
    """The same memory with a sign: nil is −1 then, and what is too large is negative, so it dangles."""
    return array.view(f"i{array.itemsize}") if array.dtype.kind == "u" else array


def _columns(given: dict[str, Any], *counts: int | None) -> dict[str, npt.NDArray[Any]]:
    """The arrays that are given, all of one type with a sign that is read in place."""
    arrays = {name: _links(name, value) for name, value in given.items() if value is not None}
    # This number of records needs the sign bit.
    is_large = any((count or 0) > 2**31 for count in (*counts, *map(len, arrays.values())))
    if len({array.dtype for array in arrays.values()}) > 1 or is_large or not all(map(_in_place, arrays.values())):
        return {name: _copied(array) for name, array in arrays.items()}
    return {name: _signed(array) for name, array in arrays.items()}


def _same_length(columns: dict[str, npt.NDArray[Any]]) -> None:
    lengths = {name: len(columns[name]) for name in _OF_HALF_EDGES if name in columns}
    if len({*lengths.values()}) > 1:
        listed = ", ".join(f"`{name}` {length}" for name, length in lengths.items())
        raise ValueError(f"the columns of half-edges differ in length: {listed}")


def judge(links: dict[str, Any], claims: dict[str, Any], vertices: int | None = None, faces: int | None = None) -> Report:
    """The report of the structure that columns make: see :func:`twinedge.validate`."""
    given = {name for name, column in links.items() if column is not None}
    if "next" not in given:
        raise TypeError("next is required: the half-edge that follows each one on its cycle")
    if ("origin" in given) == ("target" in given):
        raise TypeError("give either origin or target")
    if "face_half_edge" in given and "face" not in given:
        raise TypeError("face_half_edge: needs face")
    if faces is not None and "face" not in given:
        raise TypeError("faces: needs face")
    vertex_count, face_count = _count("vertices", vertices, _MOST), _count("faces", faces, _MOST)
    columns = _columns(links, vertex_count, face_count)
    _same_length(columns)
    return Report(_twinedge.validate(columns, vertex_count, face_count, _asked(**claims)))
