"""The dataset card: facts that are read from the finished tables, and the text that tells them.

`facts` has a collector a subject, `sections` a passage a subject, both in registries; a subject
that a dataset has nothing of has no passage. All facts but the cost follow from the tables, so the
card of a dataset is always the same, and is written again whenever something is added to it.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from pathlib import Path
import re
from typing import TYPE_CHECKING, Any

from esg.files import atomic_file, atomic_write

if TYPE_CHECKING:
    from esg.dataset.plan import DatasetSpec
    from esg.store.assembling import Counts

CARD = "README.md"


def write_card(
    out: Path, spec: DatasetSpec, counts: Counts, failed: Sequence[Mapping[str, Any]]
) -> dict[str, Any]:
    """Writes the card and its sheet of pictures.

    Args:
        out: Folder of the dataset, whose split files are written.
        spec: Its specification.
        counts: Rows by table and split.
        failed: Rows of `failures.jsonl`.

    Returns:
        Its facts, without what differs from run to run.

    Raises:
        OSError: If they cannot be written.
    """
    from esg.dataset.card.facts import collect
    from esg.dataset.card.facts.cost import cost
    from esg.dataset.card.recipes import present
    from esg.dataset.card.sections import text
    from esg.dataset.card.sheet import SHEET, draw_sheet

    facts = collect(out, failed)
    sheet = draw_sheet(out)
    if sheet is None:
        (out / SHEET).unlink(missing_ok=True)
    else:
        picture = sheet
        atomic_write(out / SHEET, lambda path: picture.save(path, format="JPEG", quality=88))
    more = {"cost": cost(out, facts), "sheet": sheet is not None, "layouts": present(out)}
    written = text(spec, counts, {**facts, **more})
    with atomic_file(out / CARD) as file:
        file.write(written.encode())
    return facts


def untimed(card: str) -> str:
    """A card without its section on cost: what two runs of one dataset share."""
    return re.sub(r"^## Cost$.*?(?=^## )", "", card, flags=re.DOTALL | re.MULTILINE)
