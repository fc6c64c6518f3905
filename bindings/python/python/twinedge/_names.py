"""Names of the records of a report in the structure that was judged."""

from __future__ import annotations

from typing import Any, NamedTuple, Protocol

import numpy as np
import numpy.typing as npt


class Names(Protocol):
    """The names of the records of one kind, by position."""

    def __len__(self) -> int: ...
    def __getitem__(self, index: int, /) -> Any: ...


class Side(NamedTuple):
    """A half-edge of a list of faces: the side of ``face`` that begins at its corner ``corner``, both counted from 0."""

    face: int
    corner: int

    def __str__(self) -> str:
        return f"side {self.corner} of face {self.face}"


class Pairs:
    """Half-edges by the names of their origins and targets; ``None`` where there is no such vertex."""

    def __init__(self, vertices: list[Any], half_edges: npt.NDArray[np.int64]) -> None:
        self._vertices, self._half_edges = vertices, half_edges

    def __len__(self) -> int:
        return len(self._half_edges)

    def __getitem__(self, index: int) -> tuple[Any, Any]:
        origin, target = (self._vertices[v] if v >= 0 else None for v in self._half_edges[index].tolist())
        return origin, target


class Sides:
    """Half-edges of a list of faces, which are numbered corner by corner."""

    def __init__(self, offsets: npt.NDArray[np.uint32]) -> None:
        self._offsets = offsets

    def __len__(self) -> int:
        return int(self._offsets[-1])

    def __getitem__(self, index: int) -> Side:
        # The last face that begins there: earlier ones have no corners.
        face = int(np.searchsorted(self._offsets, index, side="right")) - 1
        return Side(face, index - int(self._offsets[face]))
