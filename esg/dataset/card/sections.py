"""The passages of a card, in order: each tells some facts, or nothing where there are none."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass
from typing import Any

from esg.dataset.card.header import header
from esg.dataset.card.limits import LIMITS
from esg.dataset.card.making import about, command, made
from esg.dataset.card.markdown import Lines, cell, cut, listed, share, table
from esg.dataset.card.recipes import recipes
from esg.dataset.card.sheet import SHEET
from esg.dataset.job import CROSSCHECK, RENDER
from esg.dataset.plan import DatasetSpec
from esg.store.assembling import Counts, card_tables

Facts = Mapping[str, Any]
_MAX_FAILURES = 20
_MAX_VALUES = 12
_ROUNDED = 1e-6
"""Residuals below are of arithmetic."""


@dataclass(frozen=True)
class Told:
    """What passages are written from.

    Args:
        spec: Of the dataset.
        counts: Rows by table and split.
        facts: Of the dataset.
    """

    spec: DatasetSpec
    counts: Counts
    facts: Facts


def text(spec: DatasetSpec, counts: Counts, facts: Facts) -> str:
    """Text of `README.md`, as the hub takes it.

    Args:
        spec: Of the dataset.
        counts: Rows by table and split.
        facts: Of the dataset (esg.dataset.card.facts), with its cost and whether it has a sheet.
    """
    from huggingface_hub import DatasetCard

    told = Told(spec, counts, facts)
    title = title_of(spec)
    lines = [header(title, spec, counts, facts), "", f"# {title}", ""]
    for name, passage in SECTIONS:
        found = passage(told)
        if found:
            lines += [*([f"## {name}", ""] if name else []), *found, ""]
    return str(DatasetCard("\n".join(lines).rstrip() + "\n"))


def title_of(spec: DatasetSpec) -> str:
    """What the dataset is called."""
    what = "sampled dynamic scenes" if spec.source == "sample" else "dynamic scenes from prompts"
    return f"{spec.n} {what}, seed {spec.seed}"


def _about(told: Told) -> Lines:
    lines = [about(told.spec, told.facts), ""]
    if told.facts.get("sheet"):
        lines += [f"![scenes of this dataset, each above its prompt]({SHEET})", ""]
    return [*lines, *card_tables(told.counts), "", _SPLITS]


_SPLITS = (
    "Splits are by hash of the prompt family: of a sampled scene its rule and its mover, else the "
    "prompt without case, articles and numbers. No family, and so no counterfactual pair, is in "
    "two splits. Columns, keys and array layouts: `meta/info.json`."
)


def _made(told: Told) -> Lines:
    return ["```", command(told.spec), "```", "", made(told.spec, told.facts)]


def _examples(told: Told) -> Lines:
    rows = [
        (r["level"] or "", cut(r["prompt"]), r["outcome"], "yes" if r["verified"] else "no")
        for r in told.facts["examples"]
    ]
    return table(("level", "prompt", "outcome", "verified"), rows) if rows else []


def _sizes(told: Told) -> Lines:
    rows = [
        (name, *(row[k] for k in ("min", "median", "mean", "max")))
        for name, row in told.facts["sizes"].items()
    ]
    names = ("in a scene", "least", "median", "mean", "most")
    return table(names, rows, "lrrrr") if rows else []


def _endings(told: Told) -> Lines:
    n = told.facts["scenes"]
    ordered = sorted(told.facts["outcomes"].items(), key=lambda item: (-item[1], item[0]))
    rows = [(k, v, share(v, n)) for k, v in ordered]
    return table(("outcome", "scenes", "share"), rows, "lrr")


def _statements(told: Told) -> Lines:
    """What prompts state and what became of it; the words that no scene shows."""
    facts = told.facts
    lines = [
        f"{facts['fully_understood']} of {facts['scenes']} prompts are fully understood; "
        f"{facts['partial']} scenes are `partial`: usable, but not all that their prompt says is "
        f"shown. Statements: {listed(facts['statements'])}.",
    ]
    if not facts["not_represented"]:
        return lines
    rows = [
        (r["words"], r["status"].replace("_", " "), r["scenes"]) for r in facts["not_represented"]
    ]
    return [*lines, "", *table(("words that are not shown", "why", "scenes"), rows, "llr")]


def _plausibility(told: Told) -> Lines:
    """How many replays are plausible, and which checks the others fail."""
    facts = told.facts
    lines = [
        f"{facts['plausible']} of {facts['replayed']} replays are `plausible`: every check of "
        "table `plausibility_checks` stays within its limit.",
    ]
    if not facts["implausible"]:
        return lines
    ordered = sorted(facts["implausible"].items(), key=lambda item: (-item[1], item[0]))
    rows = [(name.replace("_", " "), n) for name, n in ordered]
    return [*lines, "", *table(("check", "replays that fail it"), rows, "lr")]


def _rates(key: str, name: str, whole: str, part: str) -> Callable[[Told], Lines]:
    def passage(told: Told) -> Lines:
        found: Mapping[str, Mapping[str, int]] = told.facts[key]
        rows = [(k, r[whole], r[part], share(r[part], r[whole])) for k, r in found.items()]
        return table((name, whole, part, "share"), rows, "lrrr") if rows else []

    return passage


def _numbers(told: Told) -> Lines:
    rows = [
        (q, c["stated"], f"{c['mean_score']:.3f}") for q, c in told.facts["constraints"].items()
    ]
    return table(("quantity", "stated", "mean score (PPA)"), rows, "lrr") if rows else []


def _pairs(told: Told) -> Lines:
    p = told.facts["pairs"]
    if not p["pairs"]:
        return []
    return [
        f"{p['pairs']} pairs, {p['both_verified']} verified on both sides. What the other side "
        f"changes: {listed(p['changed'])}."
    ]


def _variety(told: Told) -> Lines:
    """What was drawn, beside what the distribution asks for."""
    found = told.facts["drawn"]
    repeated = told.facts["duplicates"]
    lines: Lines = []
    if found:
        mix = told.spec.distribution
        rows: list[tuple[str, str, str]] = []
        for name, values in found.items():
            if name == "bystanders":
                asked = mix.bystanders if mix else {}
                drawn = (
                    f"{values['min']:g} to {values['max']:g} a scene, {values['mean']:g} on average"
                )
            else:
                asked = getattr(mix, _ASKED[name], {}) if mix else {}
                drawn = _most(values)
            rows.append((name, _shares(asked), drawn))
        lines += table(("what", "asked for (shares)", "drawn (scenes or things)"), rows)
        lines += [
            "",
            "Shares hold among the scenes that leave the choice: a rule that says where it is, or "
            "a thing that has one colour, does not. Everything but the camera is said in the "
            "prompt; each scene's draw is in its column `parameters`.",
            "",
        ]
    lines.append(
        f"Near-duplicates (by motion and words): {repeated['found']} found, "
        + (
            f"{repeated['kept']} of them in the splits, marked in column `duplicate_of`."
            if not told.spec.thin
            else "left out of all splits (`meta/duplicates.jsonl`)."
        )
    )
    return lines


_ASKED = {
    "place": "places", "light": "lights", "camera": "cameras", "color": "colors",
    "material": "materials", "size": "sizes", "variant": "variants",
    "bystander": "bystander_kinds",
}  # fmt: skip
"""Field of the distribution by what is drawn."""


def _shares(asked: Any) -> str:
    if not isinstance(asked, Mapping):
        return f"{asked:g}"
    shares: Mapping[str, float] = asked
    total = sum(shares.values())
    ordered = sorted(shares.items(), key=lambda item: -item[1])[:_MAX_VALUES]
    more = ", …" if len(shares) > _MAX_VALUES else ""
    return ", ".join(f"{k} {100 * v / total:.0f}%" for k, v in ordered if v > 0) + more or "any"


def _most(values: Mapping[str, int]) -> str:
    shown = list(values.items())
    told = ", ".join(f"{k} {n}" for k, n in shown[:_MAX_VALUES])
    rest = sum(n for _, n in shown[_MAX_VALUES:])
    return told + (f", others {rest}" if rest else "")


def _each(counts: Mapping[str, int]) -> str:
    return ", ".join(f"{name} ({n})" for name, n in counts.items())


def _clips(told: Told) -> Lines:
    c = told.facts["clips"]
    if not c:
        return []
    length = c["length_s"]
    lines = [
        f"{c['clips']} clips of {c['scenes']} scenes, {c['frames']} frames, {c['hours']:g} hours; "
        f"{length['min']:g} to {length['max']:g} s each (median {length['median']:g} s). Pictures: "
        f"{_each(c['pictures'])}. Colours: {_each(c['renderers'])}. "
        f"Cameras: {_each(c['cameras'])}.",
        *(
            [f"Shown in: {_most(c['place'])}; under skies: {_most(c['sky'])}."]
            if c["place"]
            else []
        ),
    ]
    rows = [(name, c["megabytes"].get(name, "columns of the table")) for name in c["channels"]]
    return [*lines, "", *table(("channel", "MB"), rows, "lr")]


def _texts(told: Told) -> Lines:
    lines: Lines = []
    if "captions" in told.facts:
        c = told.facts["captions"]
        rows = [
            (name, f"{c['words'][name]['mean']:g}", cut(c["example"][name] or "", 400))
            for name in ("short", "medium", "long")
        ]
        lines += [
            "Captions at three lengths, made from the verified timeline:",
            "",
            *table(("caption", "words", "of the first scene"), rows, "lrl"),
            "",
        ]
    if "questions" in told.facts:
        q = told.facts["questions"]
        rows = [
            (kind, n, cut(q["examples"][kind]["question"]), cut(q["examples"][kind]["answer"]))
            for kind, n in q["kinds"].items()
        ]
        lines += [
            "Questions whose answers are measured on the replay:",
            "",
            *table(("kind", "questions", "for example", "answer"), rows, "lrll"),
            "",
        ]
    return lines[:-1]


def _engines(told: Told) -> Lines:
    found = told.facts.get("engines")
    if not found:
        return []
    rows = [
        (
            f"{r['engine']}, {1.0 / r['dt_s']:.0f} Hz",
            r["events"],
            r["completed"],
            share(r["completed"], r["events"]),
            r["failed"],
        )
        for r in found
    ]
    return [
        f"Every event in several engines and steps: on {told.facts['events_agree']:.1%} of them "
        "all agree whether it completes. Table `engine_events`; `engines_agree` of a scene lets "
        "you keep only those.",
        "",
        *table(("engine, step", "events", "completed", "share", "failed"), rows, "lrrrr"),
    ]


def _what_ifs(told: Told) -> Lines:
    found = told.facts.get("what_ifs")
    if not found:
        return []
    rows = [
        (
            name,
            r["scenes"],
            r["not_applicable"],
            r["failed"],
            r["changed"],
            share(r["agree"], r["replayed"]),
        )
        for name, r in found.items()
    ]
    head = ("variable", "scenes", "not applicable", "failed", "other events", "engines agree")
    return [
        "Solved scenes replayed with one variable changed and nothing else (table `what_ifs`, "
        "pairs by `pair`):",
        "",
        *table(head, rows, "lrrrrr"),
    ]


def _truth(told: Told) -> Lines:
    found = told.facts["truth"]
    if not found:
        return []
    rows = [
        (name.replace("_", " "), c["checked"], c["samples"],
         *("" if c[p] is None else f"{c[p]:.2g}" if c[p] >= _ROUNDED else "0"
           for p in ("p50", "p90", "p99", "highest_p99", "worst")),
         f"{c['limit']:g} {c['unit']}", c["failing"])
        for name, c in found.items()
    ]  # fmt: skip
    names = ("check", "checked", "samples", "50%", "90%", "99%", "highest 99%", "worst", "limit",
             "scenes that fail")  # fmt: skip
    failing = {name: c["named"] for name, c in found.items() if c["named"]}
    lines = [
        "A sample of every batch is checked against geometry by code that shares nothing with what "
        "made the truth. Residuals of a clip are told by their percentiles; here are the medians "
        "over clips, the highest 99th percentile of a clip, and the worst single sample. Table "
        "`truth_checks` has every clip.",
        "",
        *table(names, rows, "lrrrrrrrrr"),
    ]
    if failing:
        lines += ["", "A clip fails a check if its 99th percentile exceeds the limit:", ""]
        lines += [f"- {name.replace('_', ' ')}: {', '.join(who)}" for name, who in failing.items()]
    return lines


def _cost(told: Told) -> Lines:
    c = told.facts.get("cost")
    if not c:
        return []
    whole = sum(c["seconds"].values())
    rows: list[tuple[Any, ...]] = []
    for stage, seconds in c["seconds"].items():
        each = f"{seconds / max(1, c['scenes']):.2f}"
        clip = f"{seconds / c['clips']:.2f}" if stage in (RENDER, CROSSCHECK) and c["clips"] else ""
        rows.append((stage, f"{seconds:.1f}", share(seconds, whole), each, clip))
    machine = c["machine"] or "an unknown machine"
    lines = [
        f"{whole / 3600:.2f} hours of one process on {machine}, as measured by its clock while "
        "others ran beside it: "
        f"{whole / max(1, c['scenes']):.1f} s a scene"
        + (f", {whole / c['clips']:.1f} s and {c['megabytes'] / c['clips']:.2f} MB a clip"
           if c["clips"] else "")
        + ".",
        "",
    ]  # fmt: skip
    return [*lines, *table(("stage", "s", "share", "s a scene", "s a clip"), rows, "lrrrr")]


def _licences(told: Told) -> Lines:
    rows = [
        (r["license"] or "none stated", r["attribution"] or "this project", r["scenes"])
        for r in told.facts["licences"]
    ]
    lines = [
        "The dataset is under Apache-2.0: prompts, scene graphs, motion, pictures and texts were "
        "made by this software; its textures are drawn by its own generators and contain no scan "
        "or picture of anybody. Meshes:",
        "",
        *table(("licence", "whose", "scenes that show one"), rows, "llr"),
        "",
        "Made with Newton and Warp (Apache-2.0), PhysX 5 through SAPIEN (BSD-3-Clause, "
        "Apache-2.0), Rapier (Apache-2.0), trimesh (MIT), MiniLM embeddings (Apache-2.0), Arrow "
        "(Apache-2.0)"
        + (", FFmpeg through PyAV (BSD-3-Clause; x264 GPL-2.0)" if told.facts["clips"] else "")
        + ". Those licences are of the software, not of what is made with it.",
    ]
    return lines


def _failures(told: Told) -> Lines:
    failed = told.facts["failures"]
    if not failed:
        return ["None."]
    rows: list[tuple[Any, ...]] = [
        (r["scenes"], r["outcome"], r["stage"], r["cause"], r["example"])
        for r in failed[:_MAX_FAILURES]
    ]
    if len(failed) > _MAX_FAILURES:
        rest = sum(r["scenes"] for r in failed[_MAX_FAILURES:])
        rows.append((rest, "other", "", f"{len(failed) - _MAX_FAILURES} further causes", ""))
    names = ("scenes", "outcome", "stage", "cause", "example")
    return ["One line a cause; every scene is in `failures.jsonl`.", "", *table(names, rows, "r")]


def _limits(told: Told) -> Lines:
    return [f"- {cell(limit.says)}" for limit in LIMITS if limit.applies(told.spec, told.facts)]


SECTIONS: tuple[tuple[str, Callable[[Told], Lines]], ...] = (
    ("", _about),
    ("Read it", lambda told: recipes(told.facts)),
    ("Made by", _made),
    ("Examples", _examples),
    ("Clips", _clips),
    ("Captions and questions", _texts),
    ("How large scenes are", _sizes),
    ("What was drawn", _variety),
    ("How scenes end", _endings),
    ("What prompts say", _statements),
    ("Plausibility", _plausibility),
    ("By difficulty", _rates("levels", "level", "scenes", "verified")),
    ("By rule", _rates("rules", "rule", "scenes", "verified")),
    ("Events", _rates("events", "event", "stated", "completed")),
    ("Stated numbers", _numbers),
    ("Counterfactual pairs", _pairs),
    ("Other engines", _engines),
    ("What if", _what_ifs),
    ("Ground truth against geometry", _truth),
    ("Cost", _cost),
    ("Failures", _failures),
    ("Known limits", _limits),
    ("Licences and attribution", _licences),
)
"""Title and passage; the first has none."""
