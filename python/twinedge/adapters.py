"""The structures of other libraries, each by one function that validates it.

=================== ====================================================
:func:`networkx`    ``networkx.PlanarEmbedding``
:func:`compas`      ``compas.datastructures.Mesh``
:func:`trimesh`     ``trimesh.Trimesh``
:func:`shapely`     a sequence of shapely polygons, as a coverage
:func:`geopandas`   a GeoDataFrame or GeoSeries of polygons, as a coverage
=================== ====================================================

None of the libraries is imported here. The records of a report are positions in the arrays that :func:`networkx_columns` and
:func:`compas_columns` return; their ``half_edges`` and ``vertices`` give the names.
"""

from __future__ import annotations

from collections.abc import Sequence
from itertools import chain, repeat
from typing import Any, NamedTuple

import numpy as np
import numpy.typing as npt

from ._audit import audit, audit_faces
from ._report import Report
from ._validate import validate

__all__ = ["Columns", "compas", "compas_columns", "geopandas", "networkx", "networkx_columns", "shapely", "trimesh"]

_Array = npt.NDArray[np.int64]
#: A link to something that is not there.
_DANGLING = -2


class Columns(NamedTuple):
    """A structure as arrays, with its names."""

    #: What :func:`twinedge.validate` takes: ``origin``, ``twin``, ``next``, ``prev`` and, of a mesh, ``face`` and others.
    links: dict[str, Any]
    #: The name of each vertex.
    vertices: list[Any]
    #: The origins and targets of the half-edges, as positions in ``vertices``, of shape (h, 2).
    half_edges: _Array


def _find(keys: _Array, order: _Array, wanted: _Array) -> _Array:
    """The positions of the wanted keys, ``_DANGLING`` for those that are not there."""
    if not len(keys):
        return np.full(len(wanted), _DANGLING)
    found = order[np.minimum(np.searchsorted(keys, wanted, sorter=order), len(keys) - 1)]
    return np.where(keys[found] == wanted, found, _DANGLING)


class _HalfEdges:
    """Half-edges, found by their two vertices."""

    def __init__(self, vertices: int, origin: _Array, target: _Array) -> None:
        self.vertices, self.origin, self.target = vertices, origin, target
        self.keys = origin * vertices + target
        # Where half-edges follow their origins, as in a dictionary of dictionaries, few are out of order.
        self.order = np.argsort(self.keys, kind="stable")

    def find(self, origin: _Array, target: _Array) -> _Array:
        found = _find(self.keys, self.order, origin * self.vertices + target)
        return np.where((origin < 0) | (target < 0), _DANGLING, found)


def _positions(index: dict[Any, int], values: Any, count: int) -> _Array:
    return np.fromiter(map(index.get, values, repeat(_DANGLING)), np.int64, count)


def networkx_columns(embedding: Any) -> Columns:
    """The links of a ``networkx.PlanarEmbedding``.

    The target's ``ccw`` makes ``next``, the origin's ``cw`` makes ``prev``: both are checked. What is missing, or leads to no
    neighbour, dangles. O(h log h) time for h half-edges, of which the sorting is a small part.
    """
    adjacency = embedding._adj
    vertices = [*adjacency]
    neighbours = [*adjacency.values()]
    degrees = np.fromiter(map(len, neighbours), np.int64, len(neighbours))
    n = int(degrees.sum())
    index = {vertex: i for i, vertex in enumerate(vertices)}
    origin = np.repeat(np.arange(len(vertices)), degrees)
    target = _positions(index, chain.from_iterable(neighbours), n)
    data = [*chain.from_iterable(map(dict.values, neighbours))]
    nobody = object()
    ccw = _positions(index, [d.get("ccw", nobody) for d in data], n)
    cw = _positions(index, [d.get("cw", nobody) for d in data], n)
    half_edges = _HalfEdges(len(vertices), origin, target)
    twin = half_edges.find(target, origin)
    known = np.where(twin < 0, 0, twin)
    links = {
        "origin": origin,
        "twin": twin,
        "next": half_edges.find(target, np.where(twin < 0, _DANGLING, ccw[known] if n else ccw)),
        "prev": half_edges.find(cw, origin),
    }
    return Columns(links, vertices, np.stack([origin, target], axis=1))


def networkx(embedding: Any, **expected: Any) -> Report:
    """Judge a ``networkx.PlanarEmbedding``: a rotation system, in the plane, without loops and parallel edges.

    ``expected`` is as for :func:`twinedge.validate`. Compare ``embedding.check_structure()``.
    """
    columns = networkx_columns(embedding)
    return validate(**columns.links, vertices=len(columns.vertices), **{"plane": True, "simple": True} | expected)


