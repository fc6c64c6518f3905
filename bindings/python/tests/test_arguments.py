"""Arguments that are nothing that can be judged: which, and what to call instead."""

import subprocess
import sys

import networkx as nx
import numpy as np
import pandas as pd
import pytest
import shapely
import trimesh
from compas.datastructures import Mesh
from conftest import planar_grid

import twinedge
from twinedge import adapters

SQUARES = [shapely.box(0, 0, 1, 1), shapely.box(1, 0, 2, 1)]
MESH = trimesh.creation.box()


@pytest.mark.parametrize(
    ("call", "told"),
    [
        (lambda: adapters.networkx(nx.complete_graph(4)), "expected a networkx.PlanarEmbedding, not Graph: networkx.check_planarity"),
        (lambda: adapters.networkx(None), "expected a networkx.PlanarEmbedding, not None"),
        (lambda: adapters.compas(None), "expected a compas.datastructures.Mesh, not None"),
        (lambda: adapters.compas(MESH), "expected a compas.datastructures.Mesh, not Trimesh"),
        (lambda: adapters.trimesh(None), "expected a trimesh.Trimesh, not None"),
        (lambda: adapters.trimesh(trimesh.Scene(MESH)), r"expected a trimesh.Trimesh, not Scene: scene.to_mesh\(\)"),
        (lambda: adapters.trimesh(Mesh()), "expected a trimesh.Trimesh, not Mesh"),
        (lambda: adapters.shapely(None), "cannot audit None"),
        (lambda: twinedge.audit(None), "cannot audit None: expected a path"),
        (lambda: twinedge.audit(planar_grid(2)), "cannot audit PlanarEmbedding: .*twinedge.adapters.networkx"),
        (lambda: twinedge.audit(nx.path_graph(3)), "cannot audit Graph: .*check_planarity"),
        (lambda: twinedge.audit(Mesh()), "cannot audit Mesh: .*twinedge.adapters.compas"),
        (lambda: twinedge.audit(trimesh.Scene(MESH)), "cannot audit Scene: .*to_mesh"),
        (lambda: twinedge.audit(np.zeros((2, 3), int)), "cannot audit ndarray: .*audit_faces.*validate"),
        (lambda: twinedge.audit([[0, 1, 2]]), "cannot audit int: .*audit_faces.*validate"),
        (lambda: twinedge.audit(pd.DataFrame({"a": [1]})), "cannot audit DataFrame: the frame has no geometry"),
        (lambda: twinedge.audit(SQUARES, coverge=True), "unexpected keyword argument 'coverge'"),
        (lambda: twinedge.audit(MESH, coverge=True), "unexpected keyword argument 'coverge'"),
        (lambda: twinedge.audit(MESH, plane=True), "unexpected keyword argument 'plane'"),
        (lambda: twinedge.audit(SQUARES, genus=0), "genus: this is for meshes"),
        (lambda: twinedge.audit(MESH, gap_width=0.0), "gap_width: this is for maps"),
        (lambda: twinedge.audit(MESH, accept_gaps=[(0, 0)]), "accept_gaps: this is for maps"),
        (lambda: twinedge.audit(SQUARES, accept_gaps=[1]), "accept_gaps: expected points"),
        (lambda: twinedge.audit(SQUARES, snap=[1]), "snap: expected a number, not list"),
        (lambda: twinedge.audit(SQUARES, snap=True), "snap: expected a number, not bool"),
        (lambda: twinedge.audit(SQUARES, gap_width="1"), "gap_width: expected a number, not str"),
        (lambda: twinedge.audit_faces(np.ma.masked_array([[0, 1, 2]], [[0, 0, 1]])), "faces: the mask of a masked array"),
        (lambda: twinedge.audit_faces([[0, 1, 2]], preset="trimesh"), "unexpected keyword argument"),
    ],
)
def test_what_has_the_wrong_type_is_named(call, told):
    with pytest.raises(TypeError, match=told):
        call()


@pytest.mark.parametrize("value", [-1, -1e-300, float("nan"), float("inf"), np.float64("nan")])
@pytest.mark.parametrize("name", ["gap_width", "lake_width", "sliver_area", "snap"])
def test_lengths_and_areas_are_finite_and_not_negative(name, value):
    with pytest.raises(ValueError, match=f"{name}: .* is negative or not finite"):
        twinedge.audit(SQUARES, **{name: value})


def test_accepted_gaps_are_at_points_of_the_plane():
    for points, told in [([(0, 0, 0)], "expected points"), ([(0, float("inf"))], "not finite")]:
        with pytest.raises(ValueError, match=f"accept_gaps: .*{told}"):
            twinedge.audit(SQUARES, accept_gaps=points)


def test_a_snap_is_positive_or_auto():
    for snap in ["foo", 0]:
        with pytest.raises(ValueError, match="snap: .* is neither 'auto' nor a positive number"):
            twinedge.audit(SQUARES, snap=snap)
    for snap in ["auto", 0.5, np.float32(0.5), 1]:
        assert twinedge.audit(SQUARES, snap=snap).valid
    assert twinedge.audit(SQUARES, gap_width=0, sliver_area=0).valid


def test_a_vertex_that_is_none_is_named_with_its_face():
    for faces in [[[0, 1, 2, 3], [0, 1, -4]], np.array([[0, 1, 2], [0, 1, -4]])]:
        with pytest.raises(ValueError, match="face 1 has the vertex -4 at its corner 2, which is negative"):
            twinedge.audit_faces(faces)
    with pytest.raises(ValueError, match="face 0 has the vertex 4294967296 at its corner 1, which is too large"):
        twinedge.audit_faces([[0, 2**32, 1]])
    with pytest.raises(ValueError, match="vertices: .* is more than 4,294,967,294"):
        twinedge.audit_faces([[0, 1, 2]], 10**30)


def test_the_import_is_enough_and_loads_no_library():
    code = """
import sys, twinedge
assert not {"hypothesis", "trimesh", "networkx", "twinedge.testing"} & {*sys.modules}
assert {"adapters", "testing"} <= {*dir(twinedge)}
twinedge.adapters.networkx
assert not {"hypothesis", "trimesh", "networkx"} & {*sys.modules}
twinedge.testing.surfaces
assert "hypothesis" in sys.modules
try:
    twinedge.nothing
except AttributeError as error:
    assert "no attribute 'nothing'" in str(error)
else:
    sys.exit("no error")
"""
    subprocess.run([sys.executable, "-P", "-c", code], check=True)
