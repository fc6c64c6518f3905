"""The structures of other libraries, each by one function that validates it.

=================== ====================================================
:func:`networkx`    ``networkx.PlanarEmbedding``
:func:`compas`      ``compas.datastructures.Mesh``
:func:`trimesh`     ``trimesh.Trimesh``
:func:`shapely`     a sequence of shapely polygons, as a coverage
:func:`geopandas`   a GeoDataFrame or GeoSeries of polygons, as a coverage
=================== ====================================================

None of the libraries is imported here. A report says what its records are called in the structure: ``report.name(record)`` is a node or
a key, or for a half-edge the pair of its origin and its target, and ``names`` of a violation has those of its records. The arrays
themselves are what :func:`networkx_columns` and :func:`compas_columns` return.

>>> import networkx
>>> import twinedge
>>> _, embedding = networkx.check_planarity(networkx.cycle_graph(["a", "b", "c"]))
>>> twinedge.adapters.networkx(embedding).valid
True
>>> del embedding["a"]["b"]["ccw"]
>>> violation = twinedge.adapters.networkx(embedding).violations[0]
>>> violation.rule, violation.records[0].kind, violation.names[0]
('R1', 'half_edge', ('b', 'a'))
"""

from __future__ import annotations

from collections.abc import Sequence
from itertools import chain, repeat
from typing import TYPE_CHECKING, Any, NamedTuple

import numpy as np
import numpy.typing as npt

from ._audit import audit, audit_faces
from ._links import judge
from ._names import Pairs
from ._options import AuditOptions
from ._report import Report

if TYPE_CHECKING:
    from typing_extensions import Unpack

__all__ = ["Columns", "compas", "compas_columns", "geopandas", "networkx", "networkx_columns", "shapely", "trimesh"]

_Array = npt.NDArray[np.int64]
#: A link to something that is not there.
_DANGLING = -2


class Columns(NamedTuple):
    """A structure as arrays, with its names."""

    #: The arguments of :func:`twinedge.validate`: ``origin``, ``twin``, ``next``, ``prev`` and, of a mesh, ``face`` and others.
    links: dict[str, Any]
    #: The name of each vertex: ``vertices[v]`` names vertex ``v`` of a report.
    vertices: list[Any]
    #: The origins and targets of the half-edges, of shape (h, 2): positions in ``vertices``, negative for missing vertices.
    #: ``[vertices[v] for v in half_edges[h]]`` are the names of the ends of half-edge ``h``; ``report.name(record)`` has the same.
    half_edges: _Array


def _expect(known: bool, wanted: str, given: Any, instead: str = "") -> None:
    if not known:
        what = "None" if given is None else type(given).__name__
        raise TypeError(f"expected a {wanted}, not {what}{instead}")


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
        # Half-edges in the order of their origins, as in a dictionary of dictionaries, are almost sorted.
        self.order = np.argsort(self.keys, kind="stable")

    def find(self, origin: _Array, target: _Array) -> _Array:
        found = _find(self.keys, self.order, origin * self.vertices + target)
        return np.where((origin < 0) | (target < 0), _DANGLING, found)


def _positions(index: dict[Any, int], values: Any, count: int) -> _Array:
    return np.fromiter(map(index.get, values, repeat(_DANGLING)), np.int64, count)


def networkx_columns(embedding: Any) -> Columns:
    """The links of a ``networkx.PlanarEmbedding``.

    The target's ``ccw`` makes ``next``, the origin's ``cw`` makes ``prev``: both are checked. What is missing, or leads to no
    neighbour, dangles. O(h log h) time for h half-edges, of which the sorting is a small part. Anything else is a ``TypeError``.
    """
    instead = ": networkx.check_planarity(graph) gives one" if hasattr(embedding, "nodes") else ""
    known = hasattr(embedding, "check_structure") and hasattr(embedding, "_adj")
    _expect(known, "networkx.PlanarEmbedding", embedding, instead)
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
    back = np.where(twin < 0, 0, twin)
    links = {
        "origin": origin,
        "twin": twin,
        "next": half_edges.find(target, np.where(twin < 0, _DANGLING, ccw[back] if n else ccw)),
        "prev": half_edges.find(cw, origin),
    }
    return Columns(links, vertices, np.stack([origin, target], axis=1))


def networkx(embedding: Any, **expected: Any) -> Report:
    """Judge a ``networkx.PlanarEmbedding``: a rotation system, in the plane, without loops and parallel edges.

    ``expected`` is as for :func:`twinedge.validate`. Compare ``embedding.check_structure()``. Names are nodes, and pairs of nodes; the
    page of this module has an example.
    """
    columns = networkx_columns(embedding)
    report = judge(columns.links, {"plane": True, "simple": True} | expected, len(columns.vertices))
    return report._named({"vertex": columns.vertices, "half_edge": Pairs(columns.vertices, columns.half_edges)})


