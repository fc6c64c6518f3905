"""The structures of other libraries."""

import geopandas
import networkx as nx
import numpy as np
import pytest
import shapely
import trimesh
from compas.datastructures import Mesh
from conftest import planar_grid

import twinedge
from twinedge import adapters


def test_networkx_embeddings_are_judged():
    grid = planar_grid(6)
    grid.check_structure()
    assert adapters.networkx(grid, components=1).valid
    for graph in [nx.petersen_graph(), nx.complete_graph(4), nx.path_graph(5), nx.empty_graph(3), nx.Graph([("a", "b"), (1, 2)])]:
        planar, embedding = nx.check_planarity(graph)
        if planar:
            report = adapters.networkx(embedding)
            assert report.valid and report.counts["edges"] == graph.number_of_edges()
    columns = adapters.networkx_columns(embedding)
    assert columns.vertices == ["a", "b", 1, 2] and columns.half_edges.tolist() == [[0, 1], [1, 0], [2, 3], [3, 2]]


def test_a_wrong_rotation_is_found():
    grid = planar_grid(4)
    grid._adj[5][6]["ccw"] = 5
    assert adapters.networkx(grid).broken_rules[0] == "R1"
    grid = planar_grid(4)
    del grid._adj[5][6]["cw"]
    assert adapters.networkx(grid).broken_rules[0] == "R1"
    grid = planar_grid(4)
    del grid._adj[5][6]
    assert adapters.networkx(grid).broken_rules[0] == "R1"
    # Two neighbours change places: the links agree, but edges cross.
    grid = planar_grid(4)
    around = list(grid.neighbors_cw_order(5))
    around[0], around[1] = around[1], around[0]
    data = {v: around if v == 5 else list(grid.neighbors_cw_order(v)) for v in grid}
    twisted = nx.PlanarEmbedding()
    twisted.set_data(data)
    assert adapters.networkx(twisted).broken_rules == ["T3"]
    assert adapters.networkx(twisted, plane=False).valid


def test_compas_meshes_are_judged():
    grid = Mesh.from_meshgrid(dx=4, nx=4)
    report = adapters.compas(grid, borders=1, components=1, sides=4)
    assert report.valid and (report.counts["faces"], report.counts["vertices"]) == (16, 25)
    assert adapters.compas(Mesh.from_polyhedron(6), closed=True, genus=0).valid
    assert adapters.compas(Mesh(), closed=True).valid
    u, v = next(iter(grid.edges()))
    grid.halfedge[u][v] = None if grid.halfedge[u][v] is not None else next(iter(grid.face))
    assert not adapters.compas(grid).valid


def test_trimeshes_are_judged():
    for mesh, genus in [(trimesh.creation.icosphere(2), 0), (trimesh.creation.torus(2, 1), 1), (trimesh.creation.annulus(1, 2, 1), 1)]:
        assert mesh.is_volume
        assert adapters.trimesh(mesh, closed=True, components=1, genus=genus).valid
        assert adapters.trimesh(mesh, genus=genus + 1).broken_rules == ["M7"]
    sphere = trimesh.creation.icosphere(1)
    faces = sphere.faces[1:]
    assert adapters.trimesh(trimesh.Trimesh(sphere.vertices, faces, process=False), borders=1).valid
    flipped = sphere.faces.copy()
    flipped[0] = flipped[0][::-1]
    report = adapters.trimesh(trimesh.Trimesh(sphere.vertices, flipped, process=False), closed=True)
    assert not report.valid and "flipped_faces" in {f.kind for f in report.findings}


def test_coverages_are_judged_as_geos_judges_them():
    side_by_side = [shapely.box(x, y, x + 1, y + 1) for x in range(3) for y in range(3)]
    overlap = [*side_by_side, shapely.box(0.5, 0.5, 1.5, 1.5)]
    node_missing = [shapely.box(0, 0, 1, 2), shapely.box(1, 0, 2, 1), shapely.box(1, 1, 2, 2)]
    for polygons in [side_by_side, overlap]:
        series = geopandas.GeoSeries(polygons)
        assert adapters.shapely(polygons).valid == adapters.geopandas(series).valid == shapely.coverage_is_valid(polygons)
    # GEOS asks for the vertex on both sides, and so do the rules: it lies inside an edge.
    assert not shapely.coverage_is_valid(node_missing)
    assert "touch" in {v.kind for v in adapters.shapely(node_missing).violations}


def test_unknown_arguments_are_refused():
    with pytest.raises(TypeError, match="unexpected keyword"):
        adapters.networkx(planar_grid(2), handles=3)
    assert isinstance(adapters.networkx(planar_grid(2)), twinedge.Report)
    assert np.asarray(adapters.networkx_columns(nx.PlanarEmbedding()).half_edges).shape == (0, 2)
