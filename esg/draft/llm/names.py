"""Deterministic repair of references: which object or event does a misspelled name mean?"""

from __future__ import annotations

from collections.abc import Iterable
import difflib
import re

CLOSE = 0.82
"""Least similarity of a name that is not otherwise recognized."""


def slug(text: str) -> str:
    """A name as the document allows it: lower case, words joined by underscores."""
    return re.sub(r"[^a-z0-9]+", "_", text.strip().lower()).strip("_")[:64] or "unnamed"


class Names:
    """Known names of one kind and what else they may be called.

    Args:
        kind: For the record of repairs, e.g. "object".
        repair: False leaves every name as it is.
    """

    def __init__(self, kind: str, *, repair: bool = True) -> None:
        self.kind = kind
        self.repair = repair
        self.ids: list[str] = []
        self.log: list[str] = []
        self._alias: dict[str, list[str]] = {}

    def add(self, name: str, *aliases: str) -> None:
        """Makes a name known; an alias of several names means all of them."""
        if name not in self.ids:
            self.ids.append(name)
        for alias in aliases:
            known = self._alias.setdefault(slug(alias), [])
            if name not in known:
                known.append(name)

    def find(self, text: str) -> list[str]:
        """The ids that a name means; the name itself when nothing fits, or without repair."""
        if text in self.ids:
            return [text]
        wanted = slug(text)
        grouped = self._alias.get(wanted, [])
        # A group's name is part of the reply's own language, not a mistake.
        if not self.repair:
            return grouped or [text]
        found = self._guess(wanted)
        if not found:
            return [text]
        if found != [text] and not (len(grouped) > 1 and found == grouped):
            self.log.append(f"{self.kind} {text!r} read as {', '.join(found)}")
        return found

    def one(self, text: str) -> str:
        """The first id that a name means."""
        return self.find(text)[0]

    def _guess(self, wanted: str) -> list[str]:
        by_slug = {slug(i): i for i in self.ids}
        for candidate in _variants(wanted):
            if candidate in by_slug:
                return [by_slug[candidate]]
            if candidate in self._alias:
                return self._alias[candidate]
        number = _number(wanted)
        if number in ("", "1"):
            stems = [i for k, i in by_slug.items() if _stem(k) == _stem(wanted)]
            if len(stems) == 1:
                return stems
            # "desk" for the only office_desk_1, "red_car" for the only car_1.
            kin = [i for k, i in by_slug.items() if _kin(_stem(k), _stem(wanted))]
            if len(kin) == 1:
                return kin
        # crate_2 is not a misspelled crate_1.
        near = [k for k in (*by_slug, *self._alias) if number == "" or _number(k) == number]
        close = difflib.get_close_matches(wanted, near, n=1, cutoff=CLOSE)
        if not close:
            return []
        return [by_slug[close[0]]] if close[0] in by_slug else self._alias[close[0]]


def _number(name: str) -> str:
    match = re.search(r"_(\d+)$", name)
    return match.group(1) if match else ""


def _stem(name: str) -> str:
    return re.sub(r"_\d+$", "", name)


def _kin(a: str, b: str) -> bool:
    return a.endswith(f"_{b}") or b.endswith(f"_{a}")


def _variants(wanted: str) -> list[str]:
    base = re.sub(r"^(the|a|an)_", "", wanted)
    out = [wanted, base]
    if not _number(base):
        singular = base[:-1] if base.endswith("s") else base
        out += [f"{base}_1", singular, f"{singular}_1"]
    return out


def unique(names: Iterable[str]) -> list[str]:
    """Names without repetitions, in order."""
    return list(dict.fromkeys(names))