def compas_columns(mesh: Any) -> Columns:
    """The links of a ``compas.datastructures.Mesh``: its dictionaries ``halfedge`` and ``face``.

    ``next`` is what the list of the face says. Half-edges without a face keep none there; theirs is the half-edge without face
    at which the faces around their target end. ``face`` is the position of the face in ``mesh.face``. What is missing dangles, and
    so does a vertex that is not in ``mesh.vertex``. O(h log h). Anything else is a ``TypeError``.
    """
    known = all(isinstance(getattr(mesh, name, None), dict) for name in ("halfedge", "face", "vertex"))
    _expect(known, "compas.datastructures.Mesh", mesh)
    halfedge, face = mesh.halfedge, mesh.face
    # Half-edges and faces may name removed vertices: these come last.
    named = chain(mesh.vertex, halfedge, *halfedge.values(), chain.from_iterable(face.values()))
    vertices = [*dict.fromkeys(named)]
    index = {vertex: i for i, vertex in enumerate(vertices)}
    number = {key: i for i, key in enumerate(face)}
    sides = [(u, v, f) for u, targets in halfedge.items() for v, f in targets.items()]
    origin = np.array([index[u] for u, _, _ in sides], np.int64)
    target = np.array([index[v] for _, v, _ in sides], np.int64)
    label = np.array([-1 if f is None else number.get(f, _DANGLING) for _, _, f in sides], np.int64)
    half_edges = _HalfEdges(len(vertices), origin, target)
    # For each side of a face, the vertex to which the next side leads.
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

    ``expected`` is as for :func:`twinedge.validate`. Compare ``mesh.is_manifold()``. Names are the keys of the mesh.

    >>> import twinedge
    >>> from compas.datastructures import Mesh
    >>> twinedge.adapters.compas(Mesh.from_polyhedron(6), closed=True, sides=4, genus=0).valid
    True
    """
    columns = compas_columns(mesh)
    report = judge(columns.links, {"open": True, "simple": True} | expected, len(mesh.vertex), len(mesh.face))
    pairs = Pairs(columns.vertices, columns.half_edges)
    return report._named({"vertex": columns.vertices, "half_edge": pairs, "face": [*mesh.face]})


def trimesh(mesh: Any, **expected: Any) -> Report:
    """Judge a ``trimesh.Trimesh``: its triangles are joined at their edges.

    ``expected`` is as for :func:`twinedge.audit_faces`. Compare ``mesh.is_watertight``, ``is_winding_consistent`` and ``is_volume``,
    which are true of ``closed=True`` and more. Half-edge ``h`` is side ``h % 3`` of triangle ``h // 3``, and ``report.name`` says so.

    >>> import trimesh, twinedge
    >>> box = trimesh.creation.box()
    >>> twinedge.adapters.trimesh(box, closed=True, genus=0).valid
    True
    >>> box.faces[0] = box.faces[0][::-1]
    >>> {finding.kind for finding in twinedge.adapters.trimesh(box, closed=True).findings}
    {'flipped_faces'}
    """
    # A PointCloud has no faces, a Scene neither faces nor vertices.
    known = hasattr(mesh, "faces") and hasattr(mesh, "vertices") and not callable(mesh.faces)
    instead = ": scene.to_mesh() puts the meshes of a scene together" if hasattr(mesh, "to_mesh") else ""
    _expect(known, "trimesh.Trimesh", mesh, instead)
    return audit_faces(np.asarray(mesh.faces), np.asarray(mesh.vertices, float), **{"sides": 3} | expected)


def shapely(polygons: Any, *, coverage: bool = True, **limits: Unpack[AuditOptions]) -> Report:
    """Judge shapely polygons as a coverage: without overlaps, gaps, near misses, slivers and duplicates, each valid.

    ``limits`` are those of :func:`twinedge.audit`. Compare ``shapely.coverage_is_valid`` and ``shapely.is_valid``. Findings make the
    report invalid, so one that is not valid may have no violations.

    >>> import shapely, twinedge
    >>> report = twinedge.adapters.shapely([shapely.box(0, 0, 2, 1), shapely.box(0, 0, 2, 1)])
    >>> [(finding.rule, finding.kind, finding.features) for finding in report.findings]
    [('C5', 'duplicate', (0, 1))]
    """
    return audit(polygons, coverage=coverage, **limits)


def geopandas(layer: Any, *, coverage: bool = True, **limits: Unpack[AuditOptions]) -> Report:
    """Judge the polygons of a GeoDataFrame or GeoSeries as a coverage, as :func:`shapely` does.

    ``features`` of the report are positions: ``layer.iloc[list(features)]``. ``labels`` are those of the index, or of the column that
    ``name=`` says. Compare ``GeoSeries.is_valid_coverage``.

    >>> import geopandas, shapely, twinedge
    >>> boxes = [shapely.box(0, 0, 2, 1), shapely.box(1, 0, 3, 1)]
    >>> layer = geopandas.GeoDataFrame({"parcel": ["north", "south"]}, geometry=boxes)
    >>> twinedge.adapters.geopandas(layer, name="parcel").findings[0].labels
    ('north', 'south')
    """
    return audit(layer, coverage=coverage, **limits)
