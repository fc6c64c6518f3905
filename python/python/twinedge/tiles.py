"""Audits of layers that are larger than one machine: tile by tile, on any engine, with the result of the audit of the whole.

A grid divides the plane. Each tile is judged alone, from the features that meet it, and its summary is a few bytes for what it found and for
what its border cuts. Summaries add up, in any order::

    assign ─► (group by tile) ─► audit_tile ─► merge … merge ─► finish

Where edges meet elsewhere than at vertices, what features cover is known once edges are cut, alike in all tiles. Cuts are found in a
few rounds, of which only the first one takes all tiles: see :class:`Cuts`.

>>> import shapely, twinedge
>>> from twinedge import tiles
>>> parcels = [shapely.box(0, 0, 2, 2), shapely.box(1, 1, 3, 3)]
>>> features = tiles.table(parcels)
>>> grid = tiles.Grid(tiles.bounds(features), 2, 2)
>>> cuts = tiles.Cuts(tiles.bounds(features))
>>> while found := [cuts.search(features, grid, tile) for tile in cuts.tiles(grid)]:
...     cuts = cuts.take(*found)
>>> parts = [tiles.audit_tile(features, grid, tile, cuts=cuts) for tile in tiles.assigned(features, grid, cuts)]
>>> report = tiles.finish(tiles.merge(parts[:2]), *parts[2:])
>>> [(finding.rule, finding.features, finding.area) for finding in report.findings]
[('C1', (0, 1), 1.0)]

Tables are those of Arrow, with a column ``geometry`` of well-known binary or GeoArrow and a column ``feature``, the number of each feature in the
layer: an integer from 0 to 4,294,967,295 that no two have in common. Whatever has an Arrow table has such columns: DuckDB, Dask, Polars, Spark,
GeoParquet read by pyarrow. GeoArrow is known by its extension type, or by that name in the metadata of the field: ``geoarrow.wkb``, and
``geoarrow.point`` to ``geoarrow.multipolygon`` with coordinates apart or interleaved, which are read where they are. This module needs pyarrow.

All tiles must be made with one grid, the same limits and the same cuts. A tile that is made again of the same features has the same bytes, so a
worker that is lost loses nothing.
"""

from __future__ import annotations

import json
from collections.abc import Iterable, Iterator, Sequence
from dataclasses import dataclass, field
from typing import TYPE_CHECKING, Any

import numpy as np

from . import _twinedge
from ._audit import _accepted, _limits
from ._report import Report
from ._validate import _count

if TYPE_CHECKING:
    import pyarrow as pa

__all__ = ["Cuts", "Grid", "assign", "assigned", "audit_tile", "audit_tiles", "bounds", "finish", "merge", "schema", "table"]


#: The types of GeoArrow that are read without copying, and the lists around their coordinates.
_DEPTHS = {"point": 0, "linestring": 1, "multipoint": 1, "polygon": 2, "multilinestring": 2, "multipolygon": 3}

#: The most bytes that go into one batch: offsets of 32 bits reach no farther.
_MOST = 2**31 - 1


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
        object.__setattr__(self, "box", _box(self.box))
        for name in ("columns", "rows"):
            object.__setattr__(self, name, _count(name, getattr(self, name), 65_536))

    def __len__(self) -> int:
        return self.columns * self.rows

    def _native(self) -> tuple[Sequence[float], int, int]:
        return ([*self.box], self.columns, self.rows)


