"""Audits and overlays of layers that are larger than one machine: tile by tile, on any engine, with the result of the whole.

:mod:`twinedge.tiles.spark`, :mod:`twinedge.tiles.duckdb` and :mod:`twinedge.tiles.dask` have one function each, ``audit``. Other engines take the steps apart.
A grid divides the plane. Each feature is divided into the pieces that tiles need of it. Each tile is judged alone, and its summary is a few bytes for what it
found and for what its border cuts. Summaries add up, in any order::

    divide ─► (group by tile) ─► audit_tile ─► merge … merge ─► finish

Where edges meet elsewhere than at vertices, what features cover is known once edges are cut, alike in all tiles. Cuts are found in a
few rounds, of which only the first one takes all tiles: see :class:`Cuts`.

>>> import shapely, twinedge
>>> from twinedge import tiles
>>> parcels = [shapely.box(0, 0, 2, 2), shapely.box(1, 1, 3, 3)]
>>> features = tiles.table(parcels)
>>> grid, cuts = tiles.Grid(tiles.bounds(features), 2, 2), tiles.Cuts(tiles.bounds(features))
>>> pieces = tiles.divided(features, grid, cuts)
>>> while found := [cuts.search(pieces[tile], grid, tile) for tile in cuts.tiles(grid)]:
...     cuts = cuts.take(*found)
>>> parts = [tiles.audit_tile(pieces[tile], grid, tile, cuts=cuts) for tile in pieces]
>>> report = tiles.finish(tiles.merge(parts[:2]), *parts[2:])
>>> [(finding.rule, finding.features, finding.area) for finding in report.findings]
[('C1', (0, 1), 1.0)]

Two layers are laid over each other in the same way, without rounds: see :class:`Overlay`.

Tables are those of Arrow, with a column ``geometry`` of well-known binary or GeoArrow and a column ``feature``, the number of each feature in the
layer: an integer from 0 to 4,294,967,295 that no two have in common. Whatever has an Arrow table has such columns: DuckDB, Dask, Polars, Spark,
GeoParquet read by pyarrow. GeoArrow is known by its extension type, or by that name in the metadata of the field: ``geoarrow.wkb``, and
``geoarrow.point`` to ``geoarrow.multipolygon`` with coordinates apart or interleaved, which are read where they are. This module needs pyarrow.

All tiles must be made with one grid, the same limits and the same cuts, and of one state of the layer. A tile that is made again of the same pieces
has the same bytes, so a worker that is lost loses nothing. Name the state in ``source``, such as the id of a snapshot and the filter: then tiles that
are made again after the layer was replaced are refused, where others would add up to the audit of no layer at all.
"""

from __future__ import annotations

import json
from collections.abc import Iterable, Iterator, Mapping, Sequence
from typing import TYPE_CHECKING, Any, NamedTuple

import numpy as np

from .. import _twinedge
from .._columns import _batches, _binary, _by_tile, _bytes, _geometries, _numbers, _slices
from .._options import _accepted, _count, _limits
from .._options import _text as _options
from .._report import Report
from ._grid import Cuts as Cuts
from ._grid import Grid as Grid
from ._overlay import Overlay as Overlay
from ._overlay import extents as extents

if TYPE_CHECKING:
    import pyarrow as pa

__all__ = [
    "Audited",
    "Cuts",
    "Grid",
    "Overlay",
    "audit_tile",
    "audit_tiles",
    "bounds",
    "divide",
    "divided",
    "extents",
    "finish",
    "merge",
    "schema",
    "table",
]


class Audited(NamedTuple):
    """The audit of a layer by one call on an engine."""

    #: The report.
    report: Report
    #: The findings and violations with the columns of :meth:`Report.to_arrow` and ``ids``, the ids of the features: a DataFrame of Spark, a relation of
    #: DuckDB, or for Dask a DataFrame of pandas.
    findings: Any


