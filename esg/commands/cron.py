"""Cron expressions: five fields (minute, hour, day of month, month, day of week), times in UTC."""

from __future__ import annotations

from dataclasses import dataclass
import datetime
import re

_LIMITS = ((0, 59), (0, 23), (1, 31), (1, 12), (0, 7))
_ITEM = re.compile(r"(?:\*|(\d+)(?:-(\d+))?)(?:/([1-9]\d*))?")
_MONTHS = ["jan", "feb", "mar", "apr", "may", "jun", "jul", "aug", "sep", "oct", "nov", "dec"]
_DAYS = ["sun", "mon", "tue", "wed", "thu", "fri", "sat"]
_HORIZON_DAYS = 366 * 8
"""Eight years hold every leap day: an expression that does not fire in them never does."""


@dataclass(frozen=True)
class Cron:
    """A parsed expression.

    Args:
        minutes, hours, days, months, weekdays: Values at which it fires; 0 is Sunday.
        either_day: Whether a day of the month or of the week suffices, as cron has it when both
            are restricted.
    """

    minutes: frozenset[int]
    hours: frozenset[int]
    days: frozenset[int]
    months: frozenset[int]
    weekdays: frozenset[int]
    either_day: bool

    @staticmethod
    def parse(text: str) -> Cron:
        """Reads an expression.

        Raises:
            ValueError: If it is none, or never fires.
        """
        fields = text.lower().split()
        if len(fields) != 5:
            raise ValueError(f"{len(fields)} fields instead of five")
        names: tuple[list[str], ...] = ([], [], [], _MONTHS, _DAYS)
        values = [
            _field(field, low, high, known)
            for field, (low, high), known in zip(fields, _LIMITS, names, strict=True)
        ]
        weekdays = frozenset(d % 7 for d in values[4])
        both = not fields[2].startswith("*") and not fields[4].startswith("*")
        cron = Cron(values[0], values[1], values[2], values[3], weekdays, both)
        cron.following(datetime.datetime(2024, 1, 1, tzinfo=datetime.UTC))
        return cron

    def following(self, moment: datetime.datetime) -> datetime.datetime:
        """The first time after `moment` at which it fires.

        Raises:
            ValueError: If it never does (30 February).
        """
        start = moment.astimezone(datetime.UTC).replace(second=0, microsecond=0)
        start += datetime.timedelta(minutes=1)
        for number in range(_HORIZON_DAYS):
            day = start.date() + datetime.timedelta(days=number)
            if not self._on(day):
                continue
            for hour in sorted(self.hours):
                for minute in sorted(self.minutes):
                    time = datetime.time(hour, minute, tzinfo=datetime.UTC)
                    found = datetime.datetime.combine(day, time)
                    if found >= start:
                        return found
        raise ValueError("it never fires")

    def _on(self, day: datetime.date) -> bool:
        if day.month not in self.months:
            return False
        in_month, in_week = day.day in self.days, day.isoweekday() % 7 in self.weekdays
        return (in_month or in_week) if self.either_day else (in_month and in_week)


def _field(text: str, low: int, high: int, names: list[str]) -> frozenset[int]:
    out: set[int] = set()
    for name in names:
        text = re.sub(rf"\b{name}\b", str(names.index(name) + (1 if names is _MONTHS else 0)), text)
    for item in text.split(","):
        found = _ITEM.fullmatch(item)
        if found is None:
            raise ValueError(f"{item!r} is no number, range or step")
        first, last, step = found.groups()
        begin = low if first is None else int(first)
        end = int(last) if last else (high if first is None or step else begin)
        if not low <= begin <= end <= high:
            raise ValueError(f"{item!r} is outside {low}-{high}")
        out |= set(range(begin, end + 1, int(step or 1)))
    return frozenset(out)
