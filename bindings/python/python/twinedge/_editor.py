"""A planar map that is edited: changes are undone and redone, and values follow them."""

from __future__ import annotations

import json
import os
from collections.abc import Callable, Iterable, Sequence
from pathlib import Path
from typing import Any, NamedTuple, TypeVar

from . import _twinedge
from ._map import Map, _multi
from ._options import _cell

_T = TypeVar("_T")


class Edited(NamedTuple):
    """The changes that an edit made. An edge is named by one of its half-edges; keys of what was dropped name nothing any more."""

    #: The vertices at the points that were given, in their order, whether made or there before.
    vertices: list[int]
    #: The half-edges along the drawn line, from its first point to its last.
    way: list[int]
    vertices_made: list[int]
    vertices_dropped: list[int]
    #: A half-edge of each split edge, and the new one that goes on from there.
    edges_split: list[tuple[int, int]]
    edges_made: list[int]
    edges_dropped: list[int]
    #: The face that was split, which is one part now, and the other part.
    faces_split: list[tuple[int, int]]
    #: The kept face, and the dropped face.
    faces_merged: list[tuple[int, int]]


class Editor:
    """A planar map that is edited: an empty one, or that of a layer.

    Each edit is one change, or a part of one (:meth:`change`); all of it is done or, if an exception is raised, none. After each change, and
    after :meth:`undo` and :meth:`redo`, what was written is validated. Vertices, half-edges and faces are named by keys, which
    are integers: after :meth:`undo` and :meth:`redo` they are the same, and that of a dropped record names nothing: it has no value, and an edit of it is a ``KeyError``. Edits that
    the map or an attribute refuses are a ``ValueError``. Places are points ``(x, y)`` or keys of vertices.
    """

    def __init__(self, layer: Any = None, *, snap: float | str | None = None) -> None:
        """An empty map, or that of a layer or a file, as :func:`twinedge.audit` takes one.

        Borders may only meet at their ends: ``snap`` cuts them, as in :func:`twinedge.audit`. A layer whose borders cross is a ``ValueError`` without it.
        """
        if layer is None:
            self._editor = _twinedge.Editor()
        else:
            self._editor = _twinedge.Editor.of(Map(layer, snap=snap)._map)
        self._attributes: list[str] = []

    def attribute(
        self,
        name: str,
        *,
        of: str = "faces",
        split: str | Callable[[Any], tuple[Any, Any]] = "keep",
        merge: str | Callable[[Any, Any], Any] = "keep",
    ) -> None:
        """Adds an attribute of ``"faces"``, ``"edges"`` or ``"vertices"``, before the first change.

        Parameters
        ----------
        split
            The value of the other part of a record that is split: ``"keep"`` (it has none), ``"copy"``, ``"share"`` (numbers of faces by area, of edges by
            length), ``"between"`` (numbers of vertices on an edge, by those of its ends), or a function of the value that returns both; ``None`` is no value.
        merge
            The value of a merged record: ``"keep"`` (that of the one that stays), ``"equal"`` (others are not merged), ``"sum"`` (of numbers), or a
            function of both values; ``None`` is no value, also where it is returned.

        A function that raises refuses the edit. It must not use the editor. Values are any objects; do not change them in place, as undoing cannot bring that back.
        """
        self._editor.attribute(name, of, split, merge, None)
        if of == "faces":
            self._attributes.append(name)

    def ids(self, name: str = "id", *, of: str = "faces", first: int = 1) -> None:
        """Adds an attribute that numbers the records, each permanently, before the first change. The unbounded face has no number."""
        self._editor.attribute(name, of, "keep", "keep", first)
        if of == "faces":
            self._attributes.append(name)

    def change(self, name: str, change: Callable[[], _T]) -> _T:
        """Calls a function, whose edits are one change with this name. Returns what it returns.

        If it raises, all of them are taken back.
        """
        result: _T = self._editor.change(name, change)
        return result

    def undo(self) -> bool:
        """Takes the last change back; false if there is none. At most the time that the change took."""
        return self._editor.undo()

    def redo(self) -> bool:
        """Does the last change that was undone again; false if there is none."""
        return self._editor.redo()

    @property
    def undo_name(self) -> str | None:
        """The name of the change that :meth:`undo` takes back."""
        return self._editor.undo_name()

    @property
    def redo_name(self) -> str | None:
        """The name of the change that :meth:`redo` does again."""
        return self._editor.redo_name()

    def insert_point(self, at: Sequence[float] | int) -> Edited:
        """Adds a vertex, on an edge or in a face."""
        return Edited(*self._editor.insert_point(_place(at)))

    def insert_segment(self, start: Sequence[float] | int, end: Sequence[float] | int) -> Edited:
        """Draws edges along a segment, through what lies exactly on it; it may not cross an edge."""
        return Edited(*self._editor.insert_segment(_place(start), _place(end)))

    def insert_segment_snapped(
        self, start: Sequence[float] | int, end: Sequence[float] | int, *, snap: float | str = "auto"
    ) -> Edited:
        """Draws edges along a segment that may cross edges. It is cut where it meets them, and new points lie on a grid of cells that are at most as
        wide as ``snap``; vertices must lie on that grid."""
        return Edited(*self._editor.insert_segment_snapped(_place(start), _place(end), _cell(snap) or 0.0))

    def insert_ring(self, points: Iterable[Sequence[float] | int]) -> Edited:
        """Draws edges along a closed chain; it may not cross an edge, nor itself."""
        return Edited(*self._editor.insert_ring([_place(at) for at in points]))

    def remove_edge(self, half_edge: int) -> Edited:
        """Erases an edge, and keeps its ends. Of two faces, the one to the left is kept, or the one that lies around the other."""
        return Edited(*self._editor.remove_edge(half_edge))

    def remove_vertex(self, vertex: int) -> Edited:
        """Erases a vertex with its edges."""
        return Edited(*self._editor.remove_vertex(vertex))

    def move_vertex(self, vertex: int, to: Sequence[float]) -> None:
        """Moves a vertex with its edges; nothing may be in the way."""
        x, y = to
        self._editor.move_vertex(vertex, (float(x), float(y)))

    def set(self, name: str, of: int, value: Any) -> None:
        """Gives a value to a record, or takes it away if it is ``None``. O(1)."""
        self._editor.set(name, of, value)

    def get(self, name: str, of: int) -> Any:
        """The value of a record, or ``None``. O(1)."""
        return self._editor.get(name, of)

    def values(self, name: str) -> dict[int, Any]:
        """All values of an attribute, by key."""
        return dict(self._editor.values(name))

    def find(self, name: str, value: int) -> int | None:
        """The record with this id, or ``None``: of attributes made by :meth:`ids`."""
        return self._editor.find(name, value)

    def features_of(self, face: int) -> tuple[int, ...]:
        """The positions of the features of the layer that cover a face."""
        return tuple(self._editor.features_of(face))

    def to_geojson(self) -> dict[str, Any]:
        """The faces as a collection of GeoJSON: a feature for each bounded face that a feature of the layer covers, or for each bounded face of a map without
        a layer.

        Properties are the values of the attributes of faces, and ``features``, the positions of the features of the layer that cover the face.
        """
        faces = [face for face in self.faces if face != self.unbounded]
        covered = {face: self.features_of(face) for face in faces}
        if any(covered.values()):
            faces = [face for face in faces if covered[face]]
        return {"type": "FeatureCollection", "features": [self._feature(face, covered[face]) for face in faces]}

    def _feature(self, face: int, features: tuple[int, ...]) -> dict[str, Any]:
        values = {name: self.get(name, face) for name in self._attributes}
        properties = values | ({"features": [*features]} if features else {})
        return {"type": "Feature", "properties": properties, "geometry": _multi(self._editor.polygons(face))}

    def save(self, path: str | os.PathLike[str]) -> None:
        """Writes :meth:`to_geojson` to a file. A value that JSON does not have is a ``TypeError``, and nothing is written then."""
        text = json.dumps(self.to_geojson())
        Path(path).write_text(text, encoding="utf-8")

    @property
    def vertices(self) -> list[int]:
        """All vertices."""
        return self._editor.vertices()

    @property
    def edges(self) -> list[int]:
        """All edges, each by one of its half-edges."""
        return self._editor.edges()

    @property
    def faces(self) -> list[int]:
        """All faces, the unbounded one among them."""
        return self._editor.faces()

    @property
    def unbounded(self) -> int:
        """The unbounded face."""
        return self._editor.unbounded()

    def position(self, vertex: int) -> tuple[float, float]:
        """The coordinates of a vertex."""
        x, y = self._editor.position(vertex)
        return x, y

    def area(self, face: int) -> float:
        """The area of a face."""
        return self._editor.area(face)

    def rings(self, face: int) -> list[list[int]]:
        """The vertices around a face: a list for each part of its boundary, the outer one first."""
        return self._editor.rings(face)

    def at(self, point: Sequence[float]) -> tuple[str, int]:
        """The record at a point: ``"face"``, ``"edge"`` or ``"vertex"``, and its key. Exact; O(log n) on most maps."""
        x, y = point
        return self._editor.at((float(x), float(y)))

    def __repr__(self) -> str:
        return f"<twinedge.Editor of {len(self.vertices):,} vertices, {len(self.edges):,} edges and {len(self.faces):,} faces>"


def _place(at: Sequence[float] | int) -> Any:
    if isinstance(at, int):
        return at
    x, y = at
    return float(x), float(y)