@dataclass(frozen=True)
class Cuts:
    """The places where edges meet elsewhere than at vertices, and the edges that are cut there: first none, and more after each round.

    In a round, tiles are searched, on any worker and in any order, and what all of them found is taken; then :meth:`tiles` says which tiles the
    next round is for. It ends when these are none. Rows are those of ``assign(batches, grid, cuts)``, with cuts of any round. Cuts are bytes, as
    many as there is cut: a worker gets them as an argument, or as a broadcast variable.
    """

    #: The box ``(x0, y0, x1, y1)`` around the layer, as :func:`bounds` returns it. It must be the same in all rounds.
    box: tuple[float, float, float, float]
    #: The cuts. Equal ones have the same bytes.
    state: bytes = field(default=b"", repr=False)

    def __post_init__(self) -> None:
        box = _box(self.box)
        object.__setattr__(self, "box", box)
        if not self.state:
            object.__setattr__(self, "state", _twinedge.no_cuts(float(np.abs(box).max())))

    def tiles(self, grid: Grid) -> list[int]:
        """The tiles that have something to find in this round: none, if all cuts are found. O(tiles · pieces that the last round made)."""
        return _twinedge.tiles_to_search(self.state, grid._native())

    def search(self, batches: Any, grid: Grid, tile: int, *, geometry: str = "geometry") -> pa.RecordBatch:
        """The cuts that a tile finds in this round: a batch with one row, in the column ``found``, which is binary.

        ``batches`` must have every feature that :func:`assign` says, whole; others may be there, too. A search that is repeated finds the
        same bytes. O(n log n + k) for k cuts.

        Raises ``ValueError`` if a geometry is malformed or lies farther out than the box, and if there are so many cuts that the coverage
        cannot be judged in tiles.
        """
        import pyarrow as pa

        geometries = [_geometries(batch, geometry) for batch in _batches(batches)]
        found = _twinedge.search(self.state, grid._native(), _count("tile", tile, 2**32), geometries)
        return pa.RecordBatch.from_pydict({"found": pa.array([found], pa.binary())})

    def search_tiles(self, batches: Any, grid: Grid, **options: Any) -> Iterator[pa.RecordBatch]:
        """The cuts that tiles find in this round, from the rows that were assigned to them: a generator, for rows as :func:`audit_tiles` takes them."""
        wanted = {*self.tiles(grid)}
        return (self.search(part, grid, tile, **options) for tile, part in _by_tile(batches) if tile in wanted)

    def take(self, *batches: Any) -> Cuts:
        """The cuts after a round, in which these batches were found, in any order. What a tile found may be there twice.

        Raises ``ValueError`` if they were found in another round, or of another layer; or if edges bend so often that the coverage cannot be judged
        in tiles: then :func:`finish` without cuts says all else.
        """
        found = _binary(batches, "found")
        if not found:
            raise ValueError("found: there is nothing that a tile found in this round")
        return Cuts(self.box, _twinedge.take(self.state, found))


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
    """The columns of summaries, which are binary: ``summary``, and ``cut``, that of the same tile with its edges cut, null without :class:`Cuts`."""
    import pyarrow as pa

    return pa.schema([("summary", pa.binary()), ("cut", pa.binary())])


def bounds(batches: Any, *, geometry: str = "geometry") -> tuple[float, float, float, float]:
    """The box around all geometries. O(points).

    ``batches`` is a table, a batch, a reader of batches, or an iterable of them.
    """
    boxes = [box for batch in _batches(batches) if (box := _twinedge.bounds(_geometries(batch, geometry))) is not None]
    if not boxes:
        raise ValueError("there are no points")
    low, high = np.min(boxes, axis=0), np.max(boxes, axis=0)
    return (float(low[0]), float(low[1]), float(high[2]), float(high[3]))


def assign(batches: Any, grid: Grid, cuts: Cuts | None = None, *, geometry: str = "geometry") -> Iterator[pa.RecordBatch]:
    """The rows of a table, each as often as it meets tiles, with the number of the tile in a column ``tile`` before the others, whose types and metadata stay.

    It is a generator of batches, one or more for each batch that comes, so ``mapInArrow`` of Spark takes it. None has more than 2 GiB, the most that
    offsets of 32 bits reach, unless a row alone has more. With cuts, of any round, a feature goes to tiles that it comes very near, too, as edges are
    bent a little where they are cut. O(points + tiles that meet).
    """
    import pyarrow as pa

    # The distance depends on the box only.
    margin = None if cuts is None else Cuts(cuts.box).state
    for batch in _batches(batches):
        rows, found = _twinedge.tiles_of(grid._native(), _geometries(batch, geometry), margin)
        schema = pa.schema([pa.field("tile", pa.int64()), *batch.schema], batch.schema.metadata)
        for part in _parts(batch, rows):
            taken = batch.take(pa.array(rows[part]))
            columns = [pa.array(found[part].astype(np.int64)), *taken.columns]
            yield pa.RecordBatch.from_arrays(columns, schema=schema)


