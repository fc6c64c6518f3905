"""Faults that other checkers pass, reduced. Each test states the behaviour of a named version, and fails when that changes."""

import json
import signal
from collections import Counter, defaultdict
from contextlib import contextmanager
from pathlib import Path

import networkx as nx
import numpy as np
import pytest
import shapely
import trimesh
from compas.datastructures import Mesh

from twinedge import adapters

ROOT = Path(__file__).parents[3]


class _Hang(Exception):
    pass


@contextmanager
def _limited(seconds):
    def stop(*_):
        raise _Hang

    before = signal.signal(signal.SIGALRM, stop)
    signal.setitimer(signal.ITIMER_REAL, seconds)
    try:
        yield
    finally:
        signal.setitimer(signal.ITIMER_REAL, 0)
        signal.signal(signal.SIGALRM, before)


def _check_structure(embedding, seconds=0.1):
    try:
        with _limited(seconds):
            embedding.check_structure()
    except nx.NetworkXException:
        return "caught"
    except _Hang:
        return "hangs"
    return "passes"


def _tetrahedron():
    return nx.check_planarity(nx.complete_graph(4))[1]


def test_networkx_check_structure_passes_a_wrong_ccw():
    embedding = _tetrahedron()
    assert embedding[0][2]["ccw"] == 3
    embedding[0][2]["ccw"] = 2
    # Neighbour 2 follows itself counter-clockwise.
    assert _check_structure(embedding) == "passes"
    report = adapters.networkx(embedding)
    assert not report.valid and report.broken_rules[0] == "L2"


@pytest.mark.skipif(not hasattr(signal, "setitimer"), reason="no timers")
def test_networkx_check_structure_hangs_on_a_wrong_cw():
    embedding = _tetrahedron()
    assert embedding[0][2]["cw"] == 1
    embedding[0][2]["cw"] = 2
    # Clockwise around vertex 0, the walk never comes back to the first neighbour.
    assert _check_structure(embedding, 1) == "hangs"
    report = adapters.networkx(embedding)
    assert not report.valid and report.broken_rules[0] == "L2"


@pytest.mark.skipif(not hasattr(signal, "setitimer"), reason="no timers")
def test_networkx_check_structure_on_every_wrong_neighbour_of_a_tetrahedron():
    embedding = _tetrahedron()
    found = {"cw": Counter(), "ccw": Counter()}
    for u, v in list(embedding.edges):
        for attribute, counter in found.items():
            right = embedding[u][v][attribute]
            for wrong in set(embedding[u]) - {right}:
                embedding[u][v][attribute] = wrong
                counter[_check_structure(embedding)] += 1
                assert not adapters.networkx(embedding).valid
            embedding[u][v][attribute] = right
    assert found == {"cw": {"caught": 12, "hangs": 12}, "ccw": {"caught": 16, "passes": 8}}
    assert adapters.networkx(embedding).valid


class _Links(dict):
    """The links of a half-edge. It counts how often one is read, and stops when that has been too often."""

    left = 10**9

    def __getitem__(self, key):
        _Links.left -= 1
        if _Links.left < 0:
            raise _Hang
        return super().__getitem__(key)


class _Counted(nx.PlanarEmbedding):
    edge_attr_dict_factory = _Links


def _neighbours_of_countries():
    """The countries of Natural Earth at 1 : 110 million, joined where they share a border, in the embedding that networkx finds."""
    owners = defaultdict(set)
    features = json.loads((ROOT / "crates" / "cli" / "data" / "world-110m.geojson").read_text(encoding="utf-8"))["features"]
    for country, feature in enumerate(features):
        shape = feature["geometry"]
        for polygon in [shape["coordinates"]] if shape["type"] == "Polygon" else shape["coordinates"]:
            for ring in polygon:
                for ends in zip(ring, ring[1:], strict=False):
                    owners[tuple(sorted(map(tuple, ends)))].add(country)
    graph = nx.Graph()
    graph.add_nodes_from(range(len(features)))
    graph.add_edges_from(pair for pair in owners.values() if len(pair) == 2)
    embedding = _Counted()
    embedding.set_data(nx.check_planarity(graph)[1].get_data())
    return embedding


