"""The strategies: what is drawn as sound is, what is drawn as broken is not."""

import hypothesis
import numpy as np
import pytest

import twinedge
from twinedge import testing


@hypothesis.given(testing.surfaces())
def test_surfaces_are_sound(structure):
    report = twinedge.validate(**structure)
    assert report.valid and testing.is_surface(**structure)


@hypothesis.settings(suppress_health_check=[hypothesis.HealthCheck.filter_too_much, hypothesis.HealthCheck.too_slow])
@hypothesis.given(testing.broken())
def test_what_is_broken_is_found(structure):
    assert not twinedge.validate(**structure).valid


@hypothesis.given(testing.surfaces(max_edges=5), hypothesis.strategies.data())
def test_both_judges_agree_on_any_change(structure, data):
    name = data.draw(hypothesis.strategies.sampled_from(sorted(structure)))
    if structure[name]:
        at = data.draw(hypothesis.strategies.integers(0, len(structure[name]) - 1))
        structure[name][at] = data.draw(hypothesis.strategies.integers(-2, 11))
    counts = {"vertices": 8, "faces": 1 + max(structure["face"], default=-1)} if structure["face"] else {"vertices": 8}
    if counts.get("faces", 1) >= 0:
        assert twinedge.validate(**structure, **counts).valid == testing.is_surface(**structure, **counts)


def test_strategies_reach_handles_and_loops():
    for wanted in [lambda r: r.counts["genus"] == 2, lambda r: r.counts["components"] == 3]:
        hypothesis.find(testing.surfaces(), lambda s: wanted(twinedge.validate(**s)))
    with pytest.raises(hypothesis.errors.NoSuchExample):
        hypothesis.find(testing.surfaces(max_edges=4), lambda s: not twinedge.validate(**s).valid)


@hypothesis.given(testing.triangle_meshes())
def test_triangle_meshes_are_closed_and_simple(structure):
    report = twinedge.validate(**structure, sides=3, simple=True, closed=True, used=True, preset="trimesh")
    assert report.valid and testing.is_surface(**structure)
    triangles = np.reshape(structure["origin"], (-1, 3))
    report = twinedge.audit_faces(triangles, sides=3, simple=True, closed=True, used=True)
    assert report.valid and len(triangles) <= 24 and report.counts["components"] <= 2
    assert structure["face"] == [h // 3 for h in range(len(structure["face"]))]


@hypothesis.given(hypothesis.strategies.data(), hypothesis.strategies.integers(4, 40))
def test_triangle_meshes_are_as_large_as_asked(data, most):
    structure = data.draw(testing.triangle_meshes(max_faces=most, max_genus=0, faces=False, prev=False))
    assert len(structure["next"]) <= 3 * most and {*structure} == {"origin", "twin", "next"}
    assert twinedge.validate(**structure, genus=0).valid


def test_triangle_meshes_reach_what_algorithms_stumble_over():
    for wanted in [
        lambda s: twinedge.validate(**s).counts["genus"] == 1,
        lambda s: twinedge.validate(**s).counts["components"] == 2,
        # An octahedron: four triangles at each of six vertices. Only a flip makes it.
        lambda s: sorted(np.bincount(s["origin"])) == [4] * 6,
    ]:
        hypothesis.find(testing.triangle_meshes(), wanted, settings=hypothesis.settings(max_examples=20_000, database=None))
    for wrong in [{"max_faces": 3}, {"max_genus": 2}]:
        with pytest.raises(ValueError, match="max_faces: at least 4; max_genus: 0 or 1"):
            hypothesis.find(testing.triangle_meshes(**wrong), lambda _: True)
