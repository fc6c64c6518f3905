"""A planar map that is built once and asked often."""

from __future__ import annotations

import html
import os
from collections.abc import Callable, Iterable, Sequence
from pathlib import Path
from typing import Any, NamedTuple

from . import _twinedge
from ._audit import _input, _labels, _source
from ._names import Names
from ._options import _cell

#: The length of the longer side of a picture in a notebook, in pixels.
_IN_NOTEBOOK = 600

#: The parts of overlays by their names, by who covers them.
_KEPT: dict[str, Callable[[bool, bool], bool]] = {
    "union": lambda left, right: left or right,
    "intersection": lambda left, right: left and right,
    "difference": lambda left, right: left and not right,
    "symmetric_difference": lambda left, right: left != right,
    "identity": lambda left, right: left,
}


class Border(NamedTuple):
    """Two features and their border."""

    #: The position of one feature.
    feature: int
    #: The position of the other.
    other: int
    #: The border of the first with the second.
    length: float
    #: The part of it on which one ends and the other begins.
    shared: float
    #: The number of lines of the border.
    lines: int
    #: The area that both cover.
    overlap: float


class Place(NamedTuple):
    """A record of a map at a point."""

    #: ``"face"``, ``"edge"`` or ``"vertex"``.
    kind: str
    #: The positions of the features that cover the face, or that have the edge or vertex on their border.
    features: tuple[int, ...]


class Piece(NamedTuple):
    """A part of an overlay."""

    #: The positions of the features of the left layer that cover it.
    left: tuple[int, ...]
    #: Those of the right layer.
    right: tuple[int, ...]
    #: A MultiPolygon, as GeoJSON has it: ``shapely.geometry.shape`` takes it.
    geometry: dict[str, Any]


class Map:
    """The planar map of a layer, as :func:`twinedge.audit` takes one. Notebooks show it.

    Parameters
    ----------
    layer
        As for :func:`twinedge.audit`, but no mesh.
    snap : float or "auto", optional
        Cut segments where they meet, on a grid of cells that are at most so wide. Without it, borders must not cross for most questions.

    Raises
    ------
    OSError, TypeError, ValueError
        As :func:`twinedge.audit`.
    """

    def __init__(self, layer: Any, *, snap: float | str | None = None, format: str | None = None) -> None:
        self._crs: Any = None
        self._labels: Names | None = None
        if isinstance(layer, (str, os.PathLike)):
            path = Path(layer)
            if not path.exists():
                raise FileNotFoundError(f"{layer}: no such file")
            source = _input(str(layer), path=path, format=format)
        else:
            self._crs, self._labels = getattr(layer, "crs", None), _labels(layer, None)
            source = _source(layer, self._labels)
            if source["not_finite"]:
                raise ValueError(f"feature {source['not_finite'][0]} has a coordinate that is NaN or infinite")
        self._map = _twinedge.build_map(source, _cell(snap))

    def __len__(self) -> int:
        """The number of features."""
        return len(self._map)

    def neighbours(self, feature: int | None = None, *, geodesic: bool = False) -> list[Border]:
        """All pairs of features with a border or an overlap, in order; or those of one feature, which is first then.

        Lengths are those of the plane, or in metres along geodesics where coordinates are degrees. O(edges).
        """
        found = [Border(*row) for row in self._map.neighbours(geodesic)]
        if feature is None:
            return found
        turned = [one if one.feature == feature else one._replace(feature=one.other, other=one.feature) for one in found]
        return [one for one in turned if one.feature == feature]

    def at(self, points: Iterable[Sequence[float]]) -> list[Place]:
        """What lies at each of these points ``(x, y)``: exact. O((edges + points) log edges)."""
        found = self._map.at([(float(x), float(y)) for x, y in points])
        return [Place(kind, tuple(features)) for kind, features in found]

    def contour(self, *features: int) -> dict[str, Any]:
        """The outline of what these features cover together, without the borders inside: a MultiPolygon as GeoJSON has it, valid by the
        OGC. O(half-edges of their faces)."""
        return _multi(self._map.contour([*features]))

    def overlay(self, other: Map, how: str = "intersection", *, snap: float | str = "auto") -> list[Piece]:
        """The parts of the plane that the features of both maps make together, each with all features that cover it.

        ``how`` is ``"intersection"``, ``"union"``, ``"difference"``, ``"symmetric_difference"`` or ``"identity"`` (what the left
        one covers). O((n + k) log n) for n edges that meet k times, on a grid.
        """
        keeps = _keeps(how)
        found = self._map.overlay(other._map, _cell(snap) or 0.0)
        return [
            Piece(tuple(left), tuple(right), _multi(polygons))
            for left, right, polygons in found
            if keeps(bool(left), bool(right))
        ]

    def draw(
        self,
        *,
        size: float = 1000,
        detail: bool = False,
        window: Sequence[float] | None = None,
        whole: bool = False,
        list: int = 1000,
    ) -> str:
        """The map as SVG: its faces, its edges, and in red what breaks a rule, as ``twinedge draw`` does.

        ``detail`` draws half-edges as arrows with their names, ``window`` is a part ``(x0, y0, x1, y1)``, ``whole`` draws far islands
        where they are.
        """
        if not 100 <= size <= 100_000:
            raise ValueError(f"size: {size} is not between 100 and 100,000")
        corners = None if window is None else [float(x) for x in window]
        picture: str = self._map.svg(float(size), detail, corners, whole, list)
        return picture

    def _repr_svg_(self) -> str:
        return self.draw(size=_IN_NOTEBOOK)

    def __repr__(self) -> str:
        return f"<twinedge.Map of {len(self):,} features>"

    def _repr_html_(self) -> str:
        return f"<figure>{self._repr_svg_()}<figcaption>{html.escape(repr(self))}</figcaption></figure>"


def overlay(left: Any, right: Any, how: str = "intersection", *, snap: float | str = "auto") -> Any:
    """The overlay of two layers of geopandas, as ``geopandas.overlay`` names it: a GeoDataFrame with a row for each part.

    Its columns are ``left`` and ``right``, tuples of the labels of the features that cover a part (of the indices of the frames), and
    ``geometry``. Parts that several features of one layer cover are there once. The reference system is that of ``left``; another one of ``right`` is a ``ValueError``. Layers
    without geopandas are for :meth:`Map.overlay`.
    """
    import geopandas
    from shapely.geometry import shape

    if left.crs is not None and right.crs is not None and left.crs != right.crs:
        raise ValueError("the layers have different reference systems: right.to_crs(left.crs) makes them the same")
    pieces = Map(left).overlay(Map(right), how, snap=snap)
    rows = {
        "left": [tuple(left.index[list(piece.left)]) for piece in pieces],
        "right": [tuple(right.index[list(piece.right)]) for piece in pieces],
    }
    return geopandas.GeoDataFrame(rows, geometry=[shape(piece.geometry) for piece in pieces], crs=left.crs)


def draw(layer: Any, **options: Any) -> str:
    """A layer as SVG. Options are those of :meth:`Map.draw`."""
    return Map(layer).draw(**options)


def _keeps(how: str) -> Callable[[bool, bool], bool]:
    """True for the parts that an overlay keeps, by who covers them."""
    if how not in _KEPT:
        raise ValueError(f"how: {how!r} is none of {', '.join(_KEPT)}")
    return _KEPT[how]


def _multi(polygons: Any) -> dict[str, Any]:
    return {"type": "MultiPolygon", "coordinates": polygons}
