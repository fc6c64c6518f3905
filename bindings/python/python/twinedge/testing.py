"""Hypothesis strategies of sound and broken half-edge structures, and a slow judge to compare with.

:func:`surfaces` has everything that is a closed surface, with loops and parallel edges too; :func:`triangle_meshes` what algorithms on meshes
expect, simple and with three sides; :func:`broken` what a checker must refuse. A structure is a dictionary of lists, the keyword
arguments of :func:`twinedge.validate`::

    @hypothesis.given(twinedge.testing.surfaces())
    def test_my_checker(structure):
        assert my_checker(**structure)

Needs Hypothesis.
"""

from __future__ import annotations

from typing import Any

import hypothesis.strategies as st
from hypothesis import assume

__all__ = ["broken", "is_surface", "surfaces", "triangle_meshes"]

#: Columns by name, and counts.
Structure = dict[str, Any]


def _orbits(step: list[int]) -> list[int]:
    """The number of the orbit of each element of a permutation, in order of their first elements."""
    number = [-1] * len(step)
    orbits = 0
    for start in range(len(step)):
        if number[start] < 0:
            at = start
            while number[at] < 0:
                number[at] = orbits
                at = step[at]
            orbits += 1
    return number


@st.composite
def surfaces(draw: st.DrawFn, *, max_edges: int = 12, faces: bool = True, prev: bool = True) -> Structure:
    """Closed surfaces of any genus and any number of components, with loops and parallel edges.

    Any permutation of an even number of half-edges is the ``next`` of one, and every one is drawn. Examples shrink to fewer edges.
    """
    edges = draw(st.integers(0, max_edges))
    next_ = draw(st.permutations(range(2 * edges)))
    twin = [h ^ 1 for h in range(2 * edges)]
    return _structure(_orbits([next_[twin[h]] for h in range(2 * edges)]), twin, [*next_], faces, prev)


def _structure(origin: list[int], twin: list[int], next_: list[int], faces: bool, prev: bool) -> Structure:
    structure: Structure = {"origin": origin, "twin": twin, "next": next_}
    if prev:
        before = [0] * len(next_)
        for h, follows in enumerate(next_):
            before[follows] = h
        structure["prev"] = before
    if faces:
        structure["face"] = _orbits(next_)
    return structure


Triangle = tuple[int, int, int]

#: Closed simple triangulations with the fewest vertices: of the sphere, and of the torus (Möbius).
_SPHERE: list[Triangle] = [(0, 1, 2), (0, 2, 3), (0, 3, 1), (1, 3, 2)]
_TORUS: list[Triangle] = [
    corners for i in range(7) for corners in [(i, (i + 1) % 7, (i + 3) % 7), (i, (i + 3) % 7, (i + 2) % 7)]
]


def _sides(triangles: list[Triangle]) -> dict[tuple[int, int], int]:
    """The half-edge from one vertex to another: number ``3 * f + k`` begins at corner k of triangle f."""
    return {(t[k], t[(k + 1) % 3]): 3 * f + k for f, t in enumerate(triangles) for k in range(3)}


def _flip(triangles: list[Triangle], half_edge: int) -> None:
    """Turns an edge inside its two triangles, unless there is an edge already where it would go."""
    sides = _sides(triangles)
    f, k = divmod(half_edge, 3)
    a, b, c = (triangles[f][(k + i) % 3] for i in range(3))
    g, j = divmod(sides[b, a], 3)
    d = triangles[g][(j + 2) % 3]
    if (c, d) not in sides and c != d:
        triangles[f], triangles[g] = (d, b, c), (c, a, d)


