"""Repair of layers of polygons."""

from __future__ import annotations

import json
import os
from collections.abc import Iterable, Sequence
from typing import Any, NamedTuple, cast

import numpy as np

from . import _twinedge
from ._audit import _input, _refused
from ._options import _grid, _limits
from ._options import _text as _options


#: The number of changes, and of findings that are left, that ``repr`` shows.
_SHOWN = 4


class Cleaned(NamedTuple):
    """A layer that was cleaned."""

    #: Of the kind that was given: a GeoDataFrame, a GeoSeries, or a list of shapely geometries. Attributes, order and reference system are kept.
    #: A feature that was made for gaps is the last; its label is the next number, or ``"gaps"`` where labels are no numbers.
    layer: Any
    #: The report of ``twinedge clean --format json``: ``changes``, ``changed``, ``left``, ``warnings`` and others.
    report: dict[str, Any]

    @property
    def is_clean(self) -> bool:
        """Nothing that breaks C1 to C7 is left."""
        return bool(self.report["clean"])

    def __repr__(self) -> str:
        changed, left = self.report["changed"], (self.report.get("left") or {}).get("findings", [])
        head = f"<twinedge.Cleaned {'clean' if self.is_clean else 'not clean'}: {len(changed):,} of {len(self.layer):,} features changed, {len(left):,} findings left>"
        told = [f"  {one.get('name') or one.get('id') or one['number']}: {'; '.join(one['reasons'])}" for one in changed[:_SHOWN]]
        told += [f"  left: {one['message']}" for one in left[:_SHOWN]]
        return "\n".join([head, *told])


def clean(
    layer: Any,
    *,
    gap_width: float | str | None = None,
    lake_width: float | None = None,
    accept_gaps: Iterable[Sequence[float]] | None = None,
    sliver_area: float | None = None,
    snap: float | str | None = None,
    overlap: str = "inner",
    gaps_to: tuple[str, Any] | Iterable[int] | None = None,
) -> Cleaned:
    """Repair a layer of polygons: overlaps, gaps, slivers, missing vertices and invalid rings, as ``twinedge clean`` does.

    What is right stays as it is: geometries that do not change are the same objects afterwards. Lines and points are not touched, and
    heights and measures are kept.

    Parameters
    ----------
    layer
        A GeoDataFrame, a GeoSeries, a sequence of shapely geometries, or a path that geopandas reads.
    gap_width : float or "auto", optional
        Gaps and near misses up to this mean width are filled. ``"auto"`` takes the widest gap that is ten times narrower than the next wider
        one, or than the median part of a feature; ``report["gap_width"]`` says it. Default: gaps below ``sliver_area``.
    lake_width, accept_gaps, sliver_area, snap
        As for :func:`twinedge.audit`. Without ``snap`` nothing moves, unless borders cross where there is no point.
    overlap : str
        Who gets what several claim: ``"inner"`` (one that lies within another, or else the larger), ``"larger"``, ``"smaller"``,
        ``"first"`` or ``"last"``.
    gaps_to : (column, value) or positions, optional
        Who gets the gaps that are filled: the neighbour with this value in a column of the frame, or at one of these positions; or else the
        first such feature; or else a new one. Default: any neighbour.

    Returns
    -------
    Cleaned
        The ``layer`` and the ``report``.

    Raises
    ------
    TypeError
        The layer is none of these.
    ValueError
        There is no polygon; there is no such column or position; a coordinate is not finite; an argument is wrong.

    Notes
    -----
    O(n log n) for n segments that cross in O(n) places. Needs shapely.
    """
    import shapely

    if isinstance(layer, (str, os.PathLike)):
        import geopandas

        layer = geopandas.read_file(layer)
    column = layer.geometry if hasattr(layer, "geometry") and hasattr(layer, "geom_type") else layer
    try:
        geometries = np.fromiter(column, object)
    except TypeError:
        raise _refused(layer, "expected a frame or a sequence of shapely geometries") from None
    if not all(one is None or isinstance(one, shapely.Geometry) for one in geometries):
        raise _refused(layer, "expected a frame or a sequence of shapely geometries")
    receiving, attributes = _receiving(layer, gaps_to, len(geometries))
    source = _input("layer", text=_digits(geometries), format="wkb")
    is_auto = isinstance(gap_width, str) and gap_width == "auto"
    # Any other text is refused like any value that is no number.
    width = cast("float | None", None if is_auto else gap_width)
    asked = _options(None, **_limits(width, lake_width, accept_gaps, sliver_area), snap=_grid(snap))
    text, changed = _twinedge.clean(source, asked, overlap, is_auto, receiving)
    made = geometries.copy()
    for number, digits in changed:
        geometry = None if digits is None else shapely.from_wkb(digits)
        if number == len(made):
            layer, column = _extended(layer, column, attributes)
            made = np.concatenate([made, np.array([None], object)])
        made[number] = geometry
    report: dict[str, Any] = json.loads(text)
    if hasattr(layer, "set_geometry"):
        return Cleaned(layer.set_geometry(type(column)(made, index=layer.index, crs=layer.crs).rename(column.name)), report)
    if column is not layer or hasattr(layer, "geom_type"):
        return Cleaned(type(layer)(made, index=layer.index, crs=layer.crs, name=layer.name), report)
    return Cleaned(made.tolist(), report)


def _receiving(layer: Any, gaps_to: Any, count: int) -> tuple[list[int] | None, dict[str, Any]]:
    """The positions of the features to which gaps go, none for a new one, and the attributes of that."""
    if gaps_to is None:
        return None, {}
    if isinstance(gaps_to, tuple) and len(gaps_to) == 2 and isinstance(gaps_to[0], str):
        column, value = gaps_to
        if not hasattr(layer, "set_geometry") or column not in layer.columns or column == layer.geometry.name:
            raise ValueError(f"gaps_to: there is no column {column}")
        can_receive = layer.geometry.isna() | layer.geometry.is_empty | layer.geom_type.isin(["Polygon", "MultiPolygon"])
        return np.flatnonzero((layer[column] == value) & can_receive).tolist(), {column: value}
    positions = [int(position) for position in gaps_to]
    if not all(0 <= position < count for position in positions):
        raise ValueError(f"gaps_to: the positions of features are 0 to {count - 1}")
    return positions, {}


def _extended(layer: Any, column: Any, attributes: dict[str, Any]) -> tuple[Any, Any]:
    """The layer and its geometries with an empty feature behind the others."""
    if not hasattr(layer, "geom_type"):
        return layer, layer
    import pandas as pd

    is_numbered = pd.api.types.is_integer_dtype(layer.index)
    label = (layer.index.max() + 1 if len(layer) else 0) if is_numbered else "gaps"
    more = layer.iloc[:0].reindex(pd.Index([label], name=layer.index.name))
    for name, value in attributes.items():
        more[name] = pd.Series([value], index=more.index)
    layer = pd.concat([layer, more])
    return layer, layer.geometry if hasattr(layer, "set_geometry") else layer


def _digits(geometries: Any) -> bytes:
    """Well-known binary in hexadecimal digits, a line for each geometry."""
    import shapely

    filled = geometries.copy()
    filled[[one is None for one in geometries]] = shapely.GeometryCollection()
    return "\n".join(shapely.to_wkb(filled, hex=True, flavor="iso")).encode()
