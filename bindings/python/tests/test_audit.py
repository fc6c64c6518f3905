"""Audits of geometries, frames, meshes and files."""

import json
import subprocess
import sys
from pathlib import Path

import geopandas
import numpy as np
import pandas
import pytest
import shapely
import trimesh
from compas.datastructures import Mesh

import twinedge

DATA = Path(__file__).parents[3] / "tests" / "data"
PARCELS = Path(__file__).parents[3] / "docs" / "parcels.geojson"


def squares(*lefts):
    return [shapely.box(left, 0, left + 1, 1) for left in lefts]


def test_frames_series_sequences_and_dictionaries_have_one_verdict():
    polygons = squares(0, 1, 2.5)
    frame = geopandas.GeoDataFrame({"name": list("abc")}, geometry=polygons, index=[7, 8, 9])
    reports = [
        twinedge.audit(layer)
        for layer in [polygons, np.array(polygons), frame, frame.geometry, frame.geometry.values, frame.__geo_interface__,
                      shapely.MultiPolygon(polygons), shapely.MultiPolygon(polygons).__geo_interface__,
                      {"type": "Feature", "properties": {}, "geometry": shapely.MultiPolygon(polygons).__geo_interface__}]
    ]
    assert all(report.valid for report in reports)
    assert {tuple(report.counts.items()) for report in reports} == {tuple(reports[0].counts.items())}
    assert (reports[0].counts["faces"], reports[0].counts["components"]) == (4, 2)


def test_a_crossing_is_found_where_it_is():
    report = twinedge.audit(squares(0, 0.5))
    assert not report.valid and report.broken_rules[-1] == "G4"
    crossing = report.violations[-1]
    assert crossing.features == (0, 1) and crossing.at


def test_overlaps_count_if_a_coverage_is_asked_for():
    polygons = [shapely.box(0, 0, 2, 2), shapely.box(0, 0, 2, 2)]
    assert twinedge.audit(polygons).valid
    report = twinedge.audit(polygons, coverage=True)
    assert not report.valid and {f.kind for f in report.findings} == {"duplicate"}
    assert report.findings[0].features == (0, 1)


def test_files_are_told_by_their_names(tmp_path):
    assert twinedge.audit(PARCELS).valid
    assert twinedge.audit(str(DATA / "world-110m-crossing.geojson")).broken_rules[0] == "T3"
    (tmp_path / "map.wkt").write_text("POLYGON((0 0, 1 0, 1 1, 0 0))")
    assert twinedge.audit(tmp_path / "map.wkt").counts["faces"] == 2
    mesh = tmp_path / "mesh.off"
    trimesh.creation.box().export(mesh)
    assert twinedge.audit(mesh, closed=True, genus=0, sides=3).valid
    assert twinedge.audit(mesh, genus=1).broken_rules == ["M7"]
    with pytest.raises(TypeError, match="snap: this is for maps"):
        twinedge.audit(mesh, snap="auto")
    with pytest.raises(TypeError, match="genus: this is for meshes"):
        twinedge.audit(PARCELS, genus=0)


def test_meshes_are_judged_by_their_faces():
    box = trimesh.creation.box()
    assert twinedge.audit(box, closed=True, sides=3).valid
    assert twinedge.audit_faces(box.faces.tolist(), closed=True, sides=3).valid
    three = twinedge.audit_faces([[0, 1, 2], [0, 1, 3], [0, 1, 4]])
    assert "non_manifold_edge" in {f.kind for f in three.findings}
    assert {f.kind for f in twinedge.audit_faces(np.empty((0, 3), int)).findings} == {"no_faces"}
    assert twinedge.audit_faces([[0, 1, 2]], 4, used=True).broken_rules == ["M1"]


