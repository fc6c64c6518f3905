"""Names of the records and features of a report."""

import json
import pickle

import geopandas
import networkx as nx
import numpy as np
import pytest
import shapely
import trimesh
from compas.datastructures import Mesh

import twinedge

BOXES = [shapely.box(0, 0, 2, 1), shapely.box(1, 0, 3, 1)]


def labels(report):
    return {one.labels for one in [*report.findings, *report.violations]}


def test_features_have_the_labels_of_the_frame():
    frame = geopandas.GeoDataFrame({"name": ["a", "b"], "code": [1.5, 2.5]}, geometry=BOXES, index=["p", "q"])
    assert labels(twinedge.audit(frame)) == labels(twinedge.adapters.geopandas(frame.geometry)) == {("p", "q")}
    assert labels(twinedge.audit(frame, name="code")) == {(1.5, 2.5)}
    # An index of positions says nothing: the column does, if it exists.
    plain = frame.reset_index(drop=True)
    assert labels(twinedge.audit(plain)) == {("a", "b")} and labels(twinedge.audit(plain[["code", "geometry"]])) == {()}
    assert labels(twinedge.audit(BOXES)) == {()}
    assert "C1: overlap of p, q, " in str(twinedge.adapters.geopandas(frame).findings[0])
    assert twinedge.audit(frame).to_frame()["names"].tolist()[-1] == ("p", "q")
    with pytest.raises(ValueError, match="no column 'cod'; there are name, code, geometry"):
        twinedge.audit(frame, name="cod")


def test_features_have_the_names_of_the_file(tmp_path):
    frame = geopandas.GeoDataFrame({"name": ["a", "b"], "code": ["x", "y"]}, geometry=BOXES)
    collection = frame.__geo_interface__
    assert labels(twinedge.audit(collection)) == {("a", "b")} and labels(twinedge.audit(collection, name="code")) == {("x", "y")}
    (tmp_path / "map.geojson").write_text(json.dumps(collection))
    assert labels(twinedge.audit(tmp_path / "map.geojson")) == {("a", "b")}
    assert labels(twinedge.audit(tmp_path / "map.geojson", name="code")) == {("x", "y")}
    with pytest.raises(ValueError, match="no feature has a value in the column cod"):
        twinedge.audit(tmp_path / "map.geojson", name="cod")
    with pytest.raises(ValueError, match="no feature has the property 'cod'"):
        twinedge.audit(collection, name="cod")
    with pytest.raises(TypeError, match="name: this is for frames"):
        twinedge.audit(BOXES, name="code")


def test_nodes_are_named():
    _, embedding = nx.check_planarity(nx.cycle_graph(["a", "b", ("c", 1)]))
    sound = twinedge.adapters.networkx(embedding)
    columns = twinedge.adapters.networkx_columns(embedding)
    for h, ends in enumerate(columns.half_edges):
        assert sound.name(twinedge.Record("half_edge", h)) == tuple(columns.vertices[v] for v in ends)
    assert [sound.name(twinedge.Record("vertex", v)) for v in range(3)] == ["a", "b", ("c", 1)]
    del embedding["a"]["b"]["ccw"]
    report = twinedge.adapters.networkx(embedding)
    violation = report.violations[0]
    # The next of (b, a) comes from the ccw of (a, b).
    assert violation.names == (("b", "a"),) and "is ('b', 'a')" in str(violation)
    assert report.to_frame()["names"][0] == (("b", "a"),)
    # A record that does not exist has no name; neither do records of arrays.
    assert report.name(twinedge.Record("half_edge", 99)) == 99 and report.name(twinedge.Record("face", 0)) == 0
    again = pickle.loads(pickle.dumps(report))
    assert again == report and again.violations[0].names == violation.names
    # A neighbour that is no node.
    del embedding._adj["b"]
    assert (None in [end for v in twinedge.adapters.networkx(embedding).violations for n in v.names for end in n])


def test_keys_of_compas_are_named():
    mesh = Mesh.from_polyhedron(4)
    mesh.halfedge[0][1] = None
    report = twinedge.adapters.compas(mesh)
    assert not report.valid and all(v.names for v in report.violations)
    faces = [report.name(twinedge.Record("face", f)) for f in range(4)]
    assert faces == [*mesh.face]


@pytest.mark.parametrize("faces", [[[0, 1, 2, 3], [0, 2, 1], [0, 3, 4, 5, 6]], [[], [0, 1, 2], [], [0, 2, 3]], np.array([[0, 1, 2], [0, 2, 3]])])
def test_half_edges_of_faces_are_sides(faces):
    report = twinedge.audit_faces(faces, closed=True)
    sides = [(f, k) for f, corners in enumerate(faces) for k in range(len(corners))]
    assert [report.name(twinedge.Record("half_edge", h)) for h in range(len(sides))] == sides
    seen = 0
    for violation in report.violations:
        if violation.kind == "on_border":
            f, k = violation.names[0]
            corners = list(faces[f])
            assert violation.fields["vertices"] == [corners[k], corners[(k + 1) % len(corners)]]
            seen += 1
    assert seen >= 3


def test_half_edges_of_mesh_files_are_sides(tmp_path):
    mesh = trimesh.creation.box()
    trimesh.Trimesh(mesh.vertices, mesh.faces[1:], process=False).export(tmp_path / "open.off")
    report = twinedge.audit(tmp_path / "open.off", closed=True)
    assert report.violations[0].kind == "on_border"
    side = report.violations[0].names[0]
    assert isinstance(side, twinedge.Side) and divmod(report.violations[0].records[0].index, 3) == side
    assert f"is side {side.corner} of face {side.face}" in str(report.violations[0])
