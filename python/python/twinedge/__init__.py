"""A validator for half-edge structures, meshes and planar maps.

It names the rule that is broken and the record that breaks it::

    import numpy as np, twinedge
    report = twinedge.validate(origin=[0, 1, 1, 2, 2, 0], twin=[1, 0, 3, 2, 5, 4], next=[2, 5, 4, 1, 0, 3], plane=True)
    assert report.valid

- :func:`validate` judges links in arrays, :func:`audit` geometries, meshes and files, :func:`audit_faces` lists of faces.
- :mod:`twinedge.adapters` has a function for each library whose structures it knows.
- :mod:`twinedge.testing` has Hypothesis strategies of sound and broken structures.

``import twinedge`` is enough for both: they are imported when they are first used.
"""

from __future__ import annotations

from importlib import import_module
from typing import TYPE_CHECKING, Any

from ._audit import audit, audit_faces
from ._names import Side
from ._report import Finding, InvalidStructure, Record, Report, Rule, Violation, finding_kind
from ._twinedge import FINDING_KINDS as _NAMES
from ._twinedge import KINDS, PRESETS, REPORT_SCHEMA, __version__
from ._validate import validate

if TYPE_CHECKING:
    from . import adapters as adapters
    from . import testing as testing

#: The kinds of findings: of meshes first, then of coverages, in the order of C1 to C7.
FINDING_KINDS = [*map(finding_kind, _NAMES)]

__all__ = [
    "FINDING_KINDS",
    "KINDS",
    "PRESETS",
    "REPORT_SCHEMA",
    "Finding",
    "InvalidStructure",
    "Record",
    "Report",
    "Rule",
    "Side",
    "Violation",
    "__version__",
    "audit",
    "audit_faces",
    "validate",
]

_MODULES = ("adapters", "testing")


def __getattr__(name: str) -> Any:
    if name in _MODULES:
        return import_module(f"{__name__}.{name}")
    raise AttributeError(f"module {__name__!r} has no attribute {name!r}")


def __dir__() -> list[str]:
    return sorted({*globals(), *_MODULES})
