"""Audits of geometries, meshes and files."""

from __future__ import annotations

import json
import os
import sys
from collections.abc import Iterable, Sequence
from pathlib import Path
from typing import Any

import numpy as np
import numpy.typing as npt

from . import _twinedge
from ._report import Report
from ._validate import _asked, _count

_MESHES = {".obj", ".off", ".ply", ".stl"}
_MAPS = {".wkt": "wkt", ".geojson": "geojson", ".json": "geojson"}


def _offsets(lengths: Iterable[int]) -> npt.NDArray[np.uint32]:
    return np.concatenate([[0], np.cumsum(np.fromiter(lengths, np.int64))]).astype(np.uint32)


def _corners(faces: Any) -> tuple[npt.NDArray[np.uint32], npt.NDArray[np.uint32]]:
    """The vertices of all faces in one array, and where each face begins."""
    if isinstance(faces, np.ndarray) and faces.dtype != object:
        if faces.ndim != 2:
            raise ValueError(f"faces: expected two dimensions, not the shape {faces.shape}")
        corners, offsets = faces.reshape(-1), np.arange(len(faces) + 1, dtype=np.uint32) * faces.shape[1]
        offsets = offsets.astype(np.uint32)
    else:
        listed = [list(face) for face in faces]
        corners = np.array([vertex for face in listed for vertex in face] or np.empty(0, np.int64))
        offsets = _offsets(map(len, listed))
    if corners.dtype.kind not in "iu":
        raise TypeError(f"faces: expected integers, not {corners.dtype}")
    if corners.size and (corners.min() < 0 or corners.max() >= 2**32):
        raise ValueError("faces: a vertex is negative or too large")
    return np.ascontiguousarray(corners, dtype=np.uint32), offsets


def audit_faces(
    faces: npt.NDArray[np.integer[Any]] | Sequence[Sequence[int]],
    vertices: int | None = None,
    *,
    sides: int | None = None,
    simple: bool = False,
    closed: bool = False,
    used: bool = False,
    components: int | None = None,
    borders: int | None = None,
    genus: int | None = None,
    list: int | None = None,
) -> Report:
    """Judge a mesh that is a list of faces: they are joined at their edges, and the result is validated.

    Parameters
    ----------
    faces : (f, k) integers, or a sequence of sequences
        The vertices of each face, in order.
    vertices : int, optional
        How many there are. Default: one more than the largest.
    sides, simple, closed, used, components, borders, genus, list
        As for :func:`twinedge.validate`. By default a mesh may have borders and any genus.

    Returns
    -------
    Report
        With :attr:`~Report.findings`: edges with more than two faces, vertices at which fans of faces touch, faces that repeat a
        vertex, and so on. Half-edge ``h`` of a violation is the side of face ``h // k`` that begins at its corner ``h % k``.

    Raises
    ------
    TypeError
        The vertices are no integers.
    ValueError
        A vertex is negative, or not less than ``vertices``.

    Notes
    -----
    Linear time and memory. The faces are copied before the interpreter lock is released.
    """
    corners, offsets = _corners(faces)
    count = _count("vertices", vertices)
    if count is None:
        count = int(corners.max()) + 1 if corners.size else 0
    asked = _asked(
        sides=sides, simple=simple, closed=closed, used=used, components=components, borders=borders, genus=genus, list=list
    )
    # Of the points only the number counts here.
    points = np.broadcast_to(np.zeros(3), (count, 3))
    return Report(_twinedge.audit_faces(points, corners, offsets, asked))


def _collection(layer: Any) -> str:
    """The geometries of anything that holds some, as a text in the form of GeoJSON: a feature for each, in order."""
    geometries = ",".join(f'{{"type":"Feature","properties":null,"geometry":{text}}}' for text in _geometries(layer))
    return f'{{"type":"FeatureCollection","features":[{geometries}]}}'


def _by_shapely(geometries: npt.NDArray[Any]) -> list[str] | None:
    """The texts of an array of nothing but shapely geometries, and of missing ones. Overwrites the array."""
    shapely = sys.modules.get("shapely")
    if shapely is None or not all(one is None or isinstance(one, shapely.Geometry) for one in geometries):
        return None
    # GEOS writes an empty ring as no JSON reader expects it.
    geometries[shapely.is_empty(geometries)] = None
    return ["null" if text is None else text for text in shapely.to_geojson(geometries)]


