"""The validator over arrays."""

from __future__ import annotations

import math
import sys
from collections.abc import Sequence
from typing import Any

import numpy as np
import numpy.typing as npt

from . import _twinedge
from ._report import Report

#: The types accepted as a column of links.
Links = npt.NDArray[np.integer[Any]] | Sequence[int]

#: The columns with an element for each half-edge.
_OF_HALF_EDGES = ("origin", "target", "twin", "next", "prev", "face")
_NATIVE = [np.dtype(t) for t in (np.int32, np.int64, np.uint32, np.uint64)]


#: The most records of a kind: a link has 32 bits in the validator, and two values are not positions.
_MOST = 2**32 - 2


def _refuse_masked(name: str, value: Any) -> None:
    if np.ma.isMaskedArray(value):
        raise TypeError(f"{name}: the mask of a masked array would not be read: give `{name}.filled(-1)`, or the array without mask")


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


def _count(name: str, value: Any, most: int = sys.maxsize) -> int | None:
    if value is None:
        return None
    if isinstance(value, (bool, np.bool_)) or not isinstance(value, (int, np.integer)):
        raise TypeError(f"{name}: expected a number, not {type(value).__name__}")
    if value < 0:
        raise ValueError(f"{name}: {value} is negative")
    if value > most:
        raise ValueError(f"{name}: {value} is more than {most:,}, the most that there can be")
    return int(value)


def _number(name: str, value: Any) -> float | None:
    """A length or an area."""
    if value is None:
        return None
    if isinstance(value, (bool, np.bool_)) or not isinstance(value, (int, float, np.integer, np.floating)):
        raise TypeError(f"{name}: expected a number, not {type(value).__name__}")
    if not 0 <= value < math.inf:
        raise ValueError(f"{name}: {value} is negative or not finite")
    return float(value)


def _asked(
    *,
    plane: bool = False,
    open: bool = False,
    preset: str | None = None,
    sides: int | None = None,
    simple: bool = False,
    closed: bool = False,
    used: bool = False,
    border_kept: bool = False,
    components: int | None = None,
    borders: int | None = None,
    genus: int | None = None,
    list: int | None = None,
) -> dict[str, Any]:
    if preset is not None and not isinstance(preset, str):
        raise TypeError(f"preset: expected a name, one of {', '.join(_twinedge.PRESETS)}, not {type(preset).__name__}")
    if plane and preset is not None:
        raise ValueError("plane: a preset says on which surface the structure lies")
    return {
        "plane": bool(plane),
        "open": bool(open),
        "preset": preset,
        "sides": _count("sides", sides),
        "simple": bool(simple),
        "closed": bool(closed),
        "used": bool(used),
        "border_kept": bool(border_kept),
        "components": _count("components", components),
        "borders": _count("borders", borders),
        "genus": _count("genus", genus),
        "list": _twinedge.DEFAULT_LIST if list is None else _count("list", list),
    }


def _of_mesh(mesh: Any, links: dict[str, Any], claims: dict[str, Any]) -> Report:
    """The report of the structure of a library."""
    from . import adapters
    from ._audit import _faces_of, audit_faces

    given = [name for name, value in links.items() if value is not None]
    if given:
        raise TypeError(f"{given[0]}: this is for links in arrays, and a mesh is given")
    asked = {name: value for name, value in claims.items() if value is not None and value is not False}
    if hasattr(mesh, "check_structure") and hasattr(mesh, "_adj"):
        return adapters.networkx(mesh, **asked)
    if hasattr(mesh, "halfedge") and hasattr(mesh, "face"):
        return adapters.compas(mesh, **asked)
    faces = _faces_of(mesh)
    if faces is None:
        what = "None" if mesh is None else type(mesh).__name__
        raise TypeError(f"cannot validate {what}: expected a mesh of trimesh, pyvista, meshio or compas, a networkx.PlanarEmbedding, or links as keywords")
    return audit_faces(*faces, **asked)


#: No mesh is given.
_NOTHING = object()


