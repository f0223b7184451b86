"""Suites of strangers: little text that stands for much, and ids that share a folder."""

from __future__ import annotations

import time
import tracemalloc

import pytest

from esg.metrics.suite import parse_suite
from esg.outcomes import UserError
from esg.strangers.yamlfile import MAX_VALUES, read_yaml

SCENE = "suite: x\nscenes:\n"


def doubled(first: str, of: str) -> str:
    """Aliases to aliases: ten to the twelfth values in 500 bytes."""
    lines = [f"a: &a {first}"]
    for k in range(12):
        inner = ", ".join([f"*{chr(97 + k)}"] * 10)
        lines.append(f"{chr(98 + k)}: &{chr(98 + k)} {of.format(inner)}")
    return "\n".join(lines)


HOSTILE = {
    "aliases": doubled("[x, x, x, x, x, x, x, x, x, x]", "[{}]"),
    "merges": doubled("{k: 1}", "{{<<: [{}]}}"),
    "contains itself": "&a [*a]",
    "deep flow": "[" * 100_000,
    "deep block": "".join(f"{' ' * k}a:\n" for k in range(800)),
    "deep keys": "? " * 100_000,
    "many values": "[" + "1," * 300_000 + "]",
    "a long number": "a: " + "1" * 900_000,
    "a long sexagesimal number": "a: 1" + ":1" * 300_000,
    "many scenes with mistakes": SCENE + "".join(
        f" - {{id: s{k}, prompt: p, events: [{{id: e}}]}}\n" for k in range(20_000)),
    "many events": SCENE + " - {id: a, prompt: b, events: ["
    + ",".join(f"{{id: e{k}}}" for k in range(40_000)) + "]}",
    "many unknown keys": "suite: x\n" + "".join(f"scene{k}: 1\n" for k in range(60_000)),
    "repeated keys": "".join(f"&a{k} x: *a{k}\n" for k in range(20_000)),
}  # fmt: skip


@pytest.mark.parametrize("text", HOSTILE.values(), ids=list(HOSTILE))
def test_little_text_costs_little_time_and_memory(text: str) -> None:
    start = time.monotonic()
    with pytest.raises(UserError) as told:
        parse_suite(text)
    assert time.monotonic() - start < 30
    assert len(str(told.value).splitlines()) <= 202


def test_a_bomb_is_refused_before_it_is_built() -> None:
    tracemalloc.start()
    value, (mistake,) = read_yaml(HOSTILE["aliases"])
    _, most = tracemalloc.get_traced_memory()
    tracemalloc.stop()
    assert value is None
    assert f"stands for more than {MAX_VALUES} values" in mistake.what
    assert most < 20 * 2**20


def test_honest_aliases_are_read() -> None:
    text = "base: &b {kind: ball, at: [1, 2]}\none: {<<: *b, at: 3}\ntwo: *b\n"
    value, mistakes = read_yaml(text)
    assert not mistakes
    assert value["one"] == {"kind": "ball", "at": 3}
    assert value["two"] == value["base"]


@pytest.mark.parametrize(
    "text", ["a: 2001-13-45", "{[a]: b}", "!!python/object:os.system x", "!!bool maybe", "!!int x",
             "!!timestamp x", "!!binary xx", "!!omap [a]", "<<: 3", "%YAML 9.9\n---\na", "a\n---\nb"],
)  # fmt: skip
def test_what_yaml_cannot_mean_is_a_mistake_and_no_error(text: str) -> None:
    with pytest.raises(UserError, match="fix the syntax"):
        parse_suite(text)


@pytest.mark.parametrize(("one", "two"), [("A/1", "A?1"), ("猫", "犬"), ("a b", "a  b")])
def test_ids_that_would_share_a_folder_are_refused(one: str, two: str) -> None:
    text = SCENE + "".join(f' - {{id: "{i}", prompt: A ball rolls.}}\n' for i in (one, two))
    with pytest.raises(UserError, match=r"its folder would be .*-?run0', as that of /scenes/0"):
        parse_suite(text)


@pytest.mark.parametrize(
    ("scene", "told"),
    [(f"{{id: {'x' * 101}, prompt: p}}", "has 101 characters; write 100 at most"),
     (f"{{id: a, prompt: {'x' * 8001}}}", "has 8001 characters"),
     ('{id: "a\\e[31m", prompt: p}', "holds a control character"),
     ('{id: a, prompt: "p\\a"}', "holds a control character")],
)  # fmt: skip
def test_texts_that_name_folders_or_reach_a_terminal_are_plain(scene: str, told: str) -> None:
    with pytest.raises(UserError, match=told):
        parse_suite(f"{SCENE} - {scene}\n")
