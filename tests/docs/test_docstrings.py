"""Every public name says what it takes and gives, with shapes, units and errors."""

from __future__ import annotations

from collections.abc import Iterator
import dataclasses
import enum
import inspect
import re
from typing import Any

import pytest

import esg

UNITS = {"_s": "[s]", "_m": "[m]", "_ns": "[N s]", "_kg": "[kg]", "_mps": "[m/s]", "_hz": "[Hz]"}
RAISES = re.compile(r"\braise UserError|\bchecked\(|\bload_\w+\(|\bfind_scene\(|\b_files\(")


def public() -> Iterator[tuple[str, Any]]:
    """Names of `import esg`, and the public members of classes."""
    for name in esg.__all__:
        if name == "__version__":
            continue
        found = getattr(esg, name)
        yield name, found
        if inspect.isclass(found):
            for member, value in vars(found).items():
                own = getattr(value, "fget", None) or getattr(value, "func", None) or value
                own = getattr(own, "__func__", own)
                if not member.startswith("_") and inspect.isfunction(own):
                    yield f"{name}.{member}", own


def section(text: str, title: str) -> dict[str, str]:
    """Entries of a part of a Google docstring, by name."""
    found = re.search(rf"^{title}:\n((?:[ \t]+.*\n?|\n)+)", text, re.MULTILINE)
    entries = re.findall(r"^    (\w[\w, *]*): (.*(?:\n     +.*)*)", found[1] if found else "", re.M)
    return {key.strip(" *"): said for keys, said in entries for key in keys.split(",")}


ALL = dict(public())


@pytest.mark.parametrize("name", ALL)
def test_a_public_name_is_documented(name: str) -> None:
    found = ALL[name]
    text = inspect.cleandoc(found.__doc__ or "")
    assert len(text.split()) >= 2 and not text.startswith(f"{name}("), "no docstring of its own"
    if inspect.isclass(found) and issubclass(found, enum.Enum | Exception):
        return
    told = section(text, "Args")
    if dataclasses.is_dataclass(found):
        for field in dataclasses.fields(found):
            assert field.name in told, f"{field.name} is not told"
            if any(word in str(field.type) for word in ("Floats", "NDArray")):
                assert "shape [" in told[field.name], f"no shape of {field.name}"
            for ending, unit in UNITS.items():
                if field.name.endswith(ending):
                    assert unit in told[field.name], f"no unit of {field.name}"
    elif inspect.isfunction(found):
        asked = [p for p in inspect.signature(found).parameters if p not in ("self", "cls")]
        if len(asked) > 1 or (asked and "." not in name):
            assert set(asked) == set(told)
        body = inspect.getsource(found).replace(found.__doc__ or "", "")
        assert bool(RAISES.search(body)) <= ("Raises:" in text), "errors are not told"
        returned = str(inspect.signature(found).return_annotation)
        if any(word in returned for word in ("Floats", "NDArray")):
            assert "shape [" in text and "[" in text, "no shape of what it returns"


def test_what_is_lacking_is_seen() -> None:
    assert section("It.\n\nArgs:\n    a: The one\n        [m].\n    b, c: Two.\n\nRaises:\n    X: Y.", "Args") == {
        "a": "The one\n        [m].", "b": "Two.", "c": "Two.",
    }  # fmt: skip
