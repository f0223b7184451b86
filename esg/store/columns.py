"""Types of columns: their words in `esg.store.tables.COLUMNS` as Arrow types.

A word is a plain type, `list<TYPE>`, `struct<NAME: TYPE, ...>`, or `image` and `video`: the bytes
of a file and its place in the dataset, which `datasets` decodes.
"""

from __future__ import annotations

from functools import cache
import json
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    import pyarrow as pa

MEDIA = {"image": "Image", "video": "Video"}
"""Words of files in a column, and the feature of `datasets` that decodes each."""

_FILE = "struct<bytes: binary, path: string>"
_GUESSED_BYTES = 16
"""Of a text inside a list: names are short."""


@cache
def arrow_type(word: str) -> pa.DataType:
    """The Arrow type of a word.

    Raises:
        ValueError: If there is no such type.
    """
    import pyarrow as pa

    if word in MEDIA:
        return arrow_type(_FILE)
    if word.startswith("list<") and word.endswith(">"):
        return pa.list_(arrow_type(word[5:-1].strip()))
    if word.startswith("struct<") and word.endswith(">"):
        pairs = (field.split(":", 1) for field in _fields(word[7:-1]))
        return pa.struct([pa.field(name.strip(), arrow_type(t.strip())) for name, t in pairs])
    if word == "timestamp":
        return pa.timestamp("us", tz="UTC")
    return pa.type_for_alias(word)


def _fields(inner: str) -> list[str]:
    """What stands between the commas of a struct, those of nested types apart."""
    out, depth, start = [], 0, 0
    for place, letter in enumerate(inner):
        depth += (letter == "<") - (letter == ">")
        if letter == "," and depth == 0:
            out.append(inner[start:place])
            start = place + 1
    return [*out, inner[start:]]


def features_metadata(words: dict[str, str]) -> dict[bytes, bytes]:
    """What `datasets` reads of a Parquet schema: which columns hold pictures and films.

    Args:
        words: Type by column name.
    """
    features = {name: {"_type": MEDIA[word]} for name, word in words.items() if word in MEDIA}
    if not features:
        return {}
    return {b"huggingface": json.dumps({"info": {"features": features}}, sort_keys=True).encode()}


def value_bytes(kind: pa.DataType) -> int:
    """Size of one value inside a list or a struct [bytes]; of texts and lists a guess."""
    import pyarrow as pa

    if pa.types.is_struct(kind):
        return sum(value_bytes(kind.field(i).type) for i in range(kind.num_fields))
    if pa.types.is_string(kind) or pa.types.is_binary(kind) or pa.types.is_list(kind):
        return _GUESSED_BYTES
    return max(1, kind.bit_width // 8)


def type_text(kind: pa.DataType) -> str:
    """A type as one text, whatever name a file gives to what its lists hold."""
    import pyarrow as pa

    if pa.types.is_list(kind):
        return f"list of {type_text(kind.value_type)}"
    if pa.types.is_struct(kind):
        fields = (kind.field(i) for i in range(kind.num_fields))
        return "struct of " + ", ".join(f"{f.name} {type_text(f.type)}" for f in fields)
    return str(kind)
