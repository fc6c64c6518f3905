"""Reports: their forms."""

import json
import pickle
from pathlib import Path

import jsonschema
import pytest

import twinedge

SCHEMA = json.loads((Path(__file__).parents[2] / "docs" / "report.schema.json").read_text())


@pytest.fixture
def broken(triangle):
    triangle["twin"][0] = 0
    return twinedge.validate(**triangle)


def test_every_report_has_the_documented_form(triangle, broken):
    square = {"type": "Polygon", "coordinates": [[[0, 0], [1, 0], [1, 1], [0, 1], [0, 0]]]}
    bow = {"type": "Polygon", "coordinates": [[[0, 0], [1, 1], [1, 0], [0, 1], [0, 0]]]}
    reports = [
        broken, twinedge.validate(**triangle), twinedge.audit_faces([[0, 1, 2], [0, 1, 3], [0, 1, 4]]),
        twinedge.audit(square), twinedge.audit(bow), twinedge.audit([]),
    ]
    assert {report.valid for report in reports} == {True, False}
    for report in reports:
        jsonschema.validate(report.to_dict(), SCHEMA)
        assert twinedge.Report(report.to_json()) == report == pickle.loads(pickle.dumps(report))
        assert all(v.kind in twinedge.KINDS for v in report.violations)
    with pytest.raises(jsonschema.ValidationError):
        jsonschema.validate(broken.to_dict() | {"valid": 1}, SCHEMA)
    with pytest.raises(ValueError, match="twinedge-report/1"):
        twinedge.Report({"schema": "twinedge-report/2"})


def test_a_frame_has_a_row_for_each_violation(broken):
    frame = broken.to_frame()
    assert list(frame.columns) == ["rule", "kind", "vertex", "half_edge", "boundary", "face", "message"]
    assert len(frame) == len(broken.violations) == broken.violation_count
    assert frame.iloc[0][["rule", "kind", "half_edge"]].tolist() == ["L1", "twin_is_self", 0]
    assert frame["half_edge"].dtype == "Int64" and frame["face"].isna().all()
    assert twinedge.validate(origin=[], next=[]).to_frame().empty


def test_text_and_html_say_what_is_wrong(broken):
    assert str(broken).startswith("not valid: ") and "L1: half-edge 0 is its own twin" in str(broken)
    assert repr(broken).startswith("<twinedge.Report not valid: ")
    page = broken._repr_html_()
    assert "not valid" in page and "its own twin" in page and "<td>L1</td><td>broken</td>" in page
    assert "<b style" in twinedge.validate(origin=[], next=[])._repr_html_()
    name = {"type": "Polygon", "coordinates": [[[0, 0], [1, 1], [1, 0], [0, 1], [0, 0]]]}
    assert "&" not in str(twinedge.audit(name)) or "&amp;" in twinedge.audit(name)._repr_html_()


def test_only_so_many_violations_are_listed(triangle):
    triangle["twin"][:] = range(6)
    report = twinedge.validate(**triangle, list=2)
    assert (len(report.violations), report.violation_count) == (2, 12)
    assert "… and 10 more" in str(report)
    assert twinedge.validate(**triangle, list=0).violations == []


def test_a_report_has_no_truth(broken):
    with pytest.raises(TypeError, match="report.valid"):
        bool(broken)
