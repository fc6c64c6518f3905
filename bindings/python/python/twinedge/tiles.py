"""Audits and overlays of layers that are larger than one machine: tile by tile, on any engine, with the result of the whole.

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

Two layers are laid over each other in the same way, without rounds: see :class:`Overlay`.

Tables are those of Arrow, with a column ``geometry`` of well-known binary or GeoArrow and a column ``feature``, the number of each feature in the
layer: an integer from 0 to 4,294,967,295 that no two have in common. Whatever has an Arrow table has such columns: DuckDB, Dask, Polars, Spark,
GeoParquet read by pyarrow. GeoArrow is known by its extension type, or by that name in the metadata of the field: ``geoarrow.wkb``, and
``geoarrow.point`` to ``geoarrow.multipolygon`` with coordinates apart or interleaved, which are read where they are. This module needs pyarrow.

All tiles must be made with one grid, the same limits and the same cuts, and of one state of the layer. A tile that is made again of the same features
has the same bytes, so a worker that is lost loses nothing. Name the state in ``source``, such as the id of a snapshot and the filter: then tiles that
are made again after the layer was replaced are refused, where others would add up to the audit of no layer at all.
"""

from __future__ import annotations

import json
from collections.abc import Iterable, Iterator, Sequence
from dataclasses import dataclass, field
from typing import TYPE_CHECKING, Any

import numpy as np

from . import _twinedge
from ._columns import _batches, _by_tile, _column, _geometries, _numbers, _with_tiles, _wkb
from ._map import _keeps
from ._options import _accepted, _count, _limits
from ._options import _text as _options
from ._report import Report

if TYPE_CHECKING:
    import pyarrow as pa

__all__ = [
    "Cuts",
    "Grid",
    "Overlay",
    "assign",
    "assigned",
    "audit_tile",
    "audit_tiles",
    "bounds",
    "extents",
    "finish",
    "merge",
    "schema",
    "table",
]


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
    #: What the layer is: the id of a snapshot, a filter, the hash of a file. Cuts and tiles of different sources are not put together.
    source: str | None = None

    def __post_init__(self) -> None:
        box = _box(self.box)
        object.__setattr__(self, "box", box)
        if not self.state:
            object.__setattr__(self, "state", _twinedge.no_cuts(float(np.abs(box).max()), self.source))

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
        return Cuts(self.box, _twinedge.take(self.state, found), self.source)