def assigned(batches: Any, grid: Grid, cuts: Cuts | None = None, *, geometry: str = "geometry") -> dict[int, pa.Table]:
    """The table of each tile of the grid, empty ones included: what :func:`assign` says, grouped, in memory."""
    import pyarrow as pa

    given = [*_batches(batches)]
    found = dict(_by_tile(assign(given, grid, cuts, geometry=geometry)))
    schema = given[0].schema if given else pa.schema([("feature", pa.uint32()), (geometry, pa.binary())])
    return {tile: found.get(tile, schema.empty_table()) for tile in range(len(grid))}


def audit_tile(
    batches: Any,
    grid: Grid,
    tile: int,
    *,
    cuts: Cuts | None = None,
    gap_width: float | None = None,
    lake_width: float | None = None,
    accept_gaps: Iterable[Sequence[float]] | None = None,
    sliver_area: float | None = None,
    geometry: str = "geometry",
    feature: str = "feature",
) -> pa.RecordBatch:
    """The summary of one tile: a batch with one row, in the columns of :func:`schema`. With cuts it has both.

    ``batches`` must have every feature that meets the tile, as :func:`assign` says, each once and whole; others may be there, too. So a
    tile to which nothing was assigned is made of no batches, and must be made all the same. The limits are those of
    :func:`twinedge.audit`; if ``gap_width`` and ``sliver_area`` are given, summaries are smaller. O(n log n) for n segments.

    Raises
    ------
    TypeError
        Features have no numbers, or none of 32 bits.
    ValueError
        Two features have the same number; a geometry is malformed or not finite; the grid has no such tile; not all cuts are found yet.
    """
    import pyarrow as pa

    given = [(_numbers(batch, feature), _geometries(batch, geometry)) for batch in _batches(batches)]
    numbers = np.concatenate([numbers for numbers, _ in given]) if given else np.empty(0, np.uint32)
    geometries = [column for _, column in given]
    limits = _limits(gap_width, lake_width, accept_gaps, sliver_area)
    place = _count("tile", tile, 2**32)
    state = None if cuts is None else cuts.state
    summary, cut = _twinedge.summarise(grid._native(), place, numbers, geometries, limits, state)
    return pa.RecordBatch.from_pylist([{"summary": summary, "cut": cut}], schema())


def audit_tiles(batches: Any, grid: Grid, **options: Any) -> Iterator[pa.RecordBatch]:
    """The summaries of the tiles that rows were assigned to: a generator of batches of one row each.

    The rows have the column ``tile`` of :func:`assign`, and all rows of a tile are there: a partition by ``tile``. Options are those of :func:`audit_tile`.
    """
    return (audit_tile(part, grid, tile, **options) for tile, part in _by_tile(batches))


def merge(*batches: Any) -> pa.RecordBatch:
    """One summary of all in these batches, in whatever order: a batch with one row, or with none if there is none. Both columns are merged.

    Associative and commutative, down to the bytes. O(what the borders cut and the tiles found).

    Raises ``ValueError`` if they are of different grids or limits, have a tile in common, or only some were made with cuts: tiles are named by column
    and row.
    """
    import pyarrow as pa

    summary, cut = _twinedge.merge(*_summaries(batches))
    return pa.RecordBatch.from_pylist([] if summary is None else [{"summary": summary, "cut": cut}], schema())


