"""The options that several functions take, and their checks."""

from __future__ import annotations

import json
import math
import os
import sys
from collections.abc import Iterable, Sequence
from pathlib import Path
from typing import Any, TypedDict

import numpy as np

from . import _twinedge

#: The most records of a kind: a link has 32 bits in the validator, and two values are not positions.
_MOST = 2**32 - 2


class AuditOptions(TypedDict, total=False):
    """The options of :func:`twinedge.audit` for maps, which :func:`twinedge.expect` takes as well."""

    format: str | None
    gap_width: float | None
    lake_width: float | None
    accept_gaps: Iterable[Sequence[float]] | None
    sliver_area: float | None
    snap: float | str | None
    edges: str | None
    geodesic: bool
    parent_column: str | None
    name: str | None
    layer_name: str | None
    accept: Any
    timeout: float | None
    list: int | None
    explain: bool


def _refuse_masked(name: str, value: Any) -> None:
    if np.ma.isMaskedArray(value):
        raise TypeError(f"{name}: the mask of a masked array would not be read: give `{name}.filled(-1)`, or the array without mask")


def _count(name: str, value: Any, most: int = sys.maxsize) -> int | None:
    if value is None:
        return None
    if isinstance(value, (bool, np.bool_)) or not isinstance(value, (int, np.integer)):
        raise TypeError(f"{name}: expected a number, not {type(value).__name__}")
    if value < 0:
        raise ValueError(f"{name}: {value} is negative")
    if value > most:
        raise ValueError(f"{name}: {value} is more than {most:,}, the most that there can be")
    return int(value)


def _number(name: str, value: Any) -> float | None:
    """A length or an area."""
    if value is None:
        return None
    if isinstance(value, (bool, np.bool_)) or not isinstance(value, (int, float, np.integer, np.floating)):
        raise TypeError(f"{name}: expected a number, not {type(value).__name__}")
    if not 0 <= value < math.inf:
        raise ValueError(f"{name}: {value} is negative or not finite")
    return float(value)


def _asked(
    *,
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
) -> dict[str, Any]:
    if preset is not None and not isinstance(preset, str):
        raise TypeError(f"preset: expected a name, one of {', '.join(_twinedge.PRESETS)}, not {type(preset).__name__}")
    if plane and preset is not None:
        raise ValueError("plane: a preset says on which surface the structure lies")
    words = {"simple": simple, "closed": closed, "no-unused-vertices": used, "border-kept": border_kept}
    counts = {"sides": sides, "components": components, "borders": borders, "genus": genus}
    numbers = [(word, _count(word, number)) for word, number in counts.items() if number is not None]
    return {
        "plane": bool(plane),
        "open": bool(open),
        "preset": preset,
        "asked": [*((word, None) for word, is_asked in words.items() if is_asked), *numbers],
        "list": _twinedge.DEFAULT_LIST if list is None else _count("list", list),
    }


def _limits(
    gap_width: float | None = None,
    lake_width: float | None = None,
    accept_gaps: Iterable[Sequence[float]] | None = None,
    sliver_area: float | None = None,
) -> dict[str, Any]:
    return {
        "gap_width": _number("gap_width", gap_width),
        "lake_width": _number("lake_width", lake_width),
        "accept_gaps": _points("accept_gaps", accept_gaps),
        "sliver": _number("sliver_area", sliver_area),
    }


def _mesh(
    *,
    used: bool = False,
    sides: int | None = None,
    components: int | None = None,
    borders: int | None = None,
    genus: int | None = None,
    **switches: bool,
) -> dict[str, Any]:
    """The properties of a mesh, by the names that the program has for them."""
    counts = {"sides": sides, "components": components, "borders": borders, "genus": genus}
    counted = {name: _count(name, number) for name, number in counts.items()}
    return {**counted, "no_unused_vertices": bool(used), **{name: bool(value) for name, value in switches.items()}}


def _text(list: int | None, **options: Any) -> str:
    """Options as JSON. Those that are not given are left out."""
    given = {name: value for name, value in options.items() if value is not None and value is not False}
    return json.dumps({"list": _twinedge.DEFAULT_LIST if list is None else _count("list", list), **given})


def _accepted(accept: Any) -> str | None:
    """A list of accepted findings as JSON."""
    if accept is None:
        return None
    if isinstance(accept, (str, os.PathLike)):
        return Path(accept).read_text(encoding="utf-8")
    return json.dumps(accept)


def _points(name: str, points: Iterable[Sequence[float]] | None) -> list[tuple[float, float]]:
    try:
        found = [(float(x), float(y)) for x, y in (() if points is None else points)]
    except TypeError as error:
        raise TypeError(f"{name}: expected points (x, y): {error}") from None
    except ValueError as error:
        raise ValueError(f"{name}: expected points (x, y): {error}") from None
    if not all(math.isfinite(number) for point in found for number in point):
        raise ValueError(f"{name}: a coordinate is not finite")
    return found


def _grid(snap: Any) -> float | str | None:
    """``snap``, checked."""
    return _cell(snap) or snap


def _cell(snap: Any) -> float | None:
    """The size of a cell, 0 for one that is to be chosen."""
    if snap is None or isinstance(snap, str):
        if snap not in (None, "auto"):
            raise ValueError(f"snap: {snap!r} is neither 'auto' nor a positive number")
        return None if snap is None else 0.0
    size = _number("snap", snap)
    if not size:
        raise ValueError(f"snap: {snap} is neither 'auto' nor a positive number")
    return size


def _refuse(what: str, **given: Any) -> None:
    for name, value in given.items():
        # Not 0, which is a width.
        if value is not None and value is not False:
            raise TypeError(f"{name}: this is for maps, and {what} is a mesh")
