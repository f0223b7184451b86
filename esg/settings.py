"""Limits that a user sets in the environment: one table, read and checked in one place."""

from __future__ import annotations

from dataclasses import dataclass
import math
import os

from esg.outcomes import UserError


@dataclass(frozen=True)
class Limit:
    """A number in the environment.

    Args:
        variable: Its name; the unit is part of it.
        default: Without the variable; 0 means no limit (or, for workers' memory, a share).
        high: The largest that will do.
    """

    variable: str
    default: float
    high: float

    @property
    def value(self) -> float:
        """What is set.

        Raises:
            UserError: If that is no number from 0 on.
        """
        text = os.environ.get(self.variable, "").strip()
        if not text:
            return self.default
        try:
            number = float(text)
        except ValueError:
            number = math.nan
        if not 0.0 <= number <= self.high:
            raise UserError(
                f"{self.variable}={text}: give a number from 0 to {self.high:g}; 0 sets no limit"
            )
        return number


STAGE_S = Limit("ESG_STAGE_SECONDS", 900.0, 1e6)
"""A stage of a scene that runs longer hangs."""

WORKER_GIB = Limit("ESG_WORKER_GIB", 0.0, 1e6)
"""What a worker process may allocate; without it, its share of the machine."""

SQL_S = Limit("ESG_SQL_SECONDS", 30.0, 1e6)
"""A query of `esg sql` that runs longer is stopped."""

SQL_GIB = Limit("ESG_SQL_GIB", 2.0, 1e6)
"""What such a query may keep in memory."""


def check_limits() -> None:
    """Reads all limits once, so that a mistake in one is told before any work.

    Raises:
        UserError: Naming every variable that holds no such number.
    """
    problems: list[str] = []
    for limit in (STAGE_S, WORKER_GIB, SQL_S, SQL_GIB):
        try:
            _ = limit.value
        except UserError as error:
            problems.append(str(error))
    if problems:
        raise UserError("\n".join(problems))
