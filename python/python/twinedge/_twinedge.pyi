from typing import Any, Final, final

import numpy as np
import numpy.typing as npt

__all__ = [
    "DEFAULT_LIST",
    "FINDING_KINDS",
    "KINDS",
    "Map",
    "PRESETS",
    "REPORT_SCHEMA",
    "__version__",
    "audit",
    "audit_faces",
    "bounds",
    "build_map",
    "clean",
    "diff",
    "explain",
    "finish",
    "merge",
    "no_cuts",
    "search",
    "summarise",
    "take",
    "tiles_in",
    "tiles_of",
    "tiles_to_search",
    "validate",
]

__version__: Final[str]
REPORT_SCHEMA: Final[str]
DEFAULT_LIST: Final[int]
PRESETS: Final[list[str]]
KINDS: Final[list[str]]
FINDING_KINDS: Final[list[str]]

# A report as JSON; its findings as GeoJSON, with warnings; and as a list of accepted ones.
_Told = tuple[str, str | None, list[str], str]
_Grid = tuple[Any, int, int]
# Well-known binary, or a column of GeoArrow.
_Geometries = list[bytes | None] | dict[str, Any]
_Polygons = list[list[list[list[float]]]]

def validate(
    columns: dict[str, Any], vertices: int | None, faces: int | None, asked: dict[str, Any]
) -> str: ...
def explain(violation: str) -> tuple[str, str]: ...
def audit(
    source: dict[str, Any], map: dict[str, Any], mesh: dict[str, Any], timeout: float | None
) -> tuple[_Told, npt.NDArray[np.uint32] | None]: ...
def audit_faces(vertices: int, corners: Any, offsets: Any, asked: dict[str, Any]) -> _Told: ...
def diff(old: str, new: str) -> tuple[list[str], list[str], list[str], int]: ...
def clean(
    source: dict[str, Any],
    limits: dict[str, Any],
    cell: float | None,
    overlap: str,
    chooses_width: bool,
    gaps_to: list[int] | None,
) -> tuple[str, list[tuple[int, str | None]]]: ...
def build_map(source: dict[str, Any], cell: float | None) -> Map: ...
def bounds(geometries: _Geometries) -> list[float] | None: ...
def tiles_of(
    of: _Grid, geometries: _Geometries, cut: bytes | None
) -> tuple[npt.NDArray[np.uint64], npt.NDArray[np.uint64]]: ...
def no_cuts(largest: float) -> bytes: ...
def tiles_to_search(cut: bytes, of: _Grid) -> list[int]: ...
def search(cut: bytes, of: _Grid, at: int | None, geometries: list[_Geometries]) -> bytes: ...
def take(cut: bytes, found: list[bytes]) -> bytes: ...
def summarise(
    of: _Grid, at: int | None, numbers: Any, geometries: list[_Geometries], limits: dict[str, Any], cut: bytes | None
) -> tuple[bytes, bytes | None]: ...
def tiles_in(summary: bytes) -> list[int]: ...
def merge(summaries: list[bytes], cuts: list[bytes]) -> tuple[bytes | None, bytes | None]: ...
def finish(summaries: list[bytes], cuts: list[bytes], asked: dict[str, Any]) -> _Told: ...

@final
class Map:
    def __len__(self) -> int: ...
    def neighbours(self, geodesic: bool) -> list[tuple[int, int, float, float, int, float]]: ...
    def at(self, points: list[tuple[float, float]]) -> list[tuple[str, list[int]]]: ...
    def contour(self, numbers: list[int]) -> _Polygons: ...
    def overlay(self, other: Map, cell: float) -> list[tuple[list[int], list[int], _Polygons]]: ...
    def svg(
        self, size: float, detail: bool, window: list[float] | None, whole: bool, list: int
    ) -> str: ...
