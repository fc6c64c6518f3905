"""Audits of geometries, meshes and files."""

from __future__ import annotations

import json
import math
import os
import sys
from collections.abc import Iterable, Sequence
from pathlib import Path
from typing import Any

import numpy as np
import numpy.typing as npt

from . import _twinedge
from ._names import Names, Sides
from ._report import Report
from ._validate import _MOST, _asked, _count, _number, _refuse_masked

_MESHES = {".obj", ".off", ".ply", ".stl"}
#: The claims that may be made of a mesh.
_OF_MESHES = ("sides", "simple", "closed", "used", "components", "borders", "genus")
_MAPS = {".wkt": "wkt", ".geojson": "geojson", ".json": "geojson"}


def _offsets(lengths: Iterable[int]) -> npt.NDArray[np.uint32]:
    return np.concatenate([[0], np.cumsum(np.fromiter(lengths, np.int64))]).astype(np.uint32)


def _corners(faces: Any) -> tuple[npt.NDArray[np.uint32], npt.NDArray[np.uint32]]:
    """The vertices of all faces in one array, and where each face begins."""
    _refuse_masked("faces", faces)
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
    if corners.size and (corners.min() < 0 or corners.max() >= _MOST):
        at = int(np.flatnonzero((corners < 0) | (corners >= _MOST))[0])
        side = Sides(offsets)[at]
        raise ValueError(
            f"faces: face {side.face} has the vertex {corners[at]} at its corner {side.corner}, which is"
            f" {'negative' if corners[at] < 0 else 'too large'}"
        )
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
        vertex, and so on: ``vertices`` and ``faces`` of a finding are positions here. Half-edges are numbered side by side, face by
        face: number ``h`` of faces with ``k`` corners each is the side of face ``h // k`` that begins at its corner ``h % k``. Of faces
        with different numbers of corners, it is a side of the face before which at most ``h`` corners lie, the last such.
        ``report.name(record)`` says which in both cases, as ``Side(face=1, corner=2)``, and so does ``names`` of a violation::

            report = twinedge.audit_faces([[0, 1, 2, 3], [0, 2, 1]], closed=True)
            [violation.names for violation in report.violations]

    Raises
    ------
    TypeError
        The vertices are no integers, or in a masked array.
    ValueError
        A vertex is negative, or not less than ``vertices``; the message says of which face.

    Notes
    -----
    Linear time and memory. The faces are copied before the interpreter lock is released.
    """
    corners, offsets = _corners(faces)
    count = _count("vertices", vertices, _MOST)
    if count is None:
        count = int(corners.max()) + 1 if corners.size else 0
    asked = _asked(
        sides=sides, simple=simple, closed=closed, used=used, components=components, borders=borders, genus=genus, list=list
    )
    # Of the points only the number counts here.
    points = np.broadcast_to(np.zeros(3), (count, 3))
    return Report(_twinedge.audit_faces(points, corners, offsets, asked), {"half_edge": Sides(offsets)})


#: The text of a geometry with a coordinate that is NaN or infinite, of which JSON has none.
_NOT_FINITE = "NaN"


def _collection(layer: Any) -> tuple[str, list[int]]:
    """The geometries of anything that holds some, as a text in the form of GeoJSON: a feature for each, in order. Those that are not
    finite are left out, and their positions are returned."""
    texts = _geometries(layer)
    not_finite = [at for at, text in enumerate(texts) if text == _NOT_FINITE]
    for at in not_finite:
        texts[at] = "null"
    geometries = ",".join(f'{{"type":"Feature","properties":null,"geometry":{text}}}' for text in texts)
    return f'{{"type":"FeatureCollection","features":[{geometries}]}}', not_finite


def _text(geometry: Any) -> str:
    try:
        return json.dumps(geometry, allow_nan=False)
    except ValueError:
        # All other faults are raised here.
        json.dumps(geometry)
        return _NOT_FINITE


def _by_shapely(geometries: npt.NDArray[Any]) -> list[str] | None:
    """The texts of an array of nothing but shapely geometries, and of missing ones. Overwrites the array."""
    shapely = sys.modules.get("shapely")
    if shapely is None or not all(one is None or isinstance(one, shapely.Geometry) for one in geometries):
        return None
    # GEOS writes an empty ring as no JSON reader expects it.
    geometries[shapely.is_empty(geometries)] = None
    geometries = shapely.force_2d(geometries)
    coordinates, owners = shapely.get_coordinates(geometries, return_index=True)
    not_finite = np.unique(owners[~np.isfinite(coordinates).all(axis=1)])
    geometries[not_finite] = None
    texts = ["null" if text is None else text for text in shapely.to_geojson(geometries)]
    for at in not_finite:
        texts[at] = _NOT_FINITE
    return texts


def _labels(layer: Any, name: str | None) -> Names | None:
    """The labels of the features, if the layer has some: see `audit`."""
    if hasattr(layer, "index") and hasattr(layer, "geom_type"):
        return _labels_of_frame(layer, name)
    found = layer if isinstance(layer, dict) else getattr(layer, "__geo_interface__", {})
    if found.get("type") == "FeatureCollection":
        properties = [feature.get("properties") or {} for feature in found["features"]]
        labels = [p.get(name or "name", f.get("id")) for p, f in zip(properties, found["features"], strict=True)]
        if name is not None and not any(name in p for p in properties):
            raise ValueError(f"name: no feature has the property {name!r}")
        return labels if any(label is not None for label in labels) else None
    if name is not None:
        raise TypeError("name: this is for frames and for collections of features with properties")
    return None


def _labels_of_frame(layer: Any, name: str | None) -> Names | None:
    columns = getattr(layer, "columns", ())
    if name is not None:
        if name not in columns:
            raise ValueError(f"name: there is no column {name!r}; there are {', '.join(map(str, columns)) or 'none'}")
        return _listed(layer[name])
    labels = _listed(layer.index)
    if labels != [*range(len(layer))]:
        return labels
    return _listed(layer["name"]) if "name" in columns else None


def _listed(column: Any) -> Sequence[Any]:
    labels: Sequence[Any] = column.tolist()
    return labels


def _other(layer: Any) -> str | None:
    """Advises on the function to call for a known type that is no layer."""
    if hasattr(layer, "check_structure") and hasattr(layer, "_adj"):
        return "for the rotations of a PlanarEmbedding call twinedge.adapters.networkx"
    if hasattr(layer, "nodes") and hasattr(layer, "adj"):
        return "a graph lies nowhere: networkx.check_planarity gives a PlanarEmbedding, for twinedge.adapters.networkx"
    if hasattr(layer, "halfedge") and hasattr(layer, "face"):
        return "for a mesh of compas call twinedge.adapters.compas"
    if hasattr(layer, "graph") and hasattr(layer, "to_geometry"):
        return "give one mesh: scene.to_mesh() puts those of a scene together"
    if isinstance(layer, np.ndarray) and layer.dtype != object and layer.size:
        return "for the faces of a mesh call twinedge.audit_faces, for links twinedge.validate"
    if isinstance(layer, (int, np.integer)):
        return "for the faces of a mesh call twinedge.audit_faces, for links twinedge.validate"
    if hasattr(layer, "columns") and not hasattr(layer, "geometry"):
        return "the frame has no geometry: geopandas.GeoDataFrame(frame, geometry=…) gives it some"
    return None


def _refused(layer: Any, why: str | None = None) -> TypeError:
    what = "None" if layer is None else type(layer).__name__
    return TypeError(
        f"cannot audit {what}: {why or _other(layer) or 'expected a path, a frame or a sequence of geometries, or __geo_interface__'}"
    )


def _geometries(layer: Any) -> list[str]:
    if _other(layer):
        raise _refused(layer)
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
            return [_text(feature["geometry"]) for feature in found["features"]]
        return [_text(found["geometry"] if kind == "Feature" else found)]
    if isinstance(layer, (str, bytes)):
        raise _refused(layer, "give a path as pathlib.Path, or the name of a file that exists")
    try:
        several = [*layer]
    except TypeError:
        raise _refused(layer) from None
    return [text for one in several for text in (["null"] if one is None else _geometries(one))]


def audit(
    layer: Any,
    *,
    format: str | None = None,
    coverage: bool = False,
    gap_width: float | None = None,
    lake_width: float | None = None,
    accept_gaps: Iterable[Sequence[float]] | None = None,
    sliver_area: float | None = None,
    snap: float | str | None = None,
    name: str | None = None,
    list: int | None = None,
    **expected: Any,
) -> Report:
    """Judge a map or a mesh.

    Of lines and polygons the planar map is built and every rule is checked on it, those about coordinates too: that edges meet
    at their ends only, that holes lie in the face that lists them. Overlaps, gaps, near misses, slivers and duplicates of the
    polygons, those that are not valid by the OGC, and borders that lack vertices of each other (rules C1 to C7), are :attr:`Report.findings`. ``Report.to_frame`` has both.

    A geometry with a coordinate that is NaN or infinite is left out: it is a finding of C6, and the report is not valid. One that
    is missing or empty is in :attr:`Report.without_geometry`.

    Parameters
    ----------
    layer
        A GeoDataFrame or GeoSeries; a sequence of geometries; anything with ``__geo_interface__``, or the dictionary itself; a path
        to a map (GeoJSON, WKT) or a mesh (OBJ, OFF, PLY, STL); a ``trimesh.Trimesh``.
    format : str, optional
        ``"geojson"`` or ``"wkt"``. By default told by the name of the file, or by its content.
    coverage : bool
        What breaks C1 to C7 makes the map invalid.
    gap_width : float, optional
        How wide a near miss (C3) is at most, and a gap (C2) that is reported: **a wider gap is then taken as intended, and not
        reported**. Default: gaps of any width, and near misses up to a hundredth of the median length of the edges. The width of a gap
        is its *mean* width, twice its area by the length of its border: the width of a strip, but half of the side of a square.
    lake_width : float, optional
        How wide a gap is at most that is reported, where that is not ``gap_width``: wider ones are accepted, as lakes, and counted in
        :attr:`Report.wider_gaps`.
    accept_gaps : iterable of points, optional
        The gap around each of these points is accepted, whatever its width, and counted in :attr:`Report.accepted_gaps`. A point is
        ``(x, y)``.
    sliver_area : float, optional
        A part of a feature is a sliver (C4) if it is smaller than this, and thin: 4πA/P² is less than 0.2 for its area A and
        perimeter P. Default: a thousandth of the median area of all parts.
    snap : float or "auto", optional
        Cut segments where they meet, on a grid of cells that are at most so wide.
    name : str, optional
        The column, or the property of features, that has their labels. By default the index of a frame or series, if it is not just
        0, 1, 2, …; else the column or property ``name``, if there is one, or the ``id`` of a feature. The features of a file have the
        names that the file gives them (``name``, ``NAME``, ``ADMIN``, ``title`` or ``id``).
    list : int, optional
        The most violations, and the most findings, that are listed. Default: 1000.
    **expected
        Of a mesh: as for :func:`audit_faces`.

    Returns
    -------
    Report
        ``features`` of a violation or a finding are positions in the layer, ``labels`` their labels. Of a mesh, see
        :func:`audit_faces`.

    Raises
    ------
    OSError
        A file cannot be read.
    TypeError
        The layer is nothing of these (the message says what to call instead), or an argument is for meshes, or for maps, only.
    ValueError
        The file or the geometry is malformed; a width, an area or ``snap`` is negative or not finite; there is no column ``name``.

    Notes
    -----
    O(n log n + k) for n segments and k places where boxes of segments meet. The interpreter lock is released while the map is
    built and judged, and signals are handled after that.
    """
    unknown = [argument for argument in expected if argument not in _OF_MESHES]
    if unknown:
        raise TypeError(f"audit() got an unexpected keyword argument {unknown[0]!r}")
    for_maps = {
        "format": format, "coverage": coverage, "gap_width": gap_width, "lake_width": lake_width, "accept_gaps": accept_gaps,
        "sliver_area": sliver_area, "snap": snap, "name": name,
    }
    labels: Names | None = None
    not_finite: Sequence[int] = ()
    if isinstance(layer, (str, os.PathLike)) and not hasattr(layer, "__geo_interface__"):
        path = Path(layer)
        if isinstance(layer, str) and not path.exists():
            raise FileNotFoundError(f"{layer}: no such file")
        if path.suffix.lower() in _MESHES:
            _refuse(path.name, **for_maps)
            report, offsets = _twinedge.audit_mesh(path, _asked(list=list, **expected))
            return Report(report, {"half_edge": Sides(offsets)})
        if name is not None:
            raise TypeError("name: this is for frames and for collections of features; those of a file have the names that it gives")
        text, format = path.read_bytes(), format or _MAPS.get(path.suffix.lower())
    elif hasattr(layer, "faces") and hasattr(layer, "vertices") and not callable(layer.faces):
        _refuse("this", **for_maps)
        return audit_faces(np.asarray(layer.faces), len(layer.vertices), list=list, **expected)
    else:
        collection, not_finite = _collection(layer)
        text, format = collection.encode(), "geojson"
        labels = _labels(layer, name)
    if expected:
        raise TypeError(f"{next(iter(expected))}: this is for meshes, and the layer is a map")
    asked = {
        "coverage": bool(coverage),
        "gap_width": _number("gap_width", gap_width),
        "lake_width": _number("lake_width", lake_width),
        "accepted_gaps": _points("accept_gaps", accept_gaps),
        "sliver_area": _number("sliver_area", sliver_area),
        "snap": _cell(snap),
        "list": _twinedge.DEFAULT_LIST if list is None else _count("list", list),
        "not_finite": not_finite,
    }
    document, found = _twinedge.audit_map(text, format, asked)
    # The text that is made of a layer has no names.
    if any(one is not None for one in found):
        labels = found
    return Report(document, None if labels is None else {"feature": labels})


def _points(name: str, points: Iterable[Sequence[float]] | None) -> list[tuple[float, float]]:
    try:
        found = [(float(x), float(y)) for x, y in (() if points is None else points)]
    except TypeError as error:
        raise TypeError(f"{name}: expected points (x, y): {error}") from None
    except ValueError as error:
        raise ValueError(f"{name}: expected points (x, y): {error}") from None
    if not all(math.isfinite(number) for point in found for number in point):
        raise ValueError(f"{name}: a coordinate is not finite")
    return found


def _cell(snap: Any) -> float | None:
    """The size of a cell, 0 for one that is to be chosen."""
    if snap is None or isinstance(snap, str):
        if snap not in (None, "auto"):
            raise ValueError(f"snap: {snap!r} is neither 'auto' nor a positive number")
        return None if snap is None else 0.0
    size = _number("snap", snap)
    if not size:
        raise ValueError(f"snap: {snap} is neither 'auto' nor a positive number")
    return size


def _refuse(what: str, **given: Any) -> None:
    for name, value in given.items():
        # Not 0, which is a width.
        if value is not None and value is not False:
            raise TypeError(f"{name}: this is for maps, and {what} is a mesh")
