"""Values that a process keeps for as long as they are asked for and together fit."""

from __future__ import annotations

from collections import OrderedDict
from collections.abc import Callable, Hashable
from threading import Lock
from typing import Generic, TypeVar

K = TypeVar("K", bound=Hashable)
V = TypeVar("V")


class Recent(Generic[K, V]):
    """The values asked for last, up to so many bytes: what has not been asked for longest goes.

    A cache of so many values is as large as the largest of them are, and one from which the oldest
    goes never stops growing while rare large values displace common small ones.

    Args:
        most_bytes: Of all values together; one that is larger alone is not kept.
        size: Of a value [bytes].
    """

    def __init__(self, most_bytes: int, size: Callable[[V], int]) -> None:
        self._most, self._size = most_bytes, size
        self._kept: OrderedDict[K, tuple[V, int]] = OrderedDict()
        self._lock = Lock()
        self.n_bytes = 0

    def __len__(self) -> int:
        return len(self._kept)

    def get(self, key: K, make: Callable[[], V]) -> V:
        """The value of a key, made if it is not kept; threads may make it twice and get one.

        Args:
            key: What the value depends on.
            make: Makes it.
        """
        with self._lock:
            if key in self._kept:
                self._kept.move_to_end(key)
                return self._kept[key][0]
        value = make()
        size = self._size(value)
        with self._lock:
            if key in self._kept:
                return self._kept[key][0]
            if size <= self._most:
                self._kept[key] = value, size
                self.n_bytes += size
            while self.n_bytes > self._most:
                _, (_, gone) = self._kept.popitem(last=False)
                self.n_bytes -= gone
        return value

    def clear(self) -> None:
        """Keeps nothing."""
        with self._lock:
            self._kept.clear()
            self.n_bytes = 0