def finish(
    *batches: Any,
    grid: Grid | None = None,
    coverage: bool = False,
    accept: Any = None,
    list: int | None = None,
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
    coverage, accept, list
        As for :func:`twinedge.audit`.
    crs
        The reference system of that layer.
    limits
        Those of the tiles, for the empty ones. These need no cuts.

    Raises
    ------
    ValueError
        Tiles are missing, which are named by column and row, or as :func:`merge`.
    """
    summaries, cuts = _summaries(batches)
    if grid is not None:
        have = {int(tile) for summary in summaries for tile in _twinedge.tiles_in(summary)}
        empty = [audit_tile([], grid, tile, **limits) for tile in range(len(grid)) if tile not in have]
        nothing, _ = _summaries(empty)
        summaries += nothing
        # In an empty tile there is nothing to cut.
        cuts += nothing if cuts else []
    asked = {
        "coverage": bool(coverage),
        "limits": _limits(**limits),
        "snap": None,
        "edges": None,
        "name": None,
        "accept": _accepted(accept),
        "list": _twinedge.DEFAULT_LIST if list is None else _count("list", list),
    }
    return Report._told(_twinedge.finish(summaries, cuts, asked), crs=crs)


def _box(given: Any) -> tuple[float, ...]:
    box = tuple(map(float, given))
    if len(box) != 4:
        raise ValueError(f"box: expected (x0, y0, x1, y1), not {given!r}")
    return box


def _parts(batch: pa.RecordBatch, rows: Any) -> Iterator[slice]:
    """The stretches of some rows of a batch, in order, each of which fits into one batch. O(rows + values of the batch)."""
    ends = np.cumsum(sum(map(_sizes, batch.columns), np.zeros(len(batch), np.int64))[rows])
    start = 0
    while start < len(rows) or start == 0:
        before = ends[start - 1] if start else 0
        end = max(int(np.searchsorted(ends, before + _MOST, "right")), start + 1)
        yield slice(start, end)
        start = end


def _sizes(column: pa.Array) -> Any:
    """The number of bytes of each value, or more."""
    import pyarrow as pa
    import pyarrow.compute as pc

    kind, count = column.type, len(column)
    if isinstance(kind, pa.BaseExtensionType):
        return _sizes(column.storage)
    if pa.types.is_struct(kind):
        return sum((_sizes(column.field(place)) for place in range(kind.num_fields)), np.ones(count, np.int64))
    if pa.types.is_fixed_size_list(kind):
        step = kind.list_size
        return 1 + _sizes(column.values.slice(column.offset * step, count * step)).reshape(count, step).sum(axis=1)
    if pa.types.is_list(kind) or pa.types.is_large_list(kind) or pa.types.is_map(kind):
        before = np.concatenate([[0], np.cumsum(_sizes(column.values))])
        return 8 + np.diff(before[column.offsets.to_numpy()])
    if any(is_of(kind) for is_of in (pa.types.is_binary, pa.types.is_large_binary, pa.types.is_string, pa.types.is_large_string)):
        return 8 + pc.binary_length(column).fill_null(0).to_numpy(zero_copy_only=False).astype(np.int64)
    return np.full(count, 16)


def _by_tile(batches: Any) -> Iterator[tuple[int, pa.Table]]:
    """The rows of each tile that has some, in order. O(n log n)."""
    import pyarrow as pa

    parts: dict[int, list[pa.RecordBatch]] = {}
    for batch in _batches(batches):
        tiles = batch["tile"].to_numpy(zero_copy_only=False)
        order = np.argsort(tiles, kind="stable")
        found, starts = np.unique(tiles[order], return_index=True)
        for tile, rows in zip(found.tolist(), np.split(order, starts[1:])):
            parts.setdefault(tile, []).append(batch.take(pa.array(rows)))
    for tile in sorted(parts):
        yield tile, pa.Table.from_batches(parts.pop(tile))


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


def _geometries(batch: pa.RecordBatch, name: str) -> list[bytes | None] | dict[str, Any]:
    """The geometries: well-known binary, or the arrays of GeoArrow, which are not copied."""
    column, field = _column(batch, name), batch.schema.field(name)
    extension: str | None = getattr(field.type, "extension_name", None)
    about = field.type.__arrow_ext_serialize__() if extension is not None else b""
    if extension is None and field.metadata:
        extension = field.metadata.get(b"ARROW:extension:name", b"").decode()
        about = field.metadata.get(b"ARROW:extension:metadata", b"")
    of_file = (batch.schema.metadata or {}).get(b"geo", b"")
    said = [_said(about), _said(of_file).get("columns", {}).get(name, {})]
    edges = next((one["edges"] for one in said if one.get("edges") not in (None, "planar")), None)
    if edges is not None:
        raise ValueError(f"{name}: the metadata say that edges are {edges}; tiles take edges as straight, also of this column if it is given without these metadata")
    kind = (extension or "").removeprefix("geoarrow.")
    if kind not in _DEPTHS:
        return _wkb(batch, name)
    inner = getattr(column, "storage", column)
    missing = inner.is_null().to_numpy(zero_copy_only=False) if inner.null_count else None
    length, offsets = len(inner), []
    for _ in range(_DEPTHS[kind]):
        if not hasattr(inner, "offsets"):
            raise TypeError(f"{name}: expected the lists of {extension}, not {inner.type}")
        offsets.append(inner.offsets.to_numpy())
        inner = inner.values
    x, y = _coordinates(inner, kind == "point", f"{name}: expected the coordinates of {extension}, not {inner.type}")
    return {"kind": kind, "offsets": offsets, "x": x, "y": y, "length": length, "missing": missing}


def _said(metadata: bytes) -> dict[str, Any]:
    """The members of metadata, if they are JSON."""
    try:
        found = json.loads(metadata or b"{}")
    except ValueError:
        return {}
    return found if isinstance(found, dict) else {}


def _coordinates(points: pa.Array, may_lack: bool, wrong: str) -> tuple[Any, Any]:
    """The coordinates of points, which are apart or interleaved. Points that are missing may lack them."""
    import pyarrow as pa

    if pa.types.is_fixed_size_list(points.type) and points.type.list_size >= 2:
        step = points.type.list_size
        values = points.values.slice(points.offset * step, len(points) * step)
        sides = [values, values]
    elif pa.types.is_struct(points.type) and points.type.get_field_index("x") >= 0 and points.type.get_field_index("y") >= 0:
        step, sides = 1, [points.field("x"), points.field("y")]
    else:
        raise TypeError(wrong)
    if any(side.type != pa.float64() or (side.null_count and not may_lack) for side in sides):
        raise TypeError(wrong)
    sides = [side.fill_null(np.nan) if side.null_count else side for side in sides]
    x, y = (side.to_numpy() for side in sides)
    return (x, y) if step == 1 else (x[::step], y[1::step])


def _wkb(batch: pa.RecordBatch, name: str) -> list[bytes | None]:
    column = _column(batch, name)
    found: list[bytes | None] = getattr(column, "storage", column).to_pylist()
    wrong = next((one for one in found if not isinstance(one, (bytes, type(None)))), None)
    if wrong is not None:
        raise TypeError(f"{name}: expected well-known binary or GeoArrow, not {type(wrong).__name__}")
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


def _binary(batches: Iterable[Any], name: str) -> list[bytes]:
    return [one for given in batches for batch in _batches(given) for one in _wkb(batch, name) if one is not None]


def _summaries(batches: Iterable[Any]) -> tuple[list[bytes], list[bytes]]:
    """The summaries, and those with edges cut."""
    given = [batch for one in batches for batch in _batches(one)]
    return _binary(given, "summary"), _binary((batch for batch in given if "cut" in batch.schema.names), "cut")
