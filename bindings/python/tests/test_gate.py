"""The gate: verdicts, ids, accepted findings, differences, limits of time, expectations."""

import hashlib
import json
import pickle
import random
import signal
import threading
from pathlib import Path

import geopandas
import jsonschema
import pytest
import shapely
from layers import FAULTS, parcels

import twinedge

ROOT = Path(__file__).parents[3]
SCHEMA = json.loads((ROOT / "docs" / "report.schema.json").read_text())
FRAME = geopandas.GeoDataFrame({"parcel": [f"p{n}" for n in range(27)]}, geometry=parcels(), crs="EPSG:2056").set_index("parcel")


@pytest.fixture(scope="module")
def report():
    return twinedge.audit(FRAME, coverage=True)


def test_a_verdict_has_three_values(report):
    assert (report.verdict, report.valid) == ("invalid", False)
    assert twinedge.audit(FRAME.iloc[:6], coverage=True).verdict == "valid"
    # A feature with a non-finite coordinate was left out: the rest is valid, but not everything was checked.
    layer = [shapely.box(0, 0, 1, 1), shapely.Point(float("inf"), 0)]
    left_out = twinedge.audit(layer)
    assert (left_out.verdict, left_out.valid, left_out.first) == ("unknown", False, None)
    assert left_out.unknown == ["1 feature has a coordinate that is NaN or infinite, and was left out"]
    assert str(left_out).startswith("unknown: nothing wrong was found, and 1 feature has")
    assert twinedge.audit(layer, coverage=True).verdict == "invalid"
    for one in [report, left_out, twinedge.audit_faces([[0, 1, 2]])]:
        jsonschema.validate(one.to_dict(), SCHEMA)


def test_links_and_faces_have_a_verdict(triangle):
    assert twinedge.validate(**triangle).verdict == "valid" == twinedge.audit_faces([[0, 1, 2]]).verdict
    triangle["twin"][0] = 0
    assert twinedge.validate(**triangle).verdict == "invalid" == twinedge.audit_faces([[0, 1, 2]], closed=True).verdict
    assert twinedge.audit_faces([[0, 1, 2]], closed=True).first.rule == "M4"


def test_the_first_and_the_bytes_that_were_judged_are_named(report, tmp_path):
    assert report.first == (report.findings[0].rule, report.findings[0].id, report.findings[0].at)
    path = tmp_path / "parcels.geojson"
    path.write_text(FRAME.to_json())
    judged = twinedge.audit(path, coverage=True).judged
    assert judged == (hashlib.sha256(path.read_bytes()).hexdigest(), path.stat().st_size)
    # In memory: the geometries, from any source.
    assert twinedge.audit(FRAME).judged == report.judged != twinedge.audit(FRAME.iloc[:9]).judged


def test_ids_are_the_same_in_another_order(report):
    ids = {finding.id for finding in report.findings}
    assert len(ids) == len(FAULTS) == len(report.findings)
    # They are made of the labels.
    assert [entry["id"] for entry in report.findings[0].fields["features"]] == ["p7", "p25"]
    assert not ids & {finding.id for finding in twinedge.audit(parcels(), coverage=True).findings if finding.rule != "C2"}
    shuffled = FRAME.iloc[random.Random(1).sample(range(27), 27)]
    assert {finding.id for finding in twinedge.audit(shuffled, coverage=True).findings} == ids


def test_what_is_accepted_is_no_fault_until_it_grows(report, tmp_path):
    accepted = report.accept_all("known", date="2026-11-25")
    assert {entry["reason"] for entry in accepted["accepted"]} == {"known"}
    again = twinedge.audit(FRAME, coverage=True, accept=accepted)
    assert again.verdict == "valid" and {finding.accepted for finding in again.findings} == {"known"}
    path = tmp_path / "accepted.json"
    path.write_text(json.dumps(accepted))
    assert twinedge.audit(FRAME, coverage=True, accept=path).valid
    # Reason and date are kept when more is accepted.
    assert again.accept_all("later", date="2027-01-01") == accepted
    gap = next(at for at, entry in enumerate(accepted["accepted"]) if entry["rule"] == "C2")
    accepted["accepted"][gap]["area"] /= 2
    grown = twinedge.audit(FRAME, coverage=True, accept=accepted)
    assert grown.first.rule == "C2" and grown.to_dict()["accepted"]["grown"] == [accepted["accepted"][gap]["id"]]
    assert [one.rule for one in twinedge.expect(FRAME, accept=accepted, raises=False).findings] == ["C2"]
    with pytest.raises(ValueError, match="accept: no list of accepted findings"):
        twinedge.audit(FRAME, accept={"schema": "other", "accepted": []})
    twice = [shapely.box(x, 0, x + 1, 1) for x in (0, 0, 4, 4)]
    with pytest.raises(ValueError, match="1 of 2 findings are listed"):
        twinedge.audit(twice, list=1).accept_all("known")


