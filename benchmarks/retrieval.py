"""Retrieval benchmark: does a noun phrase find the right asset, and is nonsense refused?

    python -m benchmarks.retrieval [--json FILE]

Queries are `data/retrieval_queries.csv` (kept apart from the tuning set `retrieval_tuning.csv`):
phrase and acceptable entries, or none for things that the library does not hold. With imported
libraries on the machine they join the candidates; an imported asset counts as right if its kind is,
and a query that an import answers by name expects that import. Queries in other languages than
English are expected to be refused. The cost of an exact search over 100,000 assets is measured too.
Baselines: fuzzy string matching (difflib token ratio) and plain embedding cosine.
"""

from __future__ import annotations

import argparse
import csv
from difflib import SequenceMatcher
import json
from pathlib import Path
import time

import numpy as np

from esg.assets.imports.store import active_index
from esg.assets.library.catalogue import normalize
from esg.assets.library.embed import embed
from esg.assets.library.index import Index, texts_of
from esg.assets.library.lookup import exact, head_phrase
from esg.assets.library.retrieve import GATE, confidence, rank

ROOT = Path(__file__).parents[1]


def load(path: Path) -> list[tuple[str, set[str]]]:
    """Queries and their acceptable entries."""
    with path.open(encoding="utf-8") as file:
        rows = list(csv.DictReader(file))
    return [(r["query"], set(filter(None, r["expected"].split(";")))) for r in rows]


def fuzzy(text: str, candidate: str) -> float:
    """Best of whole-string and token-set similarity, in [0, 1]."""
    a, b = set(text.split()), set(candidate.split())
    overlap = 2 * len(a & b) / (len(a) + len(b))
    return max(overlap, SequenceMatcher(None, text, candidate).ratio())


def auc(inside: list[float], outside: list[float]) -> float:
    """Chance that a random in-library query scores above a random foreign one."""
    p, q = np.array(inside)[:, None], np.array(outside)
    return float((p > q).mean() + 0.5 * (p == q).mean())


def named_imports(text: str) -> set[str]:
    """Imported assets that the head noun of a query names."""
    head = head_phrase(text).split()[-1:]
    return {
        f"{e.library}/{e.name}"
        for e in active_index().entries
        if e.library != "parametric"
        for t in texts_of(e)[:-1]
        if head and head[0] in normalize(t).split()
    }


def search_cost(assets: int = 100_000, queries: int = 20) -> float:
    """CPU time of one exact search over synthetic embeddings [ms]."""
    rng = np.random.default_rng(0)
    vectors = rng.standard_normal((assets, 384), dtype=np.float32)
    vectors /= np.linalg.norm(vectors, axis=1, keepdims=True)
    entries = (active_index().entries[0],) * assets
    index = Index(entries, vectors, np.arange(assets, dtype=np.int32), "synthetic")
    start = time.process_time()
    for k in range(queries):
        near = vectors[k] + 0.01 * vectors[-1 - k]
        assert int(index.scores(near / np.linalg.norm(near)).argmax()) == k
    return 1000 * (time.process_time() - start) / queries


def evaluate(queries: list[tuple[str, set[str]]]) -> dict[str, dict[str, float]]:
    """Top-1, top-3, rejection AUC of the three methods, and end-to-end accuracy of ours."""
    index = active_index()
    kinds = {
        (e.name if e.library == "parametric" else f"{e.library}/{e.name}"): {
            e.name,
            *e.parents[:1],
            f"{e.library}/{e.name}",
        }
        for e in index.entries
    }
    names = list(kinds)
    texts = [[normalize(t) for t in texts_of(e)[:-1]] for e in index.entries]
    results: dict[str, dict[str, list[float]]] = {
        m: {"first": [], "third": [], "in": [], "out": []} for m in ("fuzzy", "embedding", "ours")
    }
    decided: list[float] = []
    spent = 0.0
    for text, expected in queries:
        query = normalize(text)
        strings = np.array([max(fuzzy(query, t) for t in entry) for entry in texts])
        cosines = index.scores(embed([query])[0])
        start = time.perf_counter()
        candidates = rank(text)
        sure = confidence(text, candidates[0])
        found = exact(text)
        spent += time.perf_counter() - start
        ordered = {
            "fuzzy": [names[i] for i in np.argsort(-strings, kind="stable")[:3]],
            "embedding": [names[i] for i in np.argsort(-cosines, kind="stable")[:3]],
            "ours": ([found.name] if found else []) + [c.asset_name for c in candidates],
        }
        score = {"fuzzy": strings.max(), "embedding": cosines.max(), "ours": sure}
        for method, picked in ordered.items():
            store = results[method]
            store["in" if expected else "out"].append(float(score[method]))
            if expected:
                right = [bool(kinds[n] & expected) for n in picked[:3]]
                store["first"].append(right[0])
                store["third"].append(any(right))
        top = ordered["ours"][0]
        decided.append(bool(kinds[top] & expected) and sure >= GATE if expected else sure < GATE)
    table = {
        m: {
            "top1": float(np.mean(r["first"])),
            "top3": float(np.mean(r["third"])),
            "auc": auc(r["in"], r["out"]),
        }
        for m, r in results.items()
    }
    table["ours"]["decisions"] = float(np.mean(decided))
    table["ours"]["ms_per_query"] = 1000 * spent / len(queries)
    return table


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--queries", type=Path, default=ROOT / "data" / "retrieval_queries.csv")
    parser.add_argument("--json", type=Path)
    arguments = parser.parse_args()
    queries = load(arguments.queries)
    # What an import answers by name is in the library, and that import is what is expected.
    queries = [(t, e or named_imports(t)) for t, e in queries]
    table = evaluate(queries)
    foreign = sum(not e for _, e in queries)
    size = len(active_index().entries)
    cost = search_cost()
    print(f"{len(queries)} queries ({foreign} foreign), {size} assets")
    print(f"{'method':<12}{'top-1':>8}{'top-3':>8}{'AUC':>8}")
    for method, row in table.items():
        print(f"{method:<12}{row['top1']:8.3f}{row['top3']:8.3f}{row['auc']:8.3f}")
    ours = table["ours"]
    print(f"gate decisions right: {ours['decisions']:.3f}; {ours['ms_per_query']:.1f} ms a query")
    print(f"exact search over 100,000 assets: {cost:.1f} ms CPU a query")
    if arguments.json:
        result = {
            "queries": len(queries),
            "foreign": foreign,
            "assets": size,
            "search_100k_ms": round(cost, 2),
            "methods": table,
        }
        arguments.json.write_text(json.dumps(result, indent=1) + "\n")


if __name__ == "__main__":
    main()
