"""A gate for data: an expectation of a layer."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

from ._audit import audit
from ._options import AuditOptions
from ._report import Finding, First, InvalidStructure, Report, Violation

if TYPE_CHECKING:
    from typing_extensions import Unpack


@dataclass(frozen=True, repr=False)
class Expectation:
    """The outcome of :func:`twinedge.expect`. Its truth is ``success``."""

    #: The verdict is ``"valid"``.
    success: bool
    #: ``"valid"``, ``"invalid"`` or ``"unknown"``.
    verdict: str
    #: The first thing that is wrong.
    first: First | None
    #: What is wrong and not accepted: causes first, then what follows from them.
    findings: list[Violation | Finding]
    #: The positions of the features that are concerned, in order.
    features: list[int]
    #: The whole report.
    report: Report

    def __bool__(self) -> bool:
        return self.success

    def __repr__(self) -> str:
        head, _, rest = str(self.report).partition("\n")
        return f"<twinedge.Expectation {'met' if self.success else 'not met'}: {head}>" + (f"\n{rest}" if rest else "")

    def to_dict(self) -> dict[str, Any]:
        """As JSON, with the keys that Great Expectations has: ``success`` and ``result``."""
        return {
            "success": self.success,
            "result": {
                "observed_value": self.verdict,
                "element_count": self.report.to_dict().get("import", {}).get("features"),
                "unexpected_count": len(self.report.causes),
                "unexpected_index_list": self.features,
                "partial_unexpected_list": [str(one) for one in self.findings[:20]],
                "details": {"unknown": self.report.unknown},
            },
        }


def expect(
    layer: Any, *, raises: bool = True, coverage: bool = True, allow_empty: bool = False, **options: Unpack[AuditOptions]
) -> Expectation:
    """Expect that a layer is right, and that this is known: a gate to put in front of data.

    Parameters
    ----------
    layer, coverage, options
        As for :func:`twinedge.audit`; here what breaks C1 to C7 is wrong by default. ``accept`` names what is known and accepted,
        ``timeout`` ends what takes too long: the verdict is then ``"unknown"``, which is no success.
    raises : bool
        Raise :class:`InvalidStructure`, a ``ValueError``, where the verdict is not ``"valid"``.
    allow_empty : bool
        Accept a layer without lines and polygons. Without it, such a layer is a ``ValueError``, whatever ``raises`` says: nothing was judged.

    Returns
    -------
    Expectation
        True if the verdict is ``"valid"``.
    """
    report = audit(layer, coverage=coverage, **options)
    if not allow_empty and report.counts.get("edges") == 0:
        raise ValueError("the layer has no lines and no polygons, so there is nothing to expect of it: allow_empty=True accepts it")
    if raises:
        report.raise_if_invalid()
    open_ones = [one for one in report._listed() if one.accepted is None]
    features = sorted({feature for one in open_ones for feature in one.features})
    return Expectation(report.valid, report.verdict, report.first, open_ones, features, report)


__all__ = ["Expectation", "InvalidStructure", "expect"]