def test_what_is_new_is_said(report, tmp_path):
    mended = FRAME.drop(index="p25")
    older, newer = twinedge.audit(mended, coverage=True), report
    found = twinedge.diff(older, newer)
    assert (len(found.new), found.gone, found.changed, found.same) == (1, [], [], 3) and found.new[0].startswith("C1-")
    assert twinedge.diff(newer, older).gone == found.new
    path = tmp_path / "older.json"
    path.write_text(older.to_json())
    assert twinedge.diff(path, newer.to_dict()) == found
    with pytest.raises(ValueError, match="old: no report of"):
        twinedge.diff({"counts": {}, "violation_count": 1, "violations": [{}]}, newer)


def test_time_that_is_up_is_an_unknown_verdict():
    late = twinedge.audit(ROOT / "tests" / "data" / "world-50m.geojson", timeout=0)
    assert late.verdict == "unknown" and late.unknown == ["time was up after 0 s"] and not late.valid
    assert twinedge.audit(FRAME.iloc[:6], timeout=1000).valid
    with pytest.raises(ValueError, match="its audit did not end"):
        twinedge.diff(late, late)
    with pytest.raises(ValueError, match="timeout: -1 is negative"):
        twinedge.audit(FRAME, timeout=-1)


def test_a_signal_ends_an_audit():
    def wake(*_):
        raise KeyboardInterrupt

    before = signal.signal(signal.SIGUSR1, wake)
    timer = threading.Timer(0.05, lambda: signal.pthread_kill(threading.main_thread().ident, signal.SIGUSR1))
    try:
        timer.start()
        with pytest.raises(KeyboardInterrupt):
            while True:
                twinedge.audit(ROOT / "tests" / "data" / "world-50m.geojson")
    finally:
        timer.cancel()
        signal.signal(signal.SIGUSR1, before)


def test_an_expectation_is_a_gate(report):
    assert twinedge.expect(FRAME.iloc[:6]).success
    with pytest.raises(twinedge.InvalidStructure) as raised:
        twinedge.expect(FRAME)
    assert raised.value.report == report
    outcome = twinedge.expect(FRAME, raises=False)
    assert not outcome and outcome.verdict == "invalid" and outcome.first == report.first
    assert outcome.features == [7, 8, 9, 10, 14, 15, 24, 25, 26]
    found = json.loads(json.dumps(outcome.to_dict()))
    assert found["success"] is False and found["result"]["element_count"] == 27 and found["result"]["unexpected_count"] == 4
    assert "C2: gap of p8, p9, p14, p15, " in "\n".join(found["result"]["partial_unexpected_list"])
    # An unknown verdict is no success.
    assert not twinedge.expect(ROOT / "tests" / "data" / "world-50m.geojson", coverage=False, timeout=0, raises=False)
    assert twinedge.expect(FRAME.iloc[[10, 24]], coverage=False)


def test_findings_are_a_layer(report):
    for one in [report, pickle.loads(pickle.dumps(report))]:
        layer = one.to_geodataframe()
        assert isinstance(layer, geopandas.GeoDataFrame) and layer.crs == FRAME.crs
        assert sorted(layer["rule"]) == sorted(rule for rule, _ in FAULTS)
        gap = layer[layer["rule"] == "C2"].iloc[0]
        assert gap.geometry.geom_type == "Polygon" and gap.geometry.area == 0.5 == gap["area"]
    assert twinedge.audit(FRAME.iloc[:6]).to_geodataframe().empty
    file = twinedge.audit(ROOT / "tests" / "data" / "world-110m-crossing.geojson").to_geodataframe()
    assert file.crs == "EPSG:4326" and len(file) >= 2
    with pytest.raises(ValueError, match="have no places"):
        twinedge.audit_faces([[0, 1, 2]]).to_geodataframe()


def test_the_report_is_that_of_the_program_and_of_its_form(report):
    document = report.to_dict()
    assert {"verdict", "first", "judged", "version", "options", "coverage", "import"} <= {*document}
    assert document["options"] == {"allow_empty": True, "coverage": True}
    assert [violation.id for violation in report.violations] == [entry["id"] for entry in document["violations"]]
    # Features of violations are positions, also in the JSON form.
    crossing = twinedge.audit([shapely.box(0, 0, 1, 1), shapely.box(0.5, 0, 1.5, 1)])
    assert {v.features for v in crossing.violations if v.rule == "G4"} == {(0, 1)}
    assert twinedge.Report(crossing.to_json()).violations == crossing.violations


def test_what_follows_from_missing_vertices_says_so():
    # From https://github.com/libgeos/geos/issues/1525.
    polygons = [shapely.Polygon([(1, 0), (1, 1), (1, 3), (4, 0)]), shapely.Polygon([(0, 4), (1, 3), (1, 0)])]
    report = twinedge.audit(polygons, coverage=True)
    assert {v.follows_from for v in report.violations} == {"C7"} and report.first.rule == "C7"


def test_an_empty_file_is_not_valid_in_silence(tmp_path):
    (tmp_path / "empty.geojson").write_text('{"type": "FeatureCollection", "features": []}')
    with pytest.raises(ValueError, match=r"empty\.geojson: .*no "):
        twinedge.audit(tmp_path / "empty.geojson")
    assert twinedge.audit([]).valid
