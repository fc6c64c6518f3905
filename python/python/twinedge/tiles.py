"""Audits of layers that are larger than one machine: tile by tile, on any engine, with the result of the audit of the whole.

A grid divides the plane. Each tile is judged alone, from the features that meet it, and its summary is a few bytes for what it found and for
what its border cuts. Summaries add up, in any order::

    assign ─► (group by tile) ─► audit_tile ─► merge … merge ─► finish

>>> import shapely, twinedge
>>> from twinedge import tiles
>>> parcels = [shapely.box(0, 0, 2, 2), shapely.box(1, 1, 3, 3)]
>>> features = tiles.table([*parcels, *parcels[1:]])
>>> grid = tiles.Grid(tiles.bounds(features), 2, 2)
>>> parts = [tiles.audit_tile(features, grid, tile) for tile in tiles.assigned(features, grid)]
>>> tiles.finish(tiles.merge(parts[:2]), *parts[2:]).verdict
'invalid'

Tables are those of Arrow, with a column ``geometry`` of well-known binary and a column ``feature``, the number of each feature in the layer: an integer
from 0 to 4,294,967,295 that no two have in common. Whatever has an Arrow table has such columns: DuckDB, Dask, Polars, Spark, GeoParquet read
by pyarrow. This module needs pyarrow.

All tiles must be made with one grid and the same limits. A tile that is made again of the same features has the same bytes, so a worker that is
lost loses nothing.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

import numpy as np

from . import _twinedge
from ._audit import _accepted, _limits
from ._report import Report
from ._validate import _count

if TYPE_CHECKING:
    import pyarrow as pa

__all__ = ["Grid", "assign", "assigned", "audit_tile", "audit_tiles", "bounds", "finish", "merge", "schema", "table"]


@dataclass(frozen=True)
class Grid:
    """The tiles that divide a box, numbered from 0: row by row, from the lower left. What lies outside belongs to the tiles at the border.

    The box need not be that of the layer: any that is the same everywhere will do. Faults in the grid are named when it is first used.
    """

    #: The box ``(x0, y0, x1, y1)``.
    box: tuple[float, float, float, float]
    #: The number of columns.
    columns: int
    #: The number of rows.
    rows: int

    def __post_init__(self) -> None:
        box = tuple(map(float, self.box))
        if len(box) != 4:
            raise ValueError(f"box: expected (x0, y0, x1, y1), not {self.box!r}")
        object.__setattr__(self, "box", box)
        for name in ("columns", "rows"):
            object.__setattr__(self, name, _count(name, getattr(self, name), 65_536))

    def __len__(self) -> int:
        return self.columns * self.rows

    def _native(self) -> tuple[Sequence[float], int, int]:
        return ([*self.box], self.columns, self.rows)


def table(layer: Any) -> pa.Table:
    """The table of a GeoDataFrame, a GeoSeries or a sequence of shapely geometries: ``feature`` is the position. Needs shapely."""
    import pyarrow as pa
    import shapely

    column = layer.geometry if hasattr(layer, "geometry") and hasattr(layer, "geom_type") else layer
    geometries = np.fromiter(column, object)
    binary = shapely.to_wkb(geometries, flavor="iso")
    numbers = pa.array(np.arange(len(geometries), dtype=np.uint32))
    return pa.table({"feature": numbers, "geometry": pa.array(binary, pa.binary())})


def schema() -> pa.Schema:
    """The columns of summaries: ``summary``, which is binary."""
    import pyarrow as pa

    return pa.schema([("summary", pa.binary())])


def bounds(batches: Any, *, geometry: str = "geometry") -> tuple[float, float, float, float]:
    """The box around all geometries. O(points).

    ``batches`` is a table, a batch, a reader of batches, or an iterable of them.
    """
    boxes = [box for batch in _batches(batches) if (box := _twinedge.bounds(_wkb(batch, geometry))) is not None]
    if not boxes:
        raise ValueError("there are no points")
    low, high = np.min(boxes, axis=0), np.max(boxes, axis=0)
    return (float(low[0]), float(low[1]), float(high[2]), float(high[3]))


def assign(batches: Any, grid: Grid, *, geometry: str = "geometry") -> Iterator[pa.RecordBatch]:
    """The rows of a table, each as often as it meets tiles, with the number of the tile in a column ``tile`` before the others.

    It is a generator of batches, one for each batch that comes, so ``mapInArrow`` of Spark takes it. O(points + tiles that meet).
    """
    import pyarrow as pa

    for batch in _batches(batches):
        rows, found = _twinedge.tiles_of(grid._native(), _wkb(batch, geometry))
        taken = batch.take(pa.array(rows))
        columns = [pa.array(found.astype(np.int64)), *taken.columns]
        yield pa.RecordBatch.from_arrays(columns, names=["tile", *batch.schema.names])


def assigned(batches: Any, grid: Grid, *, geometry: str = "geometry") -> dict[int, pa.Table]:
    """The table of each tile of the grid, empty ones included: what :func:`assign` says, grouped, in memory."""
    import pyarrow as pa
    import pyarrow.compute as pc

    given = _batches(batches)
    parts = [*assign(given, grid, geometry=geometry)]
    found: dict[int, pa.Table] = {}
    if parts:
        whole = pa.Table.from_batches(parts)
        found = {tile: whole.filter(pc.equal(whole["tile"], tile)) for tile in pc.unique(whole["tile"]).to_pylist()}
    nothing = pa.table({"feature": pa.array([], pa.uint32()), geometry: pa.array([], pa.binary())})
    return {tile: found.get(tile, nothing) for tile in range(len(grid))}


def audit_tile(
    batches: Any,
    grid: Grid,
    tile: int,
    *,
    gap_width: float | None = None,
    lake_width: float | None = None,
    accept_gaps: Iterable[Sequence[float]] | None = None,
    sliver_area: float | None = None,
    geometry: str = "geometry",
    feature: str = "feature",
) -> pa.RecordBatch:
    """The summary of one tile: a batch with one row, in the column ``summary``.

    ``batches`` must have every feature that meets the tile, as :func:`assign` says, each once and whole; others may be there, too. So a
    tile to which nothing was assigned is made of no batches, and must be made all the same. The limits are those of
    :func:`twinedge.audit`; if ``gap_width`` and ``sliver_area`` are given, summaries are smaller. O(n log n) for n segments.

    Raises
    ------
    TypeError
        Features have no numbers, or none of 32 bits.
    ValueError
        Two features have the same number; a geometry is malformed or not finite; the grid has no such tile.
    """
    import pyarrow as pa

    given = [(_numbers(batch, feature), _wkb(batch, geometry)) for batch in _batches(batches)]
    numbers = np.concatenate([numbers for numbers, _ in given]) if given else np.empty(0, np.uint32)
    geometries = [one for _, wkb in given for one in wkb]
    limits = _limits(gap_width, lake_width, accept_gaps, sliver_area)
    place = _count("tile", tile, 2**32)
    summary = _twinedge.summarise(grid._native(), place, numbers, geometries, limits)
    return pa.RecordBatch.from_pylist([{"summary": summary}], schema())


def audit_tiles(batches: Any, grid: Grid, **options: Any) -> Iterator[pa.RecordBatch]:
    """The summaries of the tiles that rows were assigned to: a generator of batches of one row each.

    The rows have the column ``tile`` of :func:`assign`, and all rows of a tile are there: a partition by ``tile``. Options are those of :func:`audit_tile`.
    """
    import pyarrow as pa
    import pyarrow.compute as pc

    given = [*_batches(batches)]
    if not given:
        return
    whole = pa.Table.from_batches(given)
    for tile in sorted(pc.unique(whole["tile"]).to_pylist()):
        yield audit_tile(whole.filter(pc.equal(whole["tile"], tile)), grid, tile, **options)


def merge(*batches: Any) -> pa.RecordBatch:
    """One summary of all in these batches, in whatever order: a batch with one row, or with none if there is none.

    Associative and commutative, down to the bytes. O(what the borders cut and the tiles found).

    Raises ``ValueError`` if they are of different grids or limits, or have a tile in common.
    """
    import pyarrow as pa

    summary = _twinedge.merge(_summaries(batches))
    return pa.RecordBatch.from_pylist([] if summary is None else [{"summary": summary}], schema())


def finish(
    *batches: Any,
    grid: Grid | None = None,
    coverage: bool = False,
    accept: Any = None,
    list: int | None = None,
    **limits: Any,
) -> Report:
    """The report on the layer, of the summaries of all tiles.

    It says what :func:`twinedge.audit` of the whole says: the verdict, the counts, and each violation and finding once, with its place;
    ``features`` are the numbers of the features. :meth:`Report.to_frame` and :meth:`Report.to_arrow` are tables of it.

    Parameters
    ----------
    batches
        Batches or tables with summaries, in any order.
    grid : Grid, optional
        Tiles that have no summary are made here, as those of nothing. Without it, every tile must be there.
    coverage, accept, list
        As for :func:`twinedge.audit`.
    limits
        Those of the tiles, for the empty ones.

    Raises
    ------
    ValueError
        Tiles are missing, or as :func:`merge`.
    """
    summaries = _summaries(batches)
    if grid is not None:
        have = {int(tile) for summary in summaries for tile in _twinedge.tiles_in(summary)}
        empty = [audit_tile([], grid, tile, **limits) for tile in range(len(grid)) if tile not in have]
        summaries += _summaries(empty)
    asked = {
        "coverage": bool(coverage),
        "limits": _limits(**limits),
        "snap": None,
        "name": None,
        "accept": _accepted(accept),
        "list": _twinedge.DEFAULT_LIST if list is None else _count("list", list),
    }
    return Report._told(_twinedge.finish(summaries, asked))


def _batches(given: Any) -> Iterator[pa.RecordBatch]:
    import pyarrow as pa

    if isinstance(given, pa.RecordBatch):
        yield given
    elif isinstance(given, pa.Table):
        yield from given.to_batches()
    elif isinstance(given, dict) or not hasattr(given, "__iter__"):
        raise TypeError(f"expected a table, a batch or an iterable of batches, not {type(given).__name__}")
    else:
        for one in given:
            yield from _batches(one)


def _column(batch: pa.RecordBatch, name: str) -> pa.Array:
    at = batch.schema.get_field_index(name)
    if at < 0:
        raise ValueError(f"there is no column {name!r}; there are {', '.join(batch.schema.names) or 'none'}")
    return batch.column(at)


def _wkb(batch: pa.RecordBatch, name: str) -> list[bytes | None]:
    column = _column(batch, name)
    found: list[bytes | None] = getattr(column, "storage", column).to_pylist()
    wrong = next((one for one in found if not isinstance(one, (bytes, type(None)))), None)
    if wrong is not None:
        raise TypeError(f"{name}: expected well-known binary, not {type(wrong).__name__}")
    return found


def _numbers(batch: pa.RecordBatch, name: str) -> Any:
    column = _column(batch, name)
    if column.null_count:
        raise ValueError(f"{name}: a feature has no number")
    numbers = column.to_numpy(zero_copy_only=False)
    if numbers.dtype.kind not in "iu":
        raise TypeError(f"{name}: expected integers, not {column.type}")
    if numbers.size and not (0 <= numbers.min() and numbers.max() < 2**32):
        raise ValueError(f"{name}: expected numbers from 0 to 4,294,967,295, not up to {numbers.max()}")
    return numbers.astype(np.uint32)


def _summaries(batches: Iterable[Any]) -> list[bytes]:
    return [one for given in batches for batch in _batches(given) for one in _wkb(batch, "summary") if one is not None]