@dataclass(frozen=True)
class Overlay:
    """The plan by which two layers are laid over each other in tiles, with the pieces of :func:`twinedge.overlay`, each once and whole.

    A feature begins in the tile that has the lower left corner of the box around it. From a first pass over both layers, :func:`extents`, the plan knows
    how far the features of each tile reach. Then :meth:`assign` gives a tile everything that comes near these, and :meth:`pieces` lays it over each
    other and keeps the pieces that begin there: that is where their first feature of the left layer begins, or, without one, that
    of the right layer. So borders of tiles cut nothing, and no tile needs another one.

    That is right for any layers, also those whose own features overlap or cross. Crossings are rounded as in the whole, to one grid. Where two of them,
    or a vertex and an edge, are about as close as its cells, the last bits may differ: cells are at most 2^-49 of the largest coordinate.

    >>> import pyarrow as pa, shapely
    >>> from twinedge import tiles
    >>> fields = tiles.table([shapely.box(x, 0, x + 2, 2) for x in (0, 2, 4)])
    >>> zones = tiles.table([shapely.box(1, 1, 5, 3)])
    >>> grid = tiles.Grid((0, 0, 6, 3), 3, 1)
    >>> plan = tiles.Overlay(grid, [*tiles.extents(fields, grid), *tiles.extents(zones, grid)])
    >>> left, right = (pa.Table.from_batches(plan.assign(layer)) for layer in (fields, zones))
    >>> of_tile = lambda rows, tile: rows.filter(pa.compute.equal(rows["tile"], tile))
    >>> found = [plan.pieces(of_tile(left, tile), of_tile(right, tile), tile) for tile in range(len(grid))]
    >>> pa.concat_tables(found).select(["left", "right"]).to_pylist()
    [{'left': [0], 'right': [0]}, {'left': [1], 'right': [0]}, {'left': [2], 'right': [0]}]
    """

    #: The tiles.
    grid: Grid
    #: What :func:`extents` found in both layers, in whatever batches and order; kept as a table with one row for each tile.
    extents: Any

    def __post_init__(self) -> None:
        import pyarrow as pa

        schema = _extents_schema()
        parts = [pa.table([_column(batch, name) for name in schema.names], schema.names).cast(schema) for batch in _batches(self.extents)]
        found = pa.concat_tables(parts or [schema.empty_table()]).group_by("tile")
        merged = found.aggregate([("x0", "min"), ("y0", "min"), ("x1", "max"), ("y1", "max")])
        columns = [merged[name] for name in ("tile", "x0_min", "y0_min", "x1_max", "y1_max")]
        object.__setattr__(self, "extents", pa.table(columns, schema=schema).sort_by("tile"))

    def _native(self) -> tuple[list[tuple[int, list[float]]], float]:
        """The extents, and the largest coordinate."""
        tiles, *sides = (column.to_pylist() for column in self.extents.columns)
        largest = max((abs(coordinate) for side in sides for coordinate in side), default=0.0)
        return [(tile, [*box]) for tile, box in zip(tiles, zip(*sides))], largest

    def assign(self, batches: Any, *, geometry: str = "geometry") -> Iterator[pa.RecordBatch]:
        """The rows of either layer with the tiles that need them, as :func:`assign` gives them: a generator. O(points + features · tiles).

        Raises ``ValueError`` if the extents are not those of all features.
        """
        extents, largest = self._native()
        for batch in _batches(batches):
            yield from _with_tiles(batch, *_twinedge.tiles_near(self.grid._native(), _geometries(batch, geometry), extents, largest))

    def pieces(
        self, left: Any, right: Any, tile: int, how: str = "intersection", *, geometry: str = "geometry", feature: str = "feature"
    ) -> pa.Table:
        """The pieces that begin in a tile, from the rows of both layers that were assigned to it.

        The columns are ``left`` and ``right``, lists of the numbers of the features that cover a piece, and ``geometry``, well-known binary. Pieces come in
        order of these numbers; a tile that is made again has the same bytes. ``how`` is as for :func:`twinedge.overlay`. O((n + k) log n) for n
        segments that meet k times.

        Raises ``TypeError`` and ``ValueError`` as :func:`audit_tile`.
        """
        import pyarrow as pa

        layers = []
        for batches in (left, right):
            given = [*_batches(batches)]
            numbers = [np.empty(0, np.uint32), *(_numbers(batch, feature) for batch in given)]
            layers.append((np.concatenate(numbers), [_geometries(batch, geometry) for batch in given]))
        keeps = _keeps(how)
        _, largest = self._native()
        kept = [keeps(True, True), keeps(True, False), keeps(False, True)]
        found = _twinedge.overlay_tile(self.grid._native(), _count("tile", tile, 2**32), layers, largest, kept)
        kinds = {"left": pa.list_(pa.int64()), "right": pa.list_(pa.int64()), "geometry": pa.binary()}
        columns = zip(*found) if found else ((), (), ())
        return pa.table({name: pa.array(column, kind) for (name, kind), column in zip(kinds.items(), columns)})


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
    # The distance depends on the box only.
    margin = None if cuts is None else Cuts(cuts.box).state
    for batch in _batches(batches):
        yield from _with_tiles(batch, *_twinedge.tiles_of(grid._native(), _geometries(batch, geometry), margin))


