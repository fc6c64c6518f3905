"""Remedies are in the arguments of this package."""

import json
import re
from itertools import product
from pathlib import Path

import shapely

import twinedge
from twinedge import _twinedge
from twinedge._remedies import REMEDIES

PAGE = (Path(__file__).parents[3] / "docs" / "report.md").read_text()
#: Of these there is one for each field of a violation.
VALUES = [0, {"face": 0}, "twin", [0, 0], "outer", None]
#: Names that nobody who writes Python can call.
OF_RUST = re.compile(r"::|Expectation|Part\b|Builder|_slots|no_unused_vertices|outer_half_edge|`outer`|\bView\b")


def explained(kind, fields):
    """Cause and remedy of the kind, of which a violation is made up."""
    for values in product(VALUES, repeat=len(fields)):
        entry = {"kind": kind} | ({"fields": dict(zip(fields, values, strict=True))} if fields else {})
        try:
            return _twinedge.explain(json.dumps(entry))
        except ValueError:
            pass
    raise AssertionError(kind)


def of_library():
    rows = re.findall(r"^\| `([a-z_]+)` \| [A-Z]\d \| ([^|]*) \|", PAGE, re.M)
    return {kind: explained(kind, re.findall(r"`(\w+)`", fields)) for kind, fields in rows}


def test_no_kind_speaks_of_rust():
    found = of_library()
    assert [*found] == twinedge.KINDS
    assert {*REMEDIES} <= {*found}
    for kind, (cause, remedy) in found.items():
        assert not OF_RUST.search(cause), kind
        # The table covers exactly the remedies that mention Rust.
        assert bool(OF_RUST.search(remedy)) == (kind in REMEDIES), kind
    for kind, remedy in REMEDIES.items():
        assert not OF_RUST.search(remedy) and not remedy.endswith("."), kind
    assert len(REMEDIES) >= 12


def test_a_violation_has_the_remedy_of_the_table():
    violation = twinedge.audit([shapely.box(0, 0, 2, 2), shapely.box(1, 1, 3, 3)]).violations[-1]
    assert violation.kind == "cross" and violation.remedy == REMEDIES["cross"] and "snap=" in violation.remedy
    # And the remedy fixes it.
    assert twinedge.audit([shapely.box(0, 0, 2, 2), shapely.box(1, 1, 3, 3)], snap="auto").valid
    loop = twinedge.validate(origin=[0, 1], twin=[0, 1], next=[0, 1]).violations
    assert "open=True" in loop[0].remedy
