"""A validator for half-edge structures, meshes and planar maps.

It names the rule that is broken and the record that breaks it::

    import numpy as np, twinedge
    report = twinedge.validate(origin=[0, 1, 1, 2, 2, 0], twin=[1, 0, 3, 2, 5, 4], next=[2, 5, 4, 1, 0, 3], plane=True)
    assert report.valid

- :func:`validate` judges links in arrays, :func:`audit` geometries, meshes and files.
- :mod:`twinedge.adapters` has a function for each library whose structures it knows.
- :mod:`twinedge.testing` has Hypothesis strategies of sound and broken structures.
"""

from __future__ import annotations

from ._audit import audit, audit_faces
from ._report import Finding, InvalidStructure, Record, Report, Rule, Violation
from ._twinedge import KINDS, PRESETS, REPORT_SCHEMA, __version__
from ._validate import validate

__all__ = [
    "KINDS",
    "PRESETS",
    "REPORT_SCHEMA",
    "Finding",
    "InvalidStructure",
    "Record",
    "Report",
    "Rule",
    "Violation",
    "__version__",
    "audit",
    "audit_faces",
    "validate",
]