def extents(batches: Any, grid: Grid, *, geometry: str = "geometry") -> Iterator[pa.RecordBatch]:
    """The boxes around the features that begin in each tile: columns ``tile``, ``x0``, ``y0``, ``x1``, ``y1``, for :class:`Overlay`. O(points).

    It is a generator of batches, one for each batch that comes. A feature begins in the tile that has the lower left corner of the box around it.
    """
    import pyarrow as pa

    schema = _extents_schema()
    for batch in _batches(batches):
        found = _twinedge.extents(grid._native(), _geometries(batch, geometry))
        yield pa.RecordBatch.from_pylist([dict(zip(schema.names, (tile, *box))) for tile, box in found], schema)


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
    source: str | None = None,
    gap_width: float | None = None,
    lake_width: float | None = None,
    accept_gaps: Iterable[Sequence[float]] | None = None,
    sliver_area: float | None = None,
    geometry: str = "geometry",
    feature: str = "feature",
) -> pa.RecordBatch:
    """The summary of one tile: a batch with one row, in the column of :func:`schema`. ``source`` is that of the cuts, if there are some.

    ``batches`` must have every feature that meets the tile, as :func:`assign` says, each once and whole; others may be there, too. So a
    tile to which nothing was assigned is made of no batches, and must be made all the same. The limits are those of
    :func:`twinedge.audit`; if ``gap_width`` and ``sliver_area`` are given, summaries are smaller. O(n log n) for n segments.

    Raises
    ------
    TypeError
        Features have no numbers, or none of 32 bits.
    ValueError
        Two features have the same number; a geometry is malformed or not finite; the grid has no such tile; not all cuts are found yet, or they have
        another source.
    """
    import pyarrow as pa

    given = [(_numbers(batch, feature), _geometries(batch, geometry)) for batch in _batches(batches)]
    numbers = np.concatenate([numbers for numbers, _ in given]) if given else np.empty(0, np.uint32)
    geometries = [column for _, column in given]
    limits = _options(None, **_limits(gap_width, lake_width, accept_gaps, sliver_area))
    place = _count("tile", tile, 2**32)
    if cuts is not None and source not in (None, cuts.source):
        raise ValueError(f"source: the cuts are those of {cuts.source!r}, not of {source!r}")
    state = None if cuts is None else cuts.state
    summary = _twinedge.summarise(grid._native(), place, numbers, geometries, limits, state, source)
    return pa.RecordBatch.from_pylist([{"summary": summary}], schema())


def audit_tiles(batches: Any, grid: Grid, **options: Any) -> Iterator[pa.RecordBatch]:
    """The summaries of the tiles that rows were assigned to: a generator of batches of one row each.

    The rows have the column ``tile`` of :func:`assign`, and all rows of a tile are there: a partition by ``tile``. Options are those of :func:`audit_tile`.
    """
    return (audit_tile(part, grid, tile, **options) for tile, part in _by_tile(batches))


def merge(*batches: Any) -> pa.RecordBatch:
    """One summary of all in these batches, in whatever order: a batch with one row, or with none if there is none.

    Associative and commutative, down to the bytes. O(what the borders cut and the tiles found).

    Raises ``ValueError`` if they are of different sources, grids or limits, have a tile in common, or only some were made with cuts: tiles are named by
    column and row.
    """
    import pyarrow as pa

    summary = _twinedge.merge(_binary(batches, "summary"))
    return pa.RecordBatch.from_pylist([] if summary is None else [{"summary": summary}], schema())


def finish(
    *batches: Any,
    grid: Grid | None = None,
    labels: Sequence[Any] | None = None,
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
    labels : sequence, optional
        The labels of the features, by number, as ``name`` of :func:`twinedge.audit` finds them. Ids of findings are made of labels: with the same labels,
        they are the ids of that audit. Numbers of features must then be positions.
    coverage, accept, list, explain
        As for :func:`twinedge.audit`.
    crs
        The reference system of that layer.
    limits
        Those of the tiles, for the empty ones. These need no cuts.

    Raises
    ------
    ValueError
        Tiles are missing, which are named by column and row, or a finding is about a feature without a label, or as :func:`merge`.
    """
    asked = _options(list, coverage=bool(coverage), explain=bool(explain), **_limits(**limits), allow_empty=True)
    whole = None if grid is None else grid._native()
    names = [] if labels is None else [*labels]
    ids = [None if label is None or label != label else str(label) for label in names]
    told = _twinedge.finish(_binary(batches, "summary"), whole, asked, _accepted(accept), ids)
    return Report._told(told, {"feature": names} if names else None, crs)


def _box(given: Any) -> tuple[float, ...]:
    box = tuple(map(float, given))
    if len(box) != 4:
        raise ValueError(f"box: expected (x0, y0, x1, y1), not {given!r}")
    return box


def _extents_schema() -> pa.Schema:
    import pyarrow as pa

    return pa.schema([("tile", pa.int64()), *((side, pa.float64()) for side in ("x0", "y0", "x1", "y1"))])


def _binary(batches: Iterable[Any], name: str) -> list[bytes]:
    return [one for given in batches for batch in _batches(given) for one in _wkb(batch, name) if one is not None]
