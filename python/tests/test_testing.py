"""The strategies: what is drawn as sound is, what is drawn as broken is not."""

import hypothesis
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