@st.composite
def triangle_meshes(
    draw: st.DrawFn, *, max_faces: int = 24, max_genus: int = 1, faces: bool = True, prev: bool = True
) -> Structure:
    """Closed meshes of triangles without loops and parallel edges: one or two components, each of genus 0 or 1.

    A tetrahedron, or a torus of 14 triangles, is changed by flips and by new vertices in its triangles: this reaches every
    triangulation of the sphere. Half-edge ``3 * f + k`` begins at corner ``k`` of triangle ``f``, so
    ``numpy.reshape(mesh["origin"], (-1, 3))`` is the list of faces, for :func:`twinedge.audit_faces` or ``trimesh.Trimesh``. ``validate(**mesh,
    sides=3, simple=True, closed=True)`` is valid. Examples shrink to a tetrahedron.

    ``ValueError`` if ``max_faces`` is less than 4, or ``max_genus`` neither 0 nor 1.
    """
    if max_faces < 4 or max_genus not in (0, 1):
        raise ValueError("max_faces: at least 4; max_genus: 0 or 1")
    triangles: list[Triangle] = []
    for _ in range(draw(st.integers(1, 2))):
        room = max_faces - len(triangles)
        starts = [start for start in [_SPHERE, _TORUS][: max_genus + 1] if len(start) <= room]
        if starts:
            first = 1 + max((vertex for triangle in triangles for vertex in triangle), default=-1)
            triangles += [(first + a, first + b, first + c) for a, b, c in draw(st.sampled_from(starts))]
    for flips, chosen in draw(st.lists(st.tuples(st.booleans(), st.integers(0, 3 * max_faces)))):
        if flips:
            _flip(triangles, chosen % (3 * len(triangles)))
        elif len(triangles) + 2 <= max_faces:
            at, top = chosen % len(triangles), 1 + max(vertex for triangle in triangles for vertex in triangle)
            a, b, c = triangles[at]
            triangles[at] = (a, b, top)
            triangles += [(b, c, top), (c, a, top)]
    sides = _sides(triangles)
    ends = [(t[k], t[(k + 1) % 3]) for t in triangles for k in range(3)]
    origin, twin = [a for a, _ in ends], [sides[b, a] for a, b in ends]
    return _structure(origin, twin, [h + 1 if h % 3 < 2 else h - 2 for h in range(len(ends))], faces, prev)


@st.composite
def broken(draw: st.DrawFn, *, max_edges: int = 12) -> Structure:
    """A surface of which one link has another value, so that it is none: each breaks a rule. ``vertices`` and ``faces`` are its counts."""
    structure: Structure = draw(surfaces(max_edges=max_edges).filter(lambda s: len(s["next"]) > 0))
    name = draw(st.sampled_from(sorted(structure)))
    at = draw(st.integers(0, len(structure["next"]) - 1))
    value = draw(st.integers(-2, 2 * max_edges))
    changed: Structure = {key: [*links] for key, links in structure.items()}
    changed[name][at] = value
    changed["vertices"] = max(structure["origin"]) + 1
    changed["faces"] = max(structure["face"]) + 1
    assume(not is_surface(**changed))
    return changed


def is_surface(
    *,
    origin: list[int],
    twin: list[int],
    next: list[int],
    prev: list[int] | None = None,
    face: list[int] | None = None,
    vertices: int | None = None,
    faces: int | None = None,
    **_: Any,
) -> bool:
    """True if the lists are a closed surface: the rules in sets and quantifiers. Slow."""
    halves = range(len(next))
    vertices = max(origin, default=-1) + 1 if vertices is None else vertices
    links = [(origin, vertices), (twin, len(next)), (next, len(next)), (prev or [], len(next))]
    if face is not None:
        faces = max(face, default=-1) + 1 if faces is None else faces
        links.append((face, faces))
    if any(not 0 <= link < count for column, count in links for link in column):
        return False
    if any(twin[twin[h]] != h or twin[h] == h for h in halves):
        return False
    if len({*next}) < len(next) or (prev is not None and any(prev[next[h]] != h for h in halves)):
        return False
    if any(origin[next[h]] != origin[twin[h]] for h in halves):
        return False
    rotations = _orbits([next[twin[h]] for h in halves])
    if any((rotations[g] == rotations[h]) != (origin[g] == origin[h]) for g in halves for h in halves):
        return False
    if face is not None:
        cycles = _orbits(next)
        if any((cycles[g] == cycles[h]) != (face[g] == face[h]) for g in halves for h in halves):
            return False
        if {*face} != {*range(faces or 0)}:
            return False
    return True
