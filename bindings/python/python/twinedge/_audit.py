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
from ._names import Names, Sides
from ._options import _MOST, _accepted, _cell, _count, _grid, _limits, _mesh, _number, _refuse, _refuse_masked
from ._options import _text as _options
from ._report import Report

#: The most findings that the small picture of a report marks.
_DRAWN_FINDINGS = 300

_MESHES = {".obj", ".off", ".ply", ".stl"}


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
    vertices: int | npt.ArrayLike | None = None,
    *,
    sides: int | None = None,
    simple: bool = False,
    closed: bool = False,
    used: bool = False,
    components: int | None = None,
    borders: int | None = None,
    genus: int | None = None,
    no_zero_area: bool = False,
    no_crossings: bool = False,
    outward: bool = False,
    list: int | None = None,
) -> Report:
    """Judge a mesh that is a list of faces: they are joined at their edges, and the result is validated.

    Parameters
    ----------
    faces : (f, k) integers, or a sequence of sequences
        The vertices of each face, in order.
    vertices : int or (v, 3) floats, optional
        How many there are, or where they are. Default: one more than the largest.
    sides, simple, closed, used, components, borders, genus, list
        As for :func:`twinedge.validate`. By default a mesh may have borders and any genus.
    no_zero_area, no_crossings, outward : bool
        No face has all its corners on one line; faces meet in common corners and edges only; closed components face outwards, or inwards around
        a cavity (rules M9, M10, M11). These need the places of the vertices.

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
        A vertex is negative, or not less than ``vertices``; the message says of which face. M9, M10 or M11 is asked for without places.

    Notes
    -----
    Linear time and memory. The faces are copied before the interpreter lock is released.
    """
    corners, offsets = _corners(faces)
    in_space = {"no_zero_area": no_zero_area, "no_crossings": no_crossings, "outward": outward}
    if vertices is None:
        vertices = int(corners.max()) + 1 if corners.size else 0
    if np.ndim(vertices) == 0:
        for name, is_asked in in_space.items():
            if is_asked:
                raise ValueError(f"{name}: this is about the places of the vertices, which `vertices` gives as an array")
        count, points = _count("vertices", vertices, _MOST) or 0, None
    else:
        _refuse_masked("vertices", vertices)
        points = np.ascontiguousarray(vertices, dtype=float)
        count = len(points)
        if points.ndim != 2 or points.shape[1] != 3:
            raise ValueError(f"vertices: expected the shape (v, 3), not {points.shape}")
    claims = _mesh(
        sides=sides, simple=simple, closed=closed, used=used, components=components, borders=borders, genus=genus, **in_space
    )
    told = _twinedge.audit_faces(count, points, corners, offsets, _options(list, **claims))
    return Report._told(told, {"half_edge": Sides(offsets)})


#: The text of a geometry with a NaN or infinite coordinate, which JSON cannot hold.
_NOT_FINITE = "NaN"


def _source(layer: Any, labels: Names | None = None, columns: Sequence[str] = ()) -> dict[str, Any]:
    """The geometries of anything that holds some, as a text in the form of GeoJSON: a feature for each, in order, with its label as
    its id and with these columns. Those that are not finite are left out, and their positions are in it."""
    texts = _geometries(layer)
    not_finite = [at for at, text in enumerate(texts) if text == _NOT_FINITE]
    for at in not_finite:
        texts[at] = "null"
    ids = [""] * len(texts)
    if labels is not None and len(labels) == len(texts):
        ids = [_id(labels[at]) for at in range(len(texts))]
    properties = _properties(layer, columns) if columns else ["null"] * len(texts)
    features = ",".join(
        f'{{"type":"Feature",{name}"properties":{members},"geometry":{text}}}'
        for name, members, text in zip(ids, properties, texts, strict=True)
    )
    text = f'{{"type":"FeatureCollection","features":[{features}]}}'
    return _input("layer", text=text.encode(), format="geojson", not_finite=not_finite)


