"""The validator: of links in arrays, and of the meshes of other libraries."""

from __future__ import annotations

from typing import Any

from . import adapters
from ._audit import _faces_of, audit_faces
from ._links import Links, judge
from ._report import Report


def _of_mesh(mesh: Any, links: dict[str, Any], claims: dict[str, Any]) -> Report:
    """The report of the structure of a library."""
    given = [name for name, value in links.items() if value is not None]
    if given:
        raise TypeError(f"{given[0]}: this is for links in arrays, and a mesh is given")
    asked = {name: value for name, value in claims.items() if value is not None and value is not False}
    if hasattr(mesh, "check_structure") and hasattr(mesh, "_adj"):
        return adapters.networkx(mesh, **asked)
    if hasattr(mesh, "halfedge") and hasattr(mesh, "face"):
        return adapters.compas(mesh, **asked)
    faces = _faces_of(mesh)
    if faces is None:
        what = "None" if mesh is None else type(mesh).__name__
        raise TypeError(f"cannot validate {what}: expected a mesh of trimesh, pyvista, meshio or compas, a networkx.PlanarEmbedding, or links as keywords")
    return audit_faces(*faces, **asked)


#: No mesh is given.
_NOTHING = object()


def validate(
    mesh: Any = _NOTHING,
    /,
    *,
    origin: Links | None = None,
    next: Links | None = None,
    twin: Links | None = None,
    target: Links | None = None,
    prev: Links | None = None,
    face: Links | None = None,
    leaving: Links | None = None,
    face_half_edge: Links | None = None,
    vertices: int | None = None,
    faces: int | None = None,
    plane: bool = False,
    open: bool = False,
    preset: str | None = None,
    sides: int | None = None,
    simple: bool = False,
    closed: bool = False,
    used: bool = False,
    border_kept: bool = False,
    components: int | None = None,
    borders: int | None = None,
    genus: int | None = None,
    list: int | None = None,
) -> Report:
    """Judge a half-edge structure whose links are columns of integers.

    By default it is to be a closed surface of any genus. A link is the position of a record; nil is −1, or the largest value of
    an unsigned type.

    Parameters
    ----------
    mesh : optional
        Instead of links: a mesh of trimesh, pyvista (``PolyData``), meshio or compas, or a ``networkx.PlanarEmbedding``. Of the first three it is
        what :func:`twinedge.audit_faces` says of its faces, of the others what their function in :mod:`twinedge.adapters` does.
    origin, target : (h,) integers
        The vertex where each half-edge starts, or ends: one of the two.
    next : (h,) integers
        The half-edge that follows on the same cycle.
    twin : (h,) integers, optional
        The other half-edge of the same edge. Without it, the twin of half-edge ``h`` is ``h ^ 1``.
    prev : (h,) integers, optional
        The half-edge that precedes on the same cycle.
    face : (h,) integers, optional
        The face to the left of each half-edge.
    leaving : (v,) integers, optional
        A half-edge that leaves each vertex.
    face_half_edge : (f,) integers, optional
        A half-edge of each face. Needs ``face``.
    vertices, faces : int, optional
        How many there are. By default the length of ``leaving`` and ``face_half_edge``, or one more than the largest link, but at most
        the number of half-edges.
    plane : bool
        It lies in the plane: every component has genus 0.
    open : bool
        Borders are legal: a half-edge may lack its twin or its face.
    preset : str, optional
        Instead of ``plane``: what a library promises, one of :data:`twinedge.PRESETS`. ``README.md`` has a table of their rules.
    sides, components, borders, genus : int, optional
        Every face has so many sides; there are so many components with an edge, border loops, handles (rules M3, M5, M6, M7).
    simple, closed, used, border_kept : bool
        There are no loops and parallel edges; there is no border; a half-edge leaves every vertex; a border vertex keeps a border
        half-edge (rules M2, M4, M1, M8).
    list : int, optional
        The most violations that are listed. All are counted. Default: 1000.

    Returns
    -------
    Report

    Raises
    ------
    TypeError
        A column is no array of integers, or a masked one; ``next`` is ``None``; ``origin`` and ``target`` are both given, or neither.
    ValueError
        A column has another length than there are records, or more than one dimension; a count is negative or too large.
    RuntimeError
        An array changed during the call. A change that is undone again is not noticed. Nothing worse happens.
    MemoryError
        There is not enough memory.
    KeyboardInterrupt
        Ctrl-C, or what else a signal handler raises, ends the validation.

    Notes
    -----
    O(h + v + f) time and memory. Arrays of one type among int32, int64, uint32 and uint64 are read where they lie, with any stride,
    and the interpreter lock is released. If types differ, or are others, or an array is not aligned or not in native byte order,
    copies with 64 bits are read. Other threads may write to the arrays meanwhile, at the cost of the error above; only
    ``ndarray.resize(…, refcheck=False)`` must not be called, since it frees memory that is in use.
    """
    links = {
        "origin": origin, "target": target, "twin": twin, "next": next, "prev": prev, "face": face, "leaving": leaving,
        "face_half_edge": face_half_edge,
    }
    claims = {
        "plane": plane, "open": open, "preset": preset, "sides": sides, "simple": simple, "closed": closed, "used": used,
        "border_kept": border_kept, "components": components, "borders": borders, "genus": genus, "list": list,
    }
    if mesh is not _NOTHING:
        return _of_mesh(mesh, links | {"vertices": vertices, "faces": faces}, claims)
    return judge(links, claims, vertices, faces)