def table(layer: Any) -> pa.Table:
    """The table of a GeoDataFrame, a GeoSeries or a sequence of shapely geometries: ``feature`` is the position, ``geometry`` is ``geoarrow.wkb`` with
    the reference system, if there is one. Needs shapely."""
    import pyarrow as pa
    import shapely

    column = layer.geometry if hasattr(layer, "geometry") and hasattr(layer, "geom_type") else layer
    geometries = np.fromiter(column, object)
    binary = shapely.to_wkb(geometries, flavor="iso")
    numbers = pa.array(np.arange(len(geometries), dtype=np.uint32))
    crs = getattr(layer, "crs", None)
    known = {} if crs is None else {"crs": crs.to_json_dict(), "crs_type": "projjson"}
    metadata = {"ARROW:extension:name": "geoarrow.wkb", "ARROW:extension:metadata": json.dumps(known)}
    schema = pa.schema([pa.field("feature", pa.uint32()), pa.field("geometry", pa.binary(), metadata=metadata)])
    return pa.table([numbers, pa.array(binary, pa.binary())], schema=schema)


def schema() -> pa.Schema:
    """The column of summaries, ``summary``, which is binary, with a checksum."""
    import pyarrow as pa

    return pa.schema([("summary", pa.binary())])


def bounds(batches: Any, *, geometry: str = "geometry") -> tuple[float, float, float, float]:
    """The box around all geometries. O(points).

    ``batches`` is a table, a batch, a reader of batches, or an iterable of them.
    """
    boxes = [box for batch in _batches(batches) if (box := _twinedge.survey(_geometries(batch, geometry))[1]) is not None]
    if not boxes:
        raise ValueError("there are no points")
    low, high = np.min(boxes, axis=0), np.max(boxes, axis=0)
    return (float(low[0]), float(low[1]), float(high[2]), float(high[3]))


def divide(batches: Any, grid: Grid, cuts: Cuts, *, geometry: str = "geometry", feature: str = "feature") -> Iterator[pa.RecordBatch]:
    """The pieces of features that tiles need: batches with the columns ``tile`` and ``piece``, which is binary.

    It is a generator of batches, one or more for each batch that comes, so ``mapInArrow`` of Spark takes it. A piece has the edges in its tile or very near
    it, as edges are bent a little where they are cut, and the number of the feature. Cuts of any round will do: pieces depend on their box only.
    O(n log tiles) for n points.

    Raises
    ------
    TypeError
        Features have no numbers, or none of 32 bits.
    ValueError
        A geometry is malformed or not finite, or lies outside of the box of the cuts.
    """
    import pyarrow as pa

    for batch in _batches(batches):
        tiles, ends, data = _twinedge.divide(grid.state, cuts.state, _numbers(batch, feature), _geometries(batch, geometry))
        for part, pieces in _slices(ends, data):
            yield pa.RecordBatch.from_arrays([pa.array(tiles[part]), pieces], names=["tile", "piece"])


def divided(batches: Any, grid: Grid, cuts: Cuts, *, geometry: str = "geometry", feature: str = "feature") -> dict[int, pa.Table]:
    """The pieces of each tile of the grid, empty ones included: what :func:`divide` says, grouped, in memory."""
    import pyarrow as pa

    found = dict(_by_tile(divide(batches, grid, cuts, geometry=geometry, feature=feature)))
    schema = pa.schema([("tile", pa.int64()), ("piece", pa.binary())])
    return {tile: found.get(tile, schema.empty_table()) for tile in range(len(grid))}


def audit_tile(
    batches: Any,
    grid: Grid,
    tile: int,
    *,
    cuts: Cuts | None = None,
    source: str | None = None,
    gap_width: float | None = None,
    lake_width: float | None = None,
    accept_gaps: Iterable[Sequence[float]] | None = None,
    sliver_area: float | None = None,
) -> pa.RecordBatch:
    """The summary of one tile: a batch with one row, in the column of :func:`schema`. Cuts bring their own ``source``.

    ``batches`` must have every piece of the tile, each once; pieces of other tiles have no effect. A tile without features is made of no batches, and must be
    made as well. Limits are as for :func:`twinedge.audit`; if ``gap_width`` and ``sliver_area`` are given, summaries are smaller.
    O(n log n) for n points.

    Raises
    ------
    ValueError
        A piece is there twice, or two features have the same number; a piece is damaged; the grid has no such tile; not all cuts are found yet, or they have
        another source.
    """
    import pyarrow as pa

    pieces = [_binary(batch, "piece") for batch in _batches(batches)]
    limits = _options(None, **_limits(gap_width, lake_width, accept_gaps, sliver_area))
    place = _count("tile", tile, 2**32)
    if cuts is not None and source not in (None, cuts.source):
        raise ValueError(f"source: the cuts are those of {cuts.source!r}, not of {source!r}")
    state = None if cuts is None else cuts.state
    summary = _twinedge.summarise(grid.state, place, pieces, limits, state, source)
    return pa.RecordBatch.from_pylist([{"summary": summary}], schema())