def test_networkx_check_structure_on_a_wrong_neighbour_of_each_half_edge_of_a_map():
    embedding = _neighbours_of_countries()
    assert embedding.number_of_edges() == 626
    budget = _Links.left
    embedding.check_structure()
    # The walk around a vertex depends on the last neighbour alone, so a check that reads ten times as much goes in a circle.
    budget = 10 * (budget - _Links.left)
    found = {"cw": Counter(), "ccw": Counter()}
    for u in embedding:
        around = dict(embedding[u])
        for links in around.values():
            for attribute, counter in found.items():
                right = dict.__getitem__(links, attribute)
                # The neighbour after the correct one. There is another one unless this is the only one.
                wrong = dict.__getitem__(around[right], attribute)
                if wrong == right:
                    continue
                links[attribute] = wrong
                _Links.left = budget
                counter[_check_structure(embedding, 60)] += 1
                _Links.left = 10**9
                assert adapters.networkx(embedding).broken_rules[0] == "L2"
                links[attribute] = right
    assert found == {"cw": {"caught": 470, "hangs": 140}, "ccw": {"caught": 450, "passes": 160}}
    assert adapters.networkx(embedding).valid


def test_compas_collapse_edge_leaves_half_edges_of_the_vertex_that_went():
    # https://github.com/compas-dev/compas/issues/880
    mesh = Mesh.from_vertices_and_faces([[0, 0, 0], [10, 0, 0], [10, 10, 0], [0, 5, 0], [0, 10, 0]], [[0, 1, 2], [0, 2, 3, 4]])
    assert adapters.compas(mesh, borders=1).valid
    mesh.collapse_edge((3, 4), allow_boundary=True)
    # Vertex 4 is removed, but half-edge 0 to 4 is not.
    assert 4 not in mesh.vertex and 4 in mesh.halfedge[0]
    report = adapters.compas(mesh)
    assert report.broken_rules[0] == "R1"
    half_edges = adapters.compas_columns(mesh).half_edges
    named = {tuple(half_edges[record.index].tolist()) for v in report.violations for record in v.records if record.kind == "half_edge"}
    vertices = adapters.compas_columns(mesh).vertices
    assert (0, 4) in {(vertices[u], vertices[v]) for u, v in named}


def test_compas_collapse_edge_of_two_triangles_leaves_a_side_without_twin():
    mesh = Mesh.from_vertices_and_faces([[0, 0, 0], [1, 0, 0], [1, 1, 0], [0, 1, 0]], [[0, 1, 2], [0, 2, 3]])
    assert adapters.compas(mesh, borders=1).valid
    mesh.collapse_edge((0, 1), allow_boundary=True)
    assert 2 in mesh.halfedge[0] and 0 not in mesh.halfedge[2]
    assert adapters.compas(mesh).broken_rules[0] == "R1"


def test_trimesh_calls_two_bodies_that_touch_in_a_vertex_one_volume():
    corners = np.array([[0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 1], [-1, 0, 0], [0, -1, 0], [0, 0, -1]], float)
    faces = [[0, 2, 1], [0, 1, 3], [1, 2, 3], [2, 0, 3], [0, 4, 5], [0, 6, 4], [4, 6, 5], [5, 6, 0]]
    mesh = trimesh.Trimesh(corners, faces, process=False)
    assert mesh.is_watertight and mesh.is_winding_consistent and mesh.is_volume
    # 7 − 12 + 8: the count of no closed surface.
    assert mesh.euler_number == 3
    report = adapters.trimesh(mesh, closed=True)
    assert not report.valid and report.broken_rules[0] == "V2"
    assert [f.kind for f in report.findings] == ["non_manifold_vertex"]


def test_geos_calls_a_map_that_crosses_itself_a_valid_coverage():
    square = shapely.box(0, 0, 4, 4)
    bow_tie = shapely.Polygon([(4, 0), (8, 4), (8, 0), (4, 4)])
    # The bow-tie crosses itself. It overlaps no other polygon, and the documentation does not require each to be valid.
    assert shapely.coverage_is_valid([square, bow_tie]) and not bow_tie.is_valid
    report = adapters.shapely([square, bow_tie])
    assert not report.valid and report.broken_rules[-1] == "G4"
    assert {f.fields["rule"] for f in report.findings} >= {"C6"}


def test_geos_calls_countries_that_cross_themselves_a_valid_coverage():
    layer = json.loads((ROOT / "tests" / "data" / "world-110m-crossing.geojson").read_text(encoding="utf-8"))
    names = [feature["properties"]["name"] for feature in layer["features"]]
    countries = np.array([shapely.geometry.shape(feature["geometry"]) for feature in layer["features"]])
    assert shapely.coverage_is_valid(countries)
    assert [names[i] for i in np.flatnonzero(~shapely.is_valid(countries))] == ["Sudan", "North Korea"]
    report = adapters.shapely(countries)
    crossing = [violation for violation in report.violations if violation.rule == "G4"]
    assert len(crossing) == 2
    invalid = {names[i] for finding in report.findings if finding.fields["rule"] == "C6" for i in finding.features}
    assert invalid >= {"Sudan", "North Korea"}
