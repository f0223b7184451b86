"""Values kept for as long as they are asked for and together fit (`esg.machine.recent`)."""

from __future__ import annotations

from threading import Barrier, Thread

from esg.machine.recent import Recent


def test_what_has_not_been_asked_for_longest_goes_first() -> None:
    kept: Recent[str, bytes] = Recent(10, len)
    made: list[str] = []

    def get(key: str, size: int) -> bytes:
        def make() -> bytes:
            made.append(key)
            return bytes(size)

        return kept.get(key, make)

    a = get("a", 4)
    get("b", 4)
    assert get("a", 4) is a
    get("c", 4)  # b goes, although a is older
    assert get("a", 4) is a
    get("b", 4)
    assert made == ["a", "b", "c", "b"]
    assert kept.n_bytes == 8 and len(kept) == 2


def test_one_that_is_too_large_is_given_and_not_kept() -> None:
    kept: Recent[str, bytes] = Recent(10, len)
    small = kept.get("small", lambda: bytes(3))
    assert len(kept.get("large", lambda: bytes(11))) == 11
    assert kept.get("small", bytes) is small
    assert kept.n_bytes == 3
    kept.clear()
    assert (len(kept), kept.n_bytes) == (0, 0)


def test_threads_that_make_the_same_value_get_one() -> None:
    kept: Recent[str, bytearray] = Recent(100, len)
    both = Barrier(2)
    found: list[bytearray] = []

    def make() -> bytearray:
        both.wait(10)
        return bytearray(7)

    threads = [Thread(target=lambda: found.append(kept.get("x", make))) for _ in range(2)]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join()
    assert found[0] is found[1]
    assert kept.n_bytes == 7
