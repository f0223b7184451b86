"""What a check of plausibility says: the measured value, its limit, and who it was."""

from __future__ import annotations

import math
from typing import Any

from pydantic import BaseModel, ConfigDict

CheckName = str


class Check(BaseModel):
    """One check of one replay."""

    model_config = ConfigDict(frozen=True, extra="forbid", allow_inf_nan=False)

    name: CheckName
    unit: str
    ok: bool
    measured: float | None = None
    """The worst value against its limit; None where nothing was there to measure."""
    limit: float | None = None
    body: str = ""
    time_s: float | None = None
    note: str = ""

    @property
    def text(self) -> str:
        """The check in words: who did what, against which limit."""
        who = f"{self.body}: " if self.body else ""
        when = "" if self.time_s is None else f" at {self.time_s:.2f} s"
        if self.measured is None or self.limit is None:
            return f"{self.name.replace('_', ' ')}: nothing to measure"
        sizes = f"{self.measured:.3g} {self.unit}, limit {self.limit:.3g} {self.unit}"
        return f"{who}{self.name.replace('_', ' ')} {sizes}{when}"


class Plausibility(BaseModel):
    """All checks of one replay."""

    model_config = ConfigDict(frozen=True, extra="forbid", allow_inf_nan=False)

    checks: tuple[Check, ...]

    @property
    def plausible(self) -> bool:
        """Whether every check holds."""
        return all(check.ok for check in self.checks)

    @property
    def failed(self) -> tuple[Check, ...]:
        """The checks that do not hold, the worst first."""
        return tuple(sorted((c for c in self.checks if not c.ok), key=lambda c: -_excess(c)))

    def to_json(self) -> dict[str, Any]:
        """Plain JSON for `metrics.json`: `plausible`, the worst check in words, all checks."""
        return {
            "plausible": self.plausible,
            "worst": self.failed[0].text if self.failed else "",
            "checks": [c.model_dump(mode="json") for c in self.checks],
        }


def _excess(check: Check) -> float:
    if not check.measured or check.limit is None:
        return math.inf
    return check.measured / max(check.limit, 1e-9)


class Worst:
    """Keeps the worst of many measurements: the one that most exceeds, or nearest to, its limit."""

    def __init__(self) -> None:
        self._found: tuple[float, float, float, str, float | None, str] | None = None

    def look(
        self,
        measured: float,
        limit: float,
        body: str,
        time_s: float | None = None,
        note: str = "",
    ) -> None:
        """Considers one value."""
        if not (math.isfinite(measured) and math.isfinite(limit)):
            return
        ratio = measured / limit if limit > 0.0 else math.inf if measured > limit else 0.0
        if self._found is None or (ratio, measured) > self._found[:2]:
            self._found = (ratio, measured, limit, body, time_s, note)

    def check(self, name: CheckName, unit: str) -> Check:
        """The verdict on what was seen."""
        if self._found is None:
            return Check(name=name, unit=unit, ok=True)
        _, measured, limit, body, time_s, note = self._found
        return Check(
            name=name, unit=unit, ok=measured <= limit, measured=round(measured, 6),
            limit=round(limit, 6), body=body, note=note,
            time_s=None if time_s is None else round(time_s, 6),
        )  # fmt: skip