@pytest.mark.parametrize(
    ("layer", "error", "told"),
    [
        (7, TypeError, "cannot audit int"),
        (Mesh(), TypeError, "cannot audit Mesh"),
        ("no-such-file.geojson", FileNotFoundError, "no such file"),
        ([shapely.box(0, 0, 1, 1), "POINT(0 0)"], TypeError, "cannot audit str"),
        ({"type": "Polygon", "coordinates": [[[0, "x"]]]}, ValueError, "line 1"),
        ({"type": "Cube"}, ValueError, "Cube"),
    ],
)
def test_what_cannot_be_audited_is_said(layer, error, told):
    with pytest.raises(error, match=told):
        twinedge.audit(layer)


def test_faces_that_are_none_are_refused():
    for faces, error in [([[0, 1, -1]], ValueError), ([[0.0, 1.0, 2.0]], TypeError), (np.zeros((2, 3)), TypeError),
                         (np.zeros(3, int), ValueError)]:
        with pytest.raises(error, match="faces"):
            twinedge.audit_faces(faces)
    with pytest.raises(ValueError, match="3"):
        twinedge.audit_faces([[0, 1, 3]], 3)


def test_coordinates_are_not_rounded():
    # The corner of the second lies next to the border of the first, by one unit in the last place.
    x = np.nextafter(1.0, 2.0)
    report = twinedge.audit([shapely.box(0, 0, 1, 1), shapely.box(x, 0, 2, 1)])
    assert report.counts["components"] == 2
    assert json.loads(json.dumps(x)) == x


def test_empty_and_missing_geometries_keep_their_places():
    layer = geopandas.GeoSeries([None, shapely.Polygon(), *squares(0, 0.5)])
    for each in [layer, list(layer)]:
        report = twinedge.audit(each)
        assert report.violations[-1].features == (2, 3)


def test_a_missing_geometry_is_not_valid_in_silence():
    report = twinedge.audit([None, *squares(0), shapely.Polygon()])
    assert report.valid and report.without_geometry == [0, 2]
    assert str(report) == "valid: every rule that applies holds; 2 features have no geometry"


def test_a_coordinate_that_is_not_finite_is_a_finding_and_the_rest_is_judged():
    line = {"type": "LineString", "coordinates": [[0, 0], [np.inf, 1]]}
    layers = [
        [shapely.Polygon([(5, 5), (6, np.nan), (6, 6)]), *squares(0, 0.5)],
        [line, *squares(0, 0.5)],
        [shapely.Point(np.nan, 1), *squares(0, 0.5)],
    ]
    for layer in layers:
        report = twinedge.audit(layer)
        assert report.violations[-1].features == (1, 2)
        [finding] = [f for f in report.findings if f.rule == "C6"]
        assert (finding.features, finding.at) == ((0,), None) and "NaN or infinite" in finding.message
        assert not report.without_geometry
    alone = twinedge.audit([*squares(0), shapely.Point(0, np.inf)])
    assert not alone.valid and len(alone.to_frame()) == alone.finding_count == 1


def test_c6_counts_features_and_not_their_defects():
    bow_ties = shapely.Polygon([(0, 0), (4, 2), (4, 0), (0, 2), (4, 4), (4, 3)])
    [finding] = [f for f in twinedge.audit([bow_ties]).findings if f.rule == "C6"]
    assert len(finding.fields["defects"]) > 1 and finding.fields["defects"][0]["reason"] == "Self-intersection"


def test_the_folder_of_the_sources_does_not_hide_the_package():
    folder = Path(__file__).parents[1]
    done = subprocess.run([sys.executable, "-c", "import twinedge"], cwd=folder, capture_output=True, text=True, check=False)
    assert done.returncode == 0, done.stderr


