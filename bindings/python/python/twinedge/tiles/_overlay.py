"""Overlays of two layers, tile by tile."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

import numpy as np

from .. import _twinedge
from .._columns import _batches, _column, _geometries, _numbers, _with_tiles
from .._map import _keeps
from .._options import _count
from ._grid import Grid

if TYPE_CHECKING:
    import pyarrow as pa


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
        """The rows of either layer with the tiles that need them, in a column ``tile`` before the others, whose types and metadata stay: a generator. O(points + features · tiles).

        Raises ``ValueError`` if the extents are not those of all features.
        """
        extents, largest = self._native()
        for batch in _batches(batches):
            yield from _with_tiles(batch, *_twinedge.tiles_near(self.grid.state, _geometries(batch, geometry), extents, largest))

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
        found = _twinedge.overlay_tile(self.grid.state, _count("tile", tile, 2**32), layers, largest, kept)
        kinds = {"left": pa.list_(pa.int64()), "right": pa.list_(pa.int64()), "geometry": pa.binary()}
        columns = zip(*found) if found else ((), (), ())
        return pa.table({name: pa.array(column, kind) for (name, kind), column in zip(kinds.items(), columns)})


def extents(batches: Any, grid: Grid, *, geometry: str = "geometry") -> Iterator[pa.RecordBatch]:
    """The boxes around the features that begin in each tile: columns ``tile``, ``x0``, ``y0``, ``x1``, ``y1``, for :class:`Overlay`. O(points).

    It is a generator of batches, one for each batch that comes. A feature begins in the tile that has the lower left corner of the box around it.
    """
    import pyarrow as pa

    schema = _extents_schema()
    for batch in _batches(batches):
        found = _twinedge.extents(grid.state, _geometries(batch, geometry))
        yield pa.RecordBatch.from_pylist([dict(zip(schema.names, (tile, *box))) for tile, box in found], schema)


def _extents_schema() -> pa.Schema:
    import pyarrow as pa

    return pa.schema([("tile", pa.int64()), *((side, pa.float64()) for side in ("x0", "y0", "x1", "y1"))])