def _properties(layer: Any, columns: Sequence[str]) -> list[str]:
    """Some properties of each feature, in JSON. A missing value is null."""
    if hasattr(layer, "columns"):
        for name in columns:
            if name not in layer.columns:
                raise ValueError(f"parent_column: there is no column {name!r}; there are {', '.join(map(str, layer.columns))}")
        given = [layer[name].astype(object).where(layer[name].notna(), None).tolist() for name in columns]
        rows = [dict(zip(columns, row, strict=True)) for row in zip(*given, strict=True)]
    else:
        found = layer if isinstance(layer, dict) else getattr(layer, "__geo_interface__", {})
        if found.get("type") != "FeatureCollection":
            raise TypeError("parent_column: this is for frames, for collections of features with properties, and for files")
        rows = [feature.get("properties") or {} for feature in found["features"]]
    return [json.dumps({name: _property(row.get(name)) for name in columns}, default=str) for row in rows]


def _property(value: Any) -> Any:
    """The value of a property. pandas keeps integers as floats where one is missing."""
    return int(value) if isinstance(value, float) and value.is_integer() else value


def _input(
    name: str,
    path: Path | None = None,
    text: bytes | None = None,
    format: str | None = None,
    layer: str | None = None,
    not_finite: Sequence[int] = (),
) -> dict[str, Any]:
    """What the native functions read."""
    return {"name": name, "path": path, "text": text, "format": format, "layer": layer, "not_finite": not_finite}


