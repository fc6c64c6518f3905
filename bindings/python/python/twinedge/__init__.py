"""A validator for half-edge structures, meshes and planar maps.

It names the rule that is broken and the record that breaks it::

    import numpy as np, twinedge
    report = twinedge.validate(origin=[0, 1, 1, 2, 2, 0], twin=[1, 0, 3, 2, 5, 4], next=[2, 5, 4, 1, 0, 3], plane=True)
    assert report.valid

- :func:`validate` judges links in arrays and meshes, :func:`audit` geometries, meshes and files, :func:`audit_faces` lists of faces.
- :func:`expect` is a gate for data, :func:`diff` says what is new since the last report.
- :func:`clean` repairs a layer, :class:`Map` answers what lies where, :func:`overlay` and :func:`draw` do what they say.
- :class:`Editor` is a map that is edited: undone, redone, with values that follow.
- :mod:`twinedge.tiles` audits what is larger than one machine.
- :mod:`twinedge.adapters` has a function for each library whose structures it knows.
- :mod:`twinedge.testing` has Hypothesis strategies of sound and broken structures.

``import twinedge`` is enough for all: :mod:`twinedge.tiles` and :mod:`twinedge.testing` are imported when they are first used.
"""

from __future__ import annotations

from importlib import import_module
from typing import TYPE_CHECKING, Any

from . import adapters
from ._audit import audit, audit_faces
from ._clean import Cleaned, clean
from ._editor import Edited, Editor
from ._expect import Expectation, expect
from ._map import Border, Map, Piece, Place, draw, overlay
from ._names import Side
from ._report import Difference, Finding, First, InvalidStructure, Judged, Record, Report, Rule, Violation, diff, finding_kind
from ._twinedge import FINDING_KINDS as _NAMES
from ._twinedge import KINDS, PRESETS, REPORT_SCHEMA, __version__
from ._validate import validate

if TYPE_CHECKING:
    from . import testing as testing
    from . import tiles as tiles

#: The kinds of findings: of meshes first, then of coverages, in the order of C1 to C7.
FINDING_KINDS = [*map(finding_kind, _NAMES)]

__all__ = [
    "Border",
    "Cleaned",
    "Difference",
    "Edited",
    "Editor",
    "Expectation",
    "FINDING_KINDS",
    "Finding",
    "First",
    "InvalidStructure",
    "Judged",
    "KINDS",
    "Map",
    "PRESETS",
    "Piece",
    "Place",
    "REPORT_SCHEMA",
    "Record",
    "Report",
    "Rule",
    "Side",
    "Violation",
    "__version__",
    "adapters",
    "audit",
    "audit_faces",
    "clean",
    "diff",
    "draw",
    "expect",
    "overlay",
    "validate",
]

_MODULES = ("testing", "tiles")


def __getattr__(name: str) -> Any:
    if name in _MODULES:
        return import_module(f"{__name__}.{name}")
    raise AttributeError(f"module {__name__!r} has no attribute {name!r}")


def __dir__() -> list[str]:
    return sorted({*globals(), *_MODULES})