def compas_columns(mesh: Any) -> Columns:
    """The links of a ``compas.datastructures.Mesh``: its dictionaries ``halfedge`` and ``face``.

    ``next`` is what the list of the face says. Half-edges without a face keep none there; theirs is the half-edge without face
    at which the faces around their target end. ``face`` is the position of the face in ``mesh.face``. What is missing dangles, and
    so does a vertex that is not in ``mesh.vertex``. O(h log h).
    """
    halfedge, face = mesh.halfedge, mesh.face
    # Half-edges and faces may name vertices that are gone: these come last.
    named = chain(mesh.vertex, halfedge, *halfedge.values(), chain.from_iterable(face.values()))
    vertices = [*dict.fromkeys(named)]
    index = {vertex: i for i, vertex in enumerate(vertices)}
    number = {key: i for i, key in enumerate(face)}
    sides = [(u, v, f) for u, targets in halfedge.items() for v, f in targets.items()]
    origin = np.array([index[u] for u, _, _ in sides], np.int64)
    target = np.array([index[v] for _, v, _ in sides], np.int64)
    label = np.array([-1 if f is None else number.get(f, _DANGLING) for _, _, f in sides], np.int64)
    half_edges = _HalfEdges(len(vertices), origin, target)
    # Of each side of a face, the vertex to which the side after it leads.
    follows = {
        (key, u, v): w
        for key, corners in face.items()
        for u, v, w in zip(corners, corners[1:] + corners[:1], corners[2:] + corners[:2], strict=True)
    }
    nobody = object()
    beyond = [follows.get((f, u, v), nobody) for u, v, f in sides]
    next_ = half_edges.find(target, np.array([index.get(w, _DANGLING) for w in beyond], np.int64))
    twin = half_edges.find(target, origin)
    _follow_borders(label, twin, next_)
    first = np.array([_first(index, half_edges, corners) for corners in face.values()], np.int64)
    links = {"origin": origin, "twin": twin, "next": next_, "face": label, "face_half_edge": first}
    return Columns(links, vertices, np.stack([origin, target], axis=1))


def _follow_borders(label: _Array, twin: _Array, next_: _Array) -> None:
    """Writes the ``next`` of half-edges without face: from the twin, around the target, to one that has none either."""
    has_next = np.flatnonzero(next_ >= 0)
    prev = np.full(len(next_), _DANGLING)
    prev[next_[has_next]] = has_next
    for h in np.flatnonzero(label == -1):
        at = twin[h]
        for _ in range(len(label)):
            if at < 0 or label[at] == -1:
                break
            at = twin[prev[at]] if prev[at] >= 0 else _DANGLING
        next_[h] = at if at >= 0 and label[at] == -1 else _DANGLING


def _first(index: dict[Any, int], half_edges: _HalfEdges, corners: Sequence[Any]) -> int:
    if len(corners) < 2:
        return _DANGLING
    ends = [np.array([index[corner]]) for corner in corners[:2]]
    return int(half_edges.find(*ends)[0])


def compas(mesh: Any, **expected: Any) -> Report:
    """Judge a ``compas.datastructures.Mesh``: surfaces with or without border, without loops and parallel edges.

    ``expected`` is as for :func:`twinedge.validate`. Compare ``mesh.is_manifold()``.
    """
    columns = compas_columns(mesh)
    asked = {"open": True, "simple": True} | expected
    return validate(**columns.links, vertices=len(mesh.vertex), faces=len(mesh.face), **asked)


def trimesh(mesh: Any, **expected: Any) -> Report:
    """Judge a ``trimesh.Trimesh``: its triangles are joined at their edges.

    ``expected`` is as for :func:`twinedge.audit_faces`. Compare ``mesh.is_watertight``, ``is_winding_consistent`` and ``is_volume``,
    which are true of ``closed=True`` and more.
    """
    return audit_faces(np.asarray(mesh.faces), len(mesh.vertices), **{"sides": 3} | expected)


def shapely(polygons: Any, **limits: Any) -> Report:
    """Judge shapely polygons as a coverage: without overlaps, gaps, near misses, slivers and duplicates, each valid.

    ``limits`` are those of :func:`twinedge.audit`. Compare ``shapely.coverage_is_valid`` and ``shapely.is_valid``.
    """
    return audit(polygons, **{"coverage": True} | limits)


def geopandas(layer: Any, **limits: Any) -> Report:
    """Judge the polygons of a GeoDataFrame or GeoSeries as a coverage, as :func:`shapely` does.

    ``features`` of the report are positions: ``layer.iloc[list(features)]``. Compare ``GeoSeries.is_valid_coverage``.
    """
    return audit(layer, **{"coverage": True} | limits)