def _id(label: Any) -> str:
    """The member ``id`` of a feature; none, if its label is missing."""
    if label is None or label != label:
        return ""
    return f'"id":{json.dumps(str(label))},'


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
    # GEOS writes an empty ring in a form that no JSON reader expects.
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
    edges: str | None = None,
    name: str | None = None,
    layer_name: str | None = None,
    accept: Any = None,
    timeout: float | None = None,
    list: int | None = None,
    sides: int | None = None,
    simple: bool = False,
    closed: bool = False,
    used: bool = False,
    components: int | None = None,
    borders: int | None = None,
    genus: int | None = None,
    no_zero_area: bool = False,
    no_crossings: bool = False,
    outward: bool = False,
    geodesic: bool = False,
    parent_column: str | None = None,
    explain: bool = False,
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
        to a map (GeoJSON, newline-delimited or not, TopoJSON, WKT, WKB; ``geopandas.read_file`` reads the others) or a mesh (OBJ, OFF, PLY, STL); a mesh of trimesh, pyvista or meshio.
    format : str, optional
        The extension of files of its format, as ``"geojson"`` or ``"wkt"``. By default told by the content, or the name of the file.
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
    edges : "straight" or "geodesic", optional
        Edges between longitudes and latitudes are straight on the map, which is the default, or arcs of great circles. Then widths are in
        metres and areas in square metres, antimeridian and poles are places like others, and C6 is not asked. Without ``snap``.
    name : str, optional
        The column, or the property of features, that has their labels. By default the index of a frame or series, if it is not just
        0, 1, 2, …; else the column or property ``name``, if there is one, or the ``id`` of a feature. The features of a file have the
        names that the file gives them (``name``, ``NAME``, ``ADMIN``, ``title`` or ``id``). Ids of findings are made of labels.
    layer_name : str, optional
        The layer of a file with several.
    accept : path, dict or list, optional
        The findings of C1 to C7 that are accepted, as :meth:`Report.accept_all` made them: a file of JSON, or what was read of it. One that grew counts.
    timeout : float, optional
        So many seconds later the verdict is ``"unknown"``. What was begun ends by itself, on a thread that nobody waits for.
    list : int, optional
        The most violations, and the most findings of each rule, that are listed. Default: 1000; all, with ``accept``.
    sides, simple, closed, used, components, borders, genus, no_zero_area, no_crossings, outward
        Of a mesh: as for :func:`audit_faces`.
    geodesic : bool
        Lengths are in metres along geodesics, and areas in square metres; of longitudes and latitudes only. Limits stay in degrees.
    parent_column : str, optional
        Parts make up their parents exactly (X4): this column names the parent of each part, by its label, or as ``"COLUMN=KEY"`` by its column ``KEY``.
    explain : bool
        ``cause`` and ``remedy`` of each violation and finding are in the report's JSON.

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
        The file or the geometry is malformed; a width, an area or ``snap`` is negative or not finite; ``edges`` is another word, or the
        coordinates are no longitudes and latitudes; there is no column ``name``.

    Notes
    -----
    O(n log n + k) for n segments and k places where boxes of segments meet. The work is that of the program, on a thread of its own
    without the interpreter lock. Ctrl-C ends the call.
    """
    expected: dict[str, Any] = {
        "sides": sides, "simple": simple, "closed": closed, "used": used, "components": components, "borders": borders, "genus": genus,
        "no_zero_area": no_zero_area, "no_crossings": no_crossings, "outward": outward,
    }
    for_maps = {
        "format": format, "coverage": coverage, "gap_width": gap_width, "lake_width": lake_width, "accept_gaps": accept_gaps,
        "sliver_area": sliver_area, "snap": snap, "edges": edges, "name": name, "layer_name": layer_name, "accept": accept, "timeout": timeout,
        "geodesic": geodesic, "parent_column": parent_column,
    }
    if parent_column is not None and not isinstance(parent_column, str):
        raise TypeError(f"parent_column: expected a name, or 'COLUMN=KEY', not {type(parent_column).__name__}")
    labels: Names | None = None
    crs: Any = None
    file = isinstance(layer, (str, os.PathLike)) and not hasattr(layer, "__geo_interface__")
    if file:
        path = Path(layer)
        if not path.exists():
            raise FileNotFoundError(f"{layer}: no such file")
        if path.suffix.lower() in _MESHES:
            _refuse(path.name, **for_maps)
        source = _input(str(layer), path=path, format=format, layer=layer_name)
    else:
        faces = _faces_of(layer)
        if faces is not None:
            _refuse("this", **for_maps)
            return audit_faces(*faces, list=list, **expected)
        labels = _labels(layer, name)
        source = _source(layer, labels, [] if parent_column is None else [name for name in parent_column.split("=", 1) if name])
        crs = getattr(layer, "crs", None)
    if not (file and path.suffix.lower() in _MESHES):
        for argument, value in expected.items():
            if value is not None and value is not False:
                raise TypeError(f"{argument}: this is for meshes, and the layer is a map")
    asked = _options(
        list, coverage=bool(coverage), **_limits(gap_width, lake_width, accept_gaps, sliver_area), snap=_grid(snap), edges=edges,
        name_from=name if file else None, geodesic=bool(geodesic), parent_column=parent_column, explain=bool(explain),
        allow_empty=not file, **_mesh(**expected),
    )
    told, offsets = _twinedge.audit(source, asked, _accepted(accept), _number("timeout", timeout))
    names: dict[str, Any] = {}
    if offsets is not None:
        names["half_edge"] = Sides(offsets)
    elif labels is not None:
        names["feature"] = labels
    report = Report._told(told, names, crs=crs)
    if offsets is None:
        report._picture = lambda: _twinedge.build_map(source, _cell(snap)).svg(300.0, False, None, False, _DRAWN_FINDINGS)
    return report


def _faces_of(mesh: Any) -> tuple[Any, Any] | None:
    """The faces and the places of the vertices of a mesh of trimesh, pyvista or meshio; ``None`` for anything else."""
    if hasattr(mesh, "faces") and hasattr(mesh, "vertices") and not callable(mesh.faces):
        return np.asarray(mesh.faces), _places(mesh.vertices)
    # Of pyvista: a PolyData keeps the number of corners before the corners of each face.
    if hasattr(mesh, "irregular_faces") and hasattr(mesh, "n_points"):
        return [*mesh.irregular_faces], _places(mesh.points)
    # Of meshio: blocks of cells of one type each; blocks of dimension 2 are faces.
    if isinstance(getattr(mesh, "cells", None), list) and hasattr(mesh, "points") and hasattr(mesh, "cells_dict"):
        blocks = [block for block in mesh.cells if block.dim == 2]
        faces = [face for block in blocks for face in np.asarray(block.data)[:, : _corner_count(block.type)].tolist()]
        return faces, _places(mesh.points)
    return None


def _places(points: Any) -> Any:
    """The points in space, or their number if they have another dimension."""
    places = np.asarray(points, dtype=float)
    return places if places.ndim == 2 and places.shape[1] == 3 else len(places)


def _corner_count(kind: str) -> int | None:
    """The number of corners of a face of meshio, whose further nodes lie on its sides and inside."""
    return 3 if kind.startswith("triangle") else 4 if kind.startswith("quad") else None
