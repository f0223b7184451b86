"""How often prompts name each kind of the library: which drawings are looked at most.

    python -m benchmarks.kinds [--most 60]

Counts prompts of `data/suites` and `data/prompts` with a name or synonym of the kind, longest
phrases first; verbs that are spelt like a kind ("slide", "fall") are counted, too.
"""

from __future__ import annotations

import argparse
from collections import Counter
from collections.abc import Iterator
import json
from pathlib import Path
import re

import yaml

from esg.assets.library.catalogue import lexicon
from esg.lexicon import singular

DATA = Path(__file__).resolve().parents[1] / "data"


def prompts() -> Iterator[str]:
    """Every prompt of the suites and of the prompt sets."""
    for path in sorted(DATA.glob("suites/*.yaml")):
        yield from (s["prompt"] for s in yaml.safe_load(path.read_text("utf-8"))["scenes"])
    for path in sorted(DATA.glob("prompts/*.jsonl")):
        lines = path.read_text("utf-8").splitlines()
        yield from (json.loads(line)["prompt"] for line in lines if line.strip())


def kinds_in(prompt: str) -> set[str]:
    """Kinds that a prompt names."""
    table = lexicon()
    words = [singular(w) for w in re.sub(r"[^a-z0-9]+", " ", prompt.lower()).split()]
    found: set[str] = set()
    at = 0
    while at < len(words):
        phrases = (" ".join(words[at : at + n]) for n in (3, 2, 1))
        named = next((p for p in phrases if p in table), None)
        if named is None:
            at += 1
            continue
        found.add(table[named])
        at += len(named.split())
    return found


def main() -> None:
    """Prints the kinds with their counts, most frequent first."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--most", type=int, default=60)
    counts: Counter[str] = Counter()
    for prompt in prompts():
        counts.update(kinds_in(prompt))
    for kind, count in counts.most_common(parser.parse_args().most):
        print(f"{count:5d}  {kind}")


if __name__ == "__main__":
    main()
