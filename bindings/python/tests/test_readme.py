"""The page begins with lines that run, and its names are there."""

import doctest
import re
from pathlib import Path

import pytest

import twinedge
from twinedge import adapters, testing, tiles

README = (Path(__file__).parents[1] / "README.md").read_text()
BLOCKS = re.findall(r"```python\n(.*?)```", README, re.S)


def test_the_first_lines_run(capsys):
    code = re.search(r"```python\n(.*?)```", README, re.S).group(1)
    assert README.index(code) < 60
    exec(compile(code, "README.md", "exec"), {})
    out = capsys.readouterr().out
    assert out.startswith("L1: half-edge 0 has twin 2, ") and "overlap" in out
    # The comments quote the printed text.
    assert "C1: overlap of features [0, 1]" in out


def test_every_name_in_the_table_is_there():
    for module, names in [(twinedge, ["validate", "audit", "audit_faces", "expect", "diff", "clean", "Map", "overlay", "draw", "Editor"]), (testing, ["surfaces", "triangle_meshes", "broken"]),
                          (adapters, ["networkx", "compas", "trimesh", "shapely", "geopandas"])]:
        for name in names:
            assert name in README and getattr(module, name).__doc__


@pytest.mark.parametrize("code", BLOCKS)
def test_every_example_runs(code, capsys):
    exec(compile(code, "README.md", "exec"), {"__name__": "readme"})
    out = capsys.readouterr().out
    # The comments quote the printed text.
    for said in ["C1 overlap ('north', 'south')", "First(rule='C1', id='C1-", "[(0, 1, 2.0), (0, 2, 2.0)]", "20 9.0"]:
        assert said in out or f"# {said}" not in code, said


def test_there_is_an_example_for_each():
    for used in ["adapters.networkx(", "adapters.trimesh(", "adapters.geopandas(", "hypothesis.given(", "expect(", "Map(", "Editor(", "tiles.duckdb.audit(", "tiles.Overlay("]:
        assert any(used in block for block in BLOCKS), used


def test_examples_of_docstrings_run():
    for module, count in [(adapters, 15), (tiles, 10), (tiles._overlay, 6)]:
        found = doctest.testmod(module)
        assert found.attempted >= count and not found.failed


def test_the_table_of_presets_is_what_they_ask_for():
    # Two triangles back to back, with everything.
    pillow = {
        "origin": [0, 1, 2, 1, 2, 0], "twin": [3, 4, 5, 0, 1, 2], "next": [1, 2, 0, 5, 3, 4], "prev": [2, 0, 1, 4, 5, 3],
        "face": [0, 0, 0, 1, 1, 1], "leaving": [0, 1, 2], "face_half_edge": [0, 3],
    }
    rows = re.findall(r"^\| `(\w+)` \| (any genus|plane) \| (\w+) \| (.*) \|$", README, re.M)
    assert [row[0] for row in rows] == twinedge.PRESETS
    for preset, surface, border, besides in rows:
        report = twinedge.validate(**pillow, preset=preset)
        checked = [rule.id for rule in report.rules if rule.unchecked is None]
        told = "R1 L1 L2 L3 V1 V2 B1 F1 F2 T3".split() + re.findall(r"[A-Z]\d", besides) + ["T4"] * (surface == "plane")
        assert report.valid and sorted(checked) == sorted(told), preset
        # Every column is checked.
        for name in [*pillow]:
            wrong = pillow | {name: [99] * len(pillow[name])}
            assert twinedge.validate(**wrong, preset=preset).broken_rules[0] == "R1", (preset, name)
        # One triangle with a border: half-edges without twin.
        one = {key: links[:3] for key, links in pillow.items() if key not in ("face_half_edge", "prev")}
        one |= {"twin": [-1] * 3, "leaving": [0, 1, 2], "face_half_edge": [0]}
        assert twinedge.validate(**one, preset=preset).valid == (border == "legal"), preset
        torus = {"origin": [0] * 4, "twin": [2, 3, 0, 1], "next": [1, 2, 3, 0]}
        assert ("T3" in twinedge.validate(**torus, preset=preset).broken_rules) == (surface == "plane"), preset