def validate(
    mesh: Any = _NOTHING,
    /,
    *,
    origin: Links | None = None,
    next: Links | None = None,
    twin: Links | None = None,
    target: Links | None = None,
    prev: Links | None = None,
    face: Links | None = None,
    leaving: Links | None = None,
    face_half_edge: Links | None = None,
    vertices: int | None = None,
    faces: int | None = None,
    plane: bool = False,
    open: bool = False,
    preset: str | None = None,
    sides: int | None = None,
    simple: bool = False,
    closed: bool = False,
    used: bool = False,
    border_kept: bool = False,
    components: int | None = None,
    borders: int | None = None,
    genus: int | None = None,
    list: int | None = None,
) -> Report:
    """Judge a half-edge structure whose links are columns of integers.

    By default it is to be a closed surface of any genus. A link is the position of a record; nil is −1, or the largest value of
    an unsigned type.

    Parameters
    ----------
    mesh : optional
        Instead of links: a mesh of trimesh, pyvista (``PolyData``), meshio or compas, or a ``networkx.PlanarEmbedding``. Of the first three it is
        what :func:`twinedge.audit_faces` says of its faces, of the others what their function in :mod:`twinedge.adapters` does.
    origin, target : (h,) integers
        The vertex where each half-edge starts, or ends: one of the two.
    next : (h,) integers
        The half-edge that follows on the same cycle.
    twin : (h,) integers, optional
        The other half-edge of the same edge. Without it, the twin of half-edge ``h`` is ``h ^ 1``.
    prev : (h,) integers, optional
        The half-edge that precedes on the same cycle.
    face : (h,) integers, optional
        The face to the left of each half-edge.
    leaving : (v,) integers, optional
        A half-edge that leaves each vertex.
    face_half_edge : (f,) integers, optional
        A half-edge of each face. Needs ``face``.
    vertices, faces : int, optional
        How many there are. By default the length of ``leaving`` and ``face_half_edge``, or one more than the largest link, but at most
        the number of half-edges.
    plane : bool
        It lies in the plane: every component has genus 0.
    open : bool
        Borders are legal: a half-edge may lack its twin or its face.
    preset : str, optional
        Instead of ``plane``: what a library promises, one of :data:`twinedge.PRESETS`. ``README.md`` has a table of their rules.
    sides, components, borders, genus : int, optional
        Every face has so many sides; there are so many components with an edge, border loops, handles (rules M3, M5, M6, M7).
    simple, closed, used, border_kept : bool
        There are no loops and parallel edges; there is no border; a half-edge leaves every vertex; a border vertex keeps a border
        half-edge (rules M2, M4, M1, M8).
    list : int, optional
        The most violations that are listed. All are counted. Default: 1000.

    Returns
    -------
    Report

    Raises
    ------
    TypeError
        A column is no array of integers, or a masked one; ``next`` is ``None``; ``origin`` and ``target`` are both given, or neither.
    ValueError
        A column has another length than there are records, or more than one dimension; a count is negative or too large.
    RuntimeError
        An array changed during the call. A change that is undone again is not noticed. Nothing worse happens.
    MemoryError
        There is not enough memory.
    KeyboardInterrupt
        Ctrl-C, or what else a signal handler raises, ends the validation.

    Notes
    -----
    O(h + v + f) time and memory. Arrays of one type among int32, int64, uint32 and uint64 are read where they lie, with any stride,
    and the interpreter lock is released. If types differ, or are others, or an array is not aligned or not in native byte order,
    copies with 64 bits are read. Other threads may write to the arrays meanwhile, at the cost of the error above; only
    ``ndarray.resize(…, refcheck=False)`` must not be called, since it frees memory that is in use.
    """
    if mesh is not _NOTHING:
        given = {
            "origin": origin, "next": next, "twin": twin, "target": target, "prev": prev, "face": face, "leaving": leaving,
            "face_half_edge": face_half_edge, "vertices": vertices, "faces": faces,
        }
        claims = {
            "plane": plane, "open": open, "preset": preset, "sides": sides, "simple": simple, "closed": closed, "used": used,
            "border_kept": border_kept, "components": components, "borders": borders, "genus": genus, "list": list,
        }
        return _of_mesh(mesh, given, claims)
    if next is None:
        raise TypeError("next is required: the half-edge that follows each one on its cycle")
    if (origin is None) == (target is None):
        raise TypeError("give either origin or target")
    if face_half_edge is not None and face is None:
        raise TypeError("face_half_edge: needs face")
    if faces is not None and face is None:
        raise TypeError("faces: needs face")
    vertex_count, face_count = _count("vertices", vertices, _MOST), _count("faces", faces, _MOST)
    links = {
        "origin": origin,
        "target": target,
        "twin": twin,
        "next": next,
        "prev": prev,
        "face": face,
        "leaving": leaving,
        "face_half_edge": face_half_edge,
    }
    columns = _columns(links, vertex_count, face_count)
    _same_length(columns)
    asked = _asked(
        plane=plane,
        open=open,
        preset=preset,
        sides=sides,
        simple=simple,
        closed=closed,
        used=used,
        border_kept=border_kept,
        components=components,
        borders=borders,
        genus=genus,
        list=list,
    )
    return Report(_twinedge.validate(columns, vertex_count, face_count, asked))