def test_edges_are_great_circles_where_asked():
    # On the map they lie apart; on the globe the parallel of 50 degrees, drawn by its ends, bulges to 67.2 degrees.
    long = {"type": "Polygon", "coordinates": [[[-60, 30], [0, 30], [60, 30], [60, 50], [-60, 50], [-60, 30]]]}
    beside = {"type": "Polygon", "coordinates": [[[-5, 60], [5, 60], [5, 72], [-5, 72], [-5, 60]]]}
    layer = {"type": "GeometryCollection", "geometries": [long, beside]}
    assert twinedge.audit(layer, edges="straight").valid
    report = twinedge.audit(layer, edges="geodesic")
    assert [(one.rule, one.kind, one.records) for one in report.violations] == [("G4", "cross", ())] * 2
    assert report.violations[0].names[0].startswith("edge (") and "same vertices" in report.violations[0].remedy
    assert report.broken_rules == ["G4"] and report.verdict == "invalid"
    with pytest.raises(ValueError, match='edges: .*expected `straight` or `geodesic`'):
        twinedge.audit(layer, edges="round")
    with pytest.raises(ValueError, match="--edges geodesic and --snap do not go together"):
        twinedge.audit(layer, edges="geodesic", snap="auto")


TETRAHEDRON = np.array([[0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 1]], float)
INWARDS = [[0, 1, 2], [0, 3, 1], [1, 3, 2], [2, 3, 0]]


def _broken(report):
    return [rule.id for rule in report.rules if rule.violations]


def test_where_the_points_of_a_mesh_lie_is_judged_where_asked(tmp_path):
    asked = {"no_zero_area": True, "no_crossings": True, "outward": True}
    mesh = trimesh.Trimesh(TETRAHEDRON, INWARDS, process=False)
    path = tmp_path / "inwards.obj"
    path.write_text(mesh.export(file_type="obj"))
    assert twinedge.audit_faces(INWARDS, TETRAHEDRON, closed=True).valid
    for report in (twinedge.audit_faces(INWARDS, TETRAHEDRON, **asked), twinedge.audit(mesh, **asked), twinedge.audit(path, **asked), twinedge.adapters.trimesh(mesh, **asked)):
        assert _broken(report) == ["M11"]


def test_parts_are_judged_by_their_parents_where_asked():
    boxes = [shapely.box(0, 0, 4, 2), shapely.box(0, 0, 2, 2), shapely.box(2, 0, 3, 2)]
    frame = geopandas.GeoDataFrame({"parent": [None, "whole", "whole"]}, geometry=boxes, index=["whole", "left", "right"])
    kinds = [finding.kind for finding in twinedge.audit(frame, parent_column="parent").findings if finding.rule == "X4"]
    assert kinds == ["parent_not_covered"]
    # As pandas reads numbers where one is missing, and its own missing value.
    for parents in ([np.nan, 1, 1], pandas.array([None, 1, 1], dtype="Int64")):
        numbered = geopandas.GeoDataFrame({"id": [1, 2, 3], "parent": parents}, geometry=boxes)
        kinds = [finding.kind for finding in twinedge.audit(numbered, parent_column="parent=id").findings if finding.rule == "X4"]
        assert kinds == ["parent_not_covered"]
    with pytest.raises(ValueError, match="parent_column: there is no column 'state'"):
        twinedge.audit(frame, parent_column="state")
    with pytest.raises(TypeError, match="parent_column: expected a name, or 'COLUMN=KEY', not tuple"):
        twinedge.audit(frame, parent_column=("parent", "id"))
    with pytest.raises(TypeError, match="parent_column: this is for frames"):
        twinedge.audit(boxes, parent_column="parent")


def test_measures_are_in_metres_where_asked():
    overlapping = [shapely.box(0, 0, 2, 2), shapely.box(1, 0, 3, 2)]
    plane, geodesic = twinedge.audit(overlapping), twinedge.audit(overlapping, geodesic=True)
    assert plane.findings[0].area == 2
    # A degree is some 111 km.
    assert geodesic.findings[0].area == pytest.approx(2 * 111e3**2, rel=0.01)


def test_causes_are_explained_where_asked():
    (finding,) = twinedge.audit([shapely.box(0, 0, 2, 2), shapely.box(1, 1, 3, 3)], explain=True).findings
    assert finding.fields["cause"] and finding.fields["remedy"]
