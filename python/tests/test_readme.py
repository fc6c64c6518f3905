"""The page begins with lines that run, and its names are there."""

import re
from pathlib import Path

import twinedge
from twinedge import adapters, testing

README = (Path(__file__).parents[1] / "README.md").read_text()


def test_the_first_lines_run(capsys):
    code = re.search(r"```python\n(.*?)```", README, re.S).group(1)
    assert README.index(code) < 60
    exec(compile(code, "README.md", "exec"), {})
    out = capsys.readouterr().out
    assert out.startswith("L1: half-edge 0 has twin 2, ") and "cross" in out
    # What the comments say is what is printed.
    assert "half-edges 2 and 17 cross" in out


def test_every_name_in_the_table_is_there():
    for module, names in [(twinedge, ["validate", "audit", "audit_faces"]), (testing, ["surfaces", "broken"]),
                          (adapters, ["networkx", "compas", "trimesh", "shapely", "geopandas"])]:
        for name in names:
            assert name in README and getattr(module, name).__doc__