def _geometries(layer: Any) -> list[str]:
    if hasattr(layer, "geometry") and hasattr(layer, "columns"):
        layer = layer.geometry
    if hasattr(layer, "geom_type") and hasattr(layer, "__array__"):
        layer = np.asarray(layer)
    if isinstance(layer, (np.ndarray, list, tuple)) and len(layer):
        texts = _by_shapely(np.fromiter(layer, object, len(layer)))
        if texts is not None:
            return texts
    if isinstance(layer, dict) or hasattr(layer, "__geo_interface__"):
        found = layer if isinstance(layer, dict) else layer.__geo_interface__
        kind = found.get("type")
        if kind == "FeatureCollection":
            return [json.dumps(feature["geometry"]) for feature in found["features"]]
        return [json.dumps(found["geometry"] if kind == "Feature" else found)]
    if isinstance(layer, (str, bytes)):
        raise TypeError(f"cannot audit {type(layer).__name__}: give a path as pathlib.Path, or the name of a file that exists")
    try:
        several = [*layer]
    except TypeError:
        raise TypeError(
            f"cannot audit {type(layer).__name__}: expected a path, a frame or a sequence of geometries, or __geo_interface__"
        ) from None
    return [text for one in several for text in (["null"] if one is None else _geometries(one))]


def audit(
    layer: Any,
    *,
    format: str | None = None,
    coverage: bool = False,
    gap_width: float | None = None,
    sliver_area: float | None = None,
    snap: float | str | None = None,
    list: int | None = None,
    **expected: Any,
) -> Report:
    """Judge a map or a mesh.

    Of lines and polygons the planar map is built and every rule is checked on it, those about coordinates too: that edges meet
    at their ends only, that holes lie in the face that lists them. Overlaps, gaps, near misses, slivers and duplicates of the
    polygons, and polygons that are not valid by the OGC (rules C1 to C6), are :attr:`Report.findings`.

    Parameters
    ----------
    layer
        A GeoDataFrame or GeoSeries; a sequence of geometries; anything with ``__geo_interface__``, or the dictionary itself; a path
        to a map (GeoJSON, WKT) or a mesh (OBJ, OFF, PLY, STL); a ``trimesh.Trimesh``.
    format : str, optional
        ``"geojson"`` or ``"wkt"``. By default told by the name of the file, or by its content.
    coverage : bool
        What breaks C1 to C6 makes the map invalid.
    gap_width, sliver_area : float, optional
        How wide a near miss is at most, and a gap that is reported; how large a sliver is at most.
    snap : float or "auto", optional
        Cut segments where they meet, on a grid of cells that are at most so wide.
    list : int, optional
        The most violations, and the most findings, that are listed. Default: 1000.
    **expected
        Of a mesh: as for :func:`audit_faces`.

    Returns
    -------
    Report
        ``features`` of a violation or a finding are positions in the layer.

    Raises
    ------
    OSError
        A file cannot be read.
    TypeError
        The layer is nothing of these, or an argument is for meshes, or for maps, only.
    ValueError
        The file or the geometry is malformed.

    Notes
    -----
    O(n log n + k) for n segments and k places where boxes of segments meet. The interpreter lock is released while the map is
    built and judged, and signals are handled after that.
    """
    if isinstance(layer, (str, os.PathLike)) and not hasattr(layer, "__geo_interface__"):
        path = Path(layer)
        if isinstance(layer, str) and not path.exists():
            raise FileNotFoundError(f"{layer}: no such file")
        if path.suffix.lower() in _MESHES:
            _refuse(path.name, format=format, coverage=coverage, gap_width=gap_width, sliver_area=sliver_area, snap=snap)
            return Report(_twinedge.audit_mesh(path, _asked(list=list, **expected)))
        text, format = path.read_bytes(), format or _MAPS.get(path.suffix.lower())
    elif hasattr(layer, "faces") and hasattr(layer, "vertices") and not callable(layer.faces):
        _refuse("a mesh", format=format, coverage=coverage, gap_width=gap_width, sliver_area=sliver_area, snap=snap)
        return audit_faces(np.asarray(layer.faces), len(layer.vertices), list=list, **expected)
    else:
        text, format = _collection(layer).encode(), "geojson"
    if expected:
        raise TypeError(f"{next(iter(expected))}: this is for meshes, and the layer is a map")
    asked = {
        "coverage": bool(coverage),
        "gap_width": gap_width,
        "sliver_area": sliver_area,
        "snap": 0.0 if snap == "auto" else snap,
        "list": _twinedge.DEFAULT_LIST if list is None else _count("list", list),
    }
    if isinstance(snap, (int, float)) and not snap > 0:
        raise ValueError(f"snap: {snap} is neither 'auto' nor a positive number")
    return Report(_twinedge.audit_map(text, format, asked))


def _refuse(what: str, **given: Any) -> None:
    for name, value in given.items():
        if value not in (None, False):
            raise TypeError(f"{name}: this is for maps, and {what} is a mesh")
