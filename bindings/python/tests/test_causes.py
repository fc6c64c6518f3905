"""Causes before consequences, in what people see."""

import json
import subprocess
import sys

import pytest
import shapely

import twinedge

OVERLAPPING = [shapely.box(0, 0, 2, 2), shapely.box(1, 1, 3, 3)]


@pytest.fixture(scope="module")
def report():
    return twinedge.audit(OVERLAPPING)


def test_a_report_counts_causes_and_shows_findings_first(report):
    (cause,) = report.causes
    follow = report.consequences(cause)
    assert cause.rule == "C1" and {one.rule for one in follow} >= {"G4"}
    assert len(follow) == report.violation_count
    head, first = str(report).splitlines()
    assert head.startswith("not valid: 1 finding, from which ") and head == report.headline
    assert first.startswith("C1: overlap of features [0, 1], ") and first.endswith(f"; {len(follow)} follow from it")
    clash = next(one for one in report.violations if one.rule == "G4")
    assert "half-edge" not in str(clash) and clash.sentence in str(clash)
    assert report.to_frame()["rule"][0] == "C1" and report.to_frame()["follows_from"][1] == "C1"


def test_the_exception_and_the_notebook_show_the_cause_and_a_picture(report):
    with pytest.raises(twinedge.InvalidStructure, match=r"(?s)not valid: 1 finding.*C1: overlap"):
        report.raise_if_invalid()
    assert "C1: overlap" in report._repr_html_() and "<svg" in report._repr_html_()
    assert "<svg" not in twinedge.Report(report.to_json())._repr_html_()


def test_accepting_the_finding_accepts_what_follows(report):
    accepted = twinedge.audit(OVERLAPPING, accept=report.accept_all("disputed"))
    assert accepted.valid and accepted.causes == []
    assert accepted.headline == "valid (1 accepted): all else that was checked holds"


def test_outcomes_print_a_few_lines():
    outcome = twinedge.expect(OVERLAPPING, raises=False)
    assert repr(outcome).startswith("<twinedge.Expectation not met: not valid: 1 finding") and len(repr(outcome)) < 500
    cleaned = twinedge.clean(OVERLAPPING)
    assert repr(cleaned).startswith("<twinedge.Cleaned clean: ") and len(repr(cleaned).splitlines()) <= 10
    assert "POLYGON" not in repr(cleaned) and "{" not in repr(cleaned)


def test_an_empty_layer_is_no_success():
    for empty in ([], [shapely.Point(0, 0)], [None]):
        for raises in (True, False):
            with pytest.raises(ValueError, match="allow_empty"):
                twinedge.expect(empty, raises=raises)
        assert twinedge.expect(empty, allow_empty=True)


@pytest.mark.parametrize("function", ["audit", "expect", "adapters.shapely"])
def test_a_type_checker_finds_an_option_that_there_is_none(function, tmp_path):
    code = f"import twinedge\ntwinedge.{function}([], gap_width=0.5)\ntwinedge.{function}([], gap_widht=0.5)\n"
    if function.startswith("adapters"):
        code = code.replace("import twinedge\n", "import twinedge\nimport twinedge.adapters\n")
    (tmp_path / "gate.py").write_text(code)
    command = [sys.executable, "-P", "-m", "mypy", "--strict", "--cache-dir", str(tmp_path), str(tmp_path / "gate.py")]
    found = subprocess.run(command, capture_output=True, text=True, check=False)
    errors = [line for line in found.stdout.splitlines() if ": error:" in line]
    assert len(errors) == 1 and "gap_widht" in errors[0], found.stdout + found.stderr


def test_an_editor_loads_a_layer_and_saves_it(tmp_path):
    parcels = [shapely.box(0, 0, 4, 4), shapely.box(4, 0, 8, 4)]
    city = twinedge.Editor(parcels)
    city.attribute("owner", split="copy")
    west, east = sorted((face for face in city.faces if city.features_of(face)), key=city.features_of)
    city.set("owner", west, "Ada")
    # Through both parcels, and across their border.
    fence = city.insert_segment_snapped((0, 1), (8, 2), snap=0.5)
    assert len(fence.faces_split) == 2 and len(city.faces) == 5
    city.save(tmp_path / "parcels.geojson")
    saved = json.loads((tmp_path / "parcels.geojson").read_text())
    owners = [feature["properties"] for feature in saved["features"]]
    assert sorted((one["features"], one["owner"]) for one in owners if one["owner"]) == [([0], "Ada"), ([0], "Ada")]
    assert sorted(one["features"] for one in owners) == [[0], [0], [1], [1]]
    assert sum(shapely.geometry.shape(feature["geometry"]).area for feature in saved["features"]) == 32
    assert twinedge.expect(tmp_path / "parcels.geojson")
    assert len(twinedge.Editor(tmp_path / "parcels.geojson").faces) == 5


def test_a_layer_whose_borders_cross_needs_a_grid():
    with pytest.raises(ValueError, match="snap"):
        twinedge.Editor(OVERLAPPING)
    assert len(twinedge.Editor(OVERLAPPING, snap="auto").faces) == 4


def test_messages_name_records_by_the_keys_of_python():
    city = twinedge.Editor()
    (corner, *_) = city.insert_ring([(0, 0), (4, 0), (4, 4), (0, 4)]).vertices
    city.remove_vertex(corner)
    with pytest.raises(KeyError, match=f"vertex {corner} names no vertex"):
        city.position(corner)