def audit_tiles(batches: Any, grid: Grid, **options: Any) -> Iterator[pa.RecordBatch]:
    """The summaries of the tiles that have pieces here: a generator of batches of one row each.

    The rows come from :func:`divide`, and must include all rows of a tile, as in a partition by ``tile``. Options are as for :func:`audit_tile`.
    """
    return (audit_tile(part, grid, tile, **options) for tile, part in _by_tile(batches))


def merge(*batches: Any) -> pa.RecordBatch:
    """One summary of all in these batches, in whatever order: a batch with one row, or with none if there is none.

    Associative and commutative, down to the bytes. O(what the borders cut and the tiles found).

    Raises ``ValueError`` if they are of different sources, grids or limits, have a tile in common, or only some were made with cuts, and names the tiles.
    """
    import pyarrow as pa

    summary = _twinedge.merge(_bytes(batches, "summary"))
    return pa.RecordBatch.from_pylist([] if summary is None else [{"summary": summary}], schema())


def finish(
    *batches: Any,
    grid: Grid | None = None,
    labels: Sequence[Any] | Mapping[int, Any] | None = None,
    coverage: bool = False,
    accept: Any = None,
    list: int | None = None,
    explain: bool = False,
    crs: Any = None,
    **limits: Any,
) -> Report:
    """The report on the layer, of the summaries of all tiles.

    It says what :func:`twinedge.audit` of the whole says: the verdict, the counts, and each violation and finding once, with its place;
    ``features`` are the numbers of the features. :meth:`Report.to_frame` and :meth:`Report.to_arrow` are tables of it, and
    :meth:`Report.to_geodataframe` a layer of the places, which are points. Where edges meet elsewhere than
    at vertices, C1 to C5 and C7 are checked if tiles were made with :class:`Cuts`; if one was left out of a round of cuts, the report says which.

    Parameters
    ----------
    batches
        Batches or tables with summaries, in any order.
    grid : Grid, optional
        Tiles that have no summary are made here, as those of nothing. Without it, every tile must be there.
    labels : sequence or mapping, optional
        The labels of the features, by number, as ``name`` of :func:`twinedge.audit` finds them; a mapping has some of them. Ids of findings are made of
        labels: with the same labels, they are the ids of that audit. Numbers of features must then be positions.
    coverage, accept, list, explain
        As for :func:`twinedge.audit`.
    crs
        The reference system of that layer.
    limits
        Those of the tiles, for the empty ones. These need no cuts.

    Raises
    ------
    ValueError
        Tiles are missing, which are named, or a finding is about a feature without a label, or as :func:`merge`.
    """
    asked = _options(list, coverage=bool(coverage), explain=bool(explain), **_limits(**limits), allow_empty=True)
    whole = None if grid is None else grid.state
    if isinstance(labels, Mapping):
        names = [labels.get(number) for number in range(max(labels, default=-1) + 1)]
    else:
        names = [] if labels is None else [*labels]
    ids = [None if label is None or label != label else str(label) for label in names]
    told = _twinedge.finish(_bytes(batches, "summary"), whole, asked, _accepted(accept), ids, not isinstance(labels, Mapping))
    return Report._told(told, {"feature": names} if names else None, crs)


def __getattr__(name: str) -> Any:
    # The modules of the engines, when they are first used.
    if name in ("dask", "duckdb", "spark"):
        from importlib import import_module

        return import_module(f"{__name__}.{name}")
    raise AttributeError(f"module {__name__!r} has no attribute {name!r}")
