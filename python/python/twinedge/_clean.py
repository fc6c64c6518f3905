"""Repair of layers of polygons."""

from __future__ import annotations

import json
import os
from collections.abc import Iterable, Sequence
from typing import Any, NamedTuple

import numpy as np

from . import _twinedge
from ._audit import _cell, _input, _limits, _refused


class Cleaned(NamedTuple):
    """A layer that was cleaned."""

    #: Of the kind that was given: a GeoDataFrame, a GeoSeries, or a list of shapely geometries. Attributes, order and reference system are kept.
    layer: Any
    #: The report of ``twinedge clean --format json``: ``changes``, ``changed``, ``left``, ``warnings`` and others.
    report: dict[str, Any]

    @property
    def is_clean(self) -> bool:
        """Nothing that breaks C1 to C7 is left."""
        return bool(self.report["clean"])


def clean(
    layer: Any,
    *,
    gap_width: float | None = None,
    lake_width: float | None = None,
    accept_gaps: Iterable[Sequence[float]] | None = None,
    sliver_area: float | None = None,
    snap: float | str | None = None,
    overlap: str = "inner",
) -> Cleaned:
    """Repair a layer of polygons: overlaps, gaps, slivers, missing vertices and invalid rings, as ``twinedge clean`` does.

    What is right stays as it is: geometries that do not change are the same objects afterwards. Lines and points are not touched, and
    heights and measures are kept.

    Parameters
    ----------
    layer
        A GeoDataFrame, a GeoSeries, a sequence of shapely geometries, or a path that geopandas reads.
    gap_width : float, optional
        Gaps and near misses up to this mean width are filled. Default: gaps below ``sliver_area``.
    lake_width, accept_gaps, sliver_area, snap
        As for :func:`twinedge.audit`. Without ``snap`` nothing moves, unless borders cross where there is no point.
    overlap : str
        Who gets what several claim: ``"inner"`` (one that lies within another, or else the larger), ``"larger"``, ``"smaller"``,
        ``"first"`` or ``"last"``.

    Returns
    -------
    Cleaned
        The ``layer`` and the ``report``.

    Raises
    ------
    TypeError
        The layer is none of these.
    ValueError
        There is no polygon; a coordinate is not finite; an argument is wrong.

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
    source = _input("layer", text=_digits(geometries), format="wkb")
    limits = _limits(gap_width, lake_width, accept_gaps, sliver_area)
    text, changed = _twinedge.clean(source, limits, _cell(snap), overlap)
    made = geometries.copy()
    for number, digits in changed:
        made[number] = None if digits is None else shapely.from_wkb(digits)
    report: dict[str, Any] = json.loads(text)
    if hasattr(layer, "set_geometry"):
        return Cleaned(layer.set_geometry(type(column)(made, index=layer.index, crs=layer.crs).rename(column.name)), report)
    if column is not layer or hasattr(layer, "geom_type"):
        return Cleaned(type(layer)(made, index=layer.index, crs=layer.crs, name=layer.name), report)
    return Cleaned(made.tolist(), report)


def _digits(geometries: Any) -> bytes:
    """Well-known binary in hexadecimal digits, a line for each geometry."""
    import shapely

    filled = geometries.copy()
    filled[[one is None for one in geometries]] = shapely.GeometryCollection()
    return "\n".join(shapely.to_wkb(filled, hex=True, flavor="iso")).encode()
