"""Grids, and the cuts of the edges of a layer."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass, field
from typing import TYPE_CHECKING, Any

import numpy as np

from .. import _twinedge
from .._columns import _batches, _binary, _by_tile, _bytes, _geometries
from .._options import _count

if TYPE_CHECKING:
    import pyarrow as pa


@dataclass(frozen=True)
class Grid:
    """The tiles that divide a box evenly, numbered from 0: row by row, from the lower left. What lies outside belongs to the tiles at the border.

    Any box will do, if all tiles have the same one. :meth:`fitted` makes a grid whose tiles have about the same number of
    vertices. Grids are bytes, and equal ones are equal: a worker gets them as an argument.
    """

    #: The grid.
    state: bytes = field(repr=False)

    def __init__(self, box: Any, columns: int, rows: int) -> None:
        corners = _box(box)
        counts = [_count(name, count, 2**20) for name, count in (("columns", columns), ("rows", rows))]
        object.__setattr__(self, "state", _twinedge.even_grid(corners, *counts))

    @classmethod
    def fitted(cls, batches: Any, most: int, *, geometry: str = "geometry") -> Grid:
        """The grid whose tiles each have about ``most`` of the vertices in these batches, which may be a sample of the layer: then fewer. O(n log n).

        Equal vertices make equal grids. Lines lead through the middle of the vertices, so no tile is much larger than the others, and a city is divided more
        than the country around it.
        """
        found = [_twinedge.survey(_geometries(batch, geometry)) for batch in _batches(batches)]
        return cls._of_sample([sample for *_, sample in found], most)

    @classmethod
    def _of_sample(cls, samples: list[Any], most: int) -> Grid:
        """The grid of samples as the survey makes them."""
        count = _count("vertices", most, 2**53)
        grid = object.__new__(cls)
        object.__setattr__(grid, "state", _twinedge.fitted_grid(np.concatenate([np.empty((0, 2)), *samples]), count))
        return grid

    def __len__(self) -> int:
        return len(self.boxes())

    def boxes(self) -> list[tuple[float, float, float, float]]:
        """The boxes ``(x0, y0, x1, y1)`` of all tiles, infinite where the grid ends. O(tiles)."""
        return [(x0, y0, x1, y1) for x0, y0, x1, y1 in _twinedge.boxes(self.state)]


@dataclass(frozen=True)
class Cuts:
    """The places where edges meet elsewhere than at vertices, and the edges that are cut there: first none, and more after each round.

    In a round, tiles are searched, on any worker and in any order, and what all of them found is taken; then :meth:`tiles` says which tiles the
    next round is for. The search ends when there are none. Pieces come from :func:`divide` with cuts of any round. Cuts are bytes, in proportion to the number of
    cuts: a worker gets them as an argument, or as a broadcast variable.
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
        return _twinedge.tiles_to_search(self.state, grid.state)

    def search(self, batches: Any, grid: Grid, tile: int) -> pa.RecordBatch:
        """The cuts that a tile finds in this round: a batch with one row, in the column ``found``, which is binary.

        ``batches`` must have every piece of the tile; those of others may be there, too. A search that is repeated finds the same bytes.
        O(n log n + k) for k cuts.

        Raises ``ValueError`` if there are so many cuts that the coverage cannot be judged in tiles.
        """
        import pyarrow as pa

        pieces = [_binary(batch, "piece") for batch in _batches(batches)]
        found = _twinedge.search(self.state, grid.state, _count("tile", tile, 2**32), pieces)
        return pa.RecordBatch.from_pydict({"found": pa.array([found], pa.binary())})

    def search_tiles(self, batches: Any, grid: Grid) -> Iterator[pa.RecordBatch]:
        """The cuts that tiles find in this round, from their pieces: a generator, for rows as :func:`audit_tiles` takes them."""
        wanted = {*self.tiles(grid)}
        return (self.search(part, grid, tile) for tile, part in _by_tile(batches) if tile in wanted)

    def take(self, *batches: Any) -> Cuts:
        """The cuts after a round, in which these batches were found, in any order. What a tile found may be there twice.

        Raises ``ValueError`` if they were found in another round, or of another layer; or if edges bend so often that the coverage cannot be judged
        in tiles: then :func:`finish` without cuts says all else.
        """
        found = _bytes(batches, "found")
        if not found:
            raise ValueError("found: there is nothing that a tile found in this round")
        return Cuts(self.box, _twinedge.take(self.state, found), self.source)


def _box(given: Any) -> tuple[float, float, float, float]:
    box = tuple(map(float, given))
    if len(box) != 4:
        raise ValueError(f"box: expected (x0, y0, x1, y1), not {given!r}")
    return box
