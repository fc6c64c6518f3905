"""Reports: their forms."""

import json
import pickle
from pathlib import Path

import jsonschema
import numpy as np
import pandas as pd
import pytest
import shapely

import twinedge

SCHEMA = json.loads((Path(__file__).parents[3] / "docs" / "report.schema.json").read_text())


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
    assert list(frame.columns) == [
        "rule", "kind", "vertex", "half_edge", "boundary", "face", "features", "names", "follows_from", "x", "y", "area", "width", "length", "message",
    ]
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


def test_findings_are_in_the_frame_where_they_alone_make_a_report_invalid():
    # A duplicate and a ring of four around a hole: no violation, and not a coverage.
    ring = [shapely.box(0, 0, 2, 1), shapely.box(2, 0, 3, 2), shapely.box(1, 2, 3, 3), shapely.box(0, 1, 1, 3)]
    noded = shapely.union_all(shapely.boundary(ring))
    ring = [p for p in shapely.get_parts(shapely.polygonize([noded])) if p.area != 1]
    report = twinedge.audit([*ring, ring[0]], coverage=True)
    assert not report.valid and report.violations == []
    frame = report.to_frame()
    assert list(frame["rule"]) == ["C2", "C5"] and list(frame["kind"]) == ["gap", "duplicate"]
    assert frame["features"].map(len).tolist() == [5, 2] and frame["area"].tolist() == [1, 2]
    assert frame["width"].tolist() == [0.5, 2 * 2 / 6] and frame["length"].tolist() == [4, 6]
    assert frame[["x", "y"]].notna().all(axis=None) and frame["vertex"].isna().all()
    assert (1 < frame["x"][0] < 2) and (1 < frame["y"][0] < 2)
    assert len(report.to_frame()) == report.violation_count + report.finding_count
    # Of a mesh: the faces and vertices.
    frame = twinedge.audit_faces([[0, 1, 2], [0, 1, 3], [0, 1, 4]]).to_frame()
    row = frame[frame["kind"] == "non_manifold_edge"].iloc[0]
    assert pd.isna(row["rule"]) and (row["vertex"], row["face"]) == (0, 0) and "3 faces" in row["message"]
    assert isinstance(frame, pd.DataFrame) and frame["face"].dtype == "Int64"


def test_a_finding_has_attributes():
    gap = twinedge.audit([shapely.box(0, 0, 1, 1), shapely.box(0, 0, 1, 1)]).findings[0]
    assert (gap.rule, gap.kind, gap.features, gap.labels) == ("C5", "duplicate", (0, 1), ())
    assert (gap.area, gap.width, gap.length) == (1, 0.5, 4) and gap.at is not None and shapely.box(0, 0, 1, 1).contains(shapely.Point(gap.at))
    assert str(gap).startswith("C5: duplicate of features [0, 1]")
    bow = shapely.Polygon([(0, 0), (1, 1), (1, 0), (0, 1)])
    invalid = twinedge.audit([bow]).findings[0]
    assert (invalid.rule, invalid.kind, invalid.features, invalid.area, invalid.width) == ("C6", "ogc_validity", (0,), None, None)
    # The JSON form keeps the names that it has.
    assert invalid.fields["kind"] == "OGC validity" and invalid.at == (0.5, 0.5)
    near = twinedge.audit([shapely.box(0, 0, 10, 10), shapely.box(10.01, 0, 20, 10)], gap_width=0.1)
    assert [(f.rule, f.kind) for f in near.findings] == [("C3", "near_miss")]
    edge = next(f for f in twinedge.audit_faces([[0, 1, 2], [0, 1, 3], [0, 1, 4]]).findings if f.kind == "non_manifold_edge")
    assert (edge.rule, edge.faces, edge.vertices, edge.at) == (None, (0, 1, 2), (0, 1), None)


def test_every_kind_of_finding_is_documented():
    page = (Path(__file__).parents[3] / "docs" / "report.md").read_text()
    assert all(kind == kind.lower() and " " not in kind for kind in twinedge.FINDING_KINDS)
    from twinedge import _twinedge

    for name in _twinedge.FINDING_KINDS:
        assert f"| `{name}` |" in page.split("## Findings")[1], name
    assert len({*twinedge.FINDING_KINDS}) == 21


def test_the_vertex_that_a_neighbour_lacks_is_named():
    # From https://github.com/libgeos/geos/issues/1525.
    polygons = [shapely.Polygon([(1, 0), (1, 1), (1, 3), (4, 0)]), shapely.Polygon([(0, 4), (1, 3), (1, 0)])]
    [finding] = twinedge.audit(polygons).findings
    assert (finding.kind, finding.rule, finding.features, finding.at) == ("mismatch", "C7", (0, 1), (1, 1))
    assert finding.fields["missing"] == [{"at": [1, 1], "feature": 1}]


def test_a_width_hides_wider_gaps_and_mean_widths_are_those_of_the_page():
    frame = shapely.box(0, 0, 3, 3).difference(shapely.box(1, 1, 2, 2))
    pieces = [*shapely.get_parts(shapely.polygonize([shapely.union_all([frame.boundary, shapely.LineString([(0, 1.5), (1, 1.5)])])]))]
    pieces = [p for p in pieces if not p.contains(shapely.Point(1.5, 1.5))]
    gaps = [f for f in twinedge.audit(pieces).findings if f.rule == "C2"]
    assert np.allclose([(f.area, f.width) for f in gaps], [(1, 0.5)])
    for width, found in [(0.5, 1), (0.49, 0), (10, 1)]:
        assert len([f for f in twinedge.audit(pieces, gap_width=width).findings if f.rule == "C2"]) == found, width
    # A lake has limits of its own.
    for options, accepted in [
        ({"lake_width": 0.49}, (1, 0)),
        ({"gap_width": 0.01, "lake_width": 0.49}, (1, 0)),
        ({"accept_gaps": [(1.5, 1.5)]}, (0, 1)),
        ({"accept_gaps": np.array([[1.5, 1.5]]), "gap_width": 0.6}, (0, 1)),
    ]:
        report = twinedge.audit(pieces, coverage=True, **options)
        assert report.valid and (report.wider_gaps, report.accepted_gaps) == accepted, options
    for options in [{"gap_width": 0.01, "lake_width": 0.6}, {"accept_gaps": [(0.5, 0.5)]}, {"accept_gaps": []}]:
        report = twinedge.audit(pieces, coverage=True, **options)
        assert not report.valid and (report.finding_count, report.wider_gaps, report.accepted_gaps) == (1, 0, 0), options
