from os import PathLike
from typing import Any, Final

import numpy as np
import numpy.typing as npt

__all__ = [
    "DEFAULT_LIST",
    "FINDING_KINDS",
    "KINDS",
    "PRESETS",
    "REPORT_SCHEMA",
    "__version__",
    "audit_faces",
    "audit_map",
    "audit_mesh",
    "explain",
    "validate",
]

__version__: Final[str]
REPORT_SCHEMA: Final[str]
DEFAULT_LIST: Final[int]
PRESETS: Final[list[str]]
KINDS: Final[list[str]]
FINDING_KINDS: Final[list[str]]

def validate(
    columns: dict[str, Any], vertices: int | None, faces: int | None, asked: dict[str, Any]
) -> str: ...
def explain(violation: str) -> tuple[str, str]: ...
def audit_faces(points: Any, corners: Any, offsets: Any, asked: dict[str, Any]) -> str: ...
def audit_mesh(path: str | PathLike[str], asked: dict[str, Any]) -> tuple[str, npt.NDArray[np.uint32]]: ...
def audit_map(text: bytes, format: str | None, asked: dict[str, Any]) -> tuple[str, list[str | None]]: ...
