"""Which runs an ablation compares, and what the paper says of them."""

from __future__ import annotations

from dataclasses import dataclass

from esg.outcomes import UserError


@dataclass(frozen=True)
class Variant:
    """One way to run the suite.

    Args:
        key: Name of its folder.
        title: As the paper's tables call it.
        strategy: Of the search.
        collision: What bodies collide with during the search.
        without: What is left out of earlier stages (`SceneRequest.without`).
    """

    key: str
    title: str
    strategy: str = "batched"
    collision: str = "exact"
    without: str = ""


@dataclass(frozen=True)
class Ablation:
    """One comparison.

    Args:
        key: What `--ablations` calls it.
        title: Of its table, with the paper's own name for it.
        variants: What is compared.
        measures: Columns of the table (`esg.ablations.tables`).
        paper: The paper's columns by variant, in the order of `paper_columns`.
        paper_columns: What they are called.
        scenes: Ids of the scenes that the paper used; empty: all.
        note: What to know when reading it beside the paper's.
    """

    key: str
    title: str
    variants: tuple[Variant, ...]
    measures: tuple[str, ...]
    paper: dict[str, tuple[str, ...]]
    paper_columns: tuple[str, ...] = ()
    scenes: tuple[str, ...] = ()
    note: str = ""


FULL = Variant("full", "Ours (full)")
NO_GLOBAL = Variant("no_global", "w/o Global optimization", without="global")
NO_INITIAL = Variant("no_initial", "w/o Initial placement", without="initial")
NO_DYNAMIC = Variant("no_dynamic", "w/o Dynamic optimization (w/o Opt.)", strategy="none")
NO_GENERATION = Variant("no_generation", "w/o Asset generation", without="generation")
_SUITE = ("events", "slr", "ppa")
_LAYOUT = ("relations", "infeasible", *_SUITE)
_RATED = ("paper: scene quality", "paper: input alignment")

ABLATIONS = (
    Ablation(
        "draft",
        "ESG draft construction (paper, Table tab:ablation_draft)",
        (),
        (),
        {
            "single_shot": ("76.5", "58.0"),
            "no_validation": ("88.5", "79.7"),
            "full": ("99.0", "89.5"),
        },
        ("paper: usability %", "paper: high-quality | usable %"),
        note="the paper: 200 descriptions, GPT-4.1. A high-quality draft here is one whose layout "
        "is feasible with every relation true; the paper's bound on energy is not published",
    ),
    Ablation(
        "assets",
        "Asset generation (paper, Supp. Mat., Ablation Study of Asset Generation)",
        (FULL, NO_GENERATION),
        ("assets", *_SUITE),
        {"full": ("4.4 ± 0.4", "4.5 ± 0.4"), "no_generation": ("3.9 ± 0.5", "2.3 ± 0.6")},
        _RATED,
        note="the paper shows a picture and, of people, Table tab:user_study. The library has all "
        "that the paper's ten prompts name; prompts of rare things tell more",
    ),
    Ablation(
        "initial",
        "Initial layout (paper, Fig. experiment::Ablation2)",
        (FULL, NO_INITIAL),
        _LAYOUT,
        {"full": ("4.4 ± 0.4", "4.5 ± 0.4"), "no_initial": ("3.8 ± 0.5", "2.8 ± 0.9")},
        _RATED,
        note="random poses instead of sampled ones, no preferences, one round; on many generated "
        "graphs: python -m benchmarks.layout ablation",
    ),
    Ablation(
        "global",
        "Global layout (paper, Fig. experiment::Ablation1)",
        (FULL, NO_GLOBAL),
        _LAYOUT,
        {"full": ("4.4 ± 0.4", "4.5 ± 0.4"), "no_global": ("4.0 ± 0.5", "2.7 ± 0.6")},
        _RATED,
        note="greedy placement, one round; on many generated graphs: "
        "python -m benchmarks.layout ablation",
    ),
    Ablation(
        "gradients",
        "Gradient strategy on S6 (paper, Table tab:ablation-grad)",
        (
            Variant("ad", "AD-only (Tape)", strategy="ad"),
            Variant("fd", "FD-only", strategy="fd"),
            Variant("hybrid", "Hybrid", strategy="hybrid"),
            FULL,
        ),
        ("each_event", "completion", "search_s"),
        {
            "ad": ("5/5", "0/5", "50.0%", "35.2"),
            "fd": ("5/5", "4/5", "90.0%", "153.5"),
            "hybrid": ("5/5", "4/5", "90.0%", "101.3"),
        },
        ("paper: Ev. 1", "paper: Ev. 2", "paper: completion", "paper: s"),
        scenes=("S6",),
        note="from the choreographed start, as the pipeline runs; from uniform ones: "
        "python -m benchmarks.gradient_strategy",
    ),
    Ablation(
        "collision",
        "Collision model on S6 (paper, Supp. Mat., Ablation Study of Collision Model)",
        (
            Variant("proxy", "Simple proxy only", strategy="hybrid", collision="proxy"),
            Variant("sdf", "Proxy + SDF", strategy="hybrid", collision="sdf"),
            Variant("hybrid", "Exact parts", strategy="hybrid"),
        ),
        ("each_event", "search_s"),
        {"proxy": ("1/10",), "sdf": ("8/10",)},
        ("paper: event 2",),
        scenes=("S6",),
        note="the bin stands on the line of the choreography; beside it: "
        "python -m benchmarks.collision_model --layout side",
    ),
    Ablation(
        "optimization",
        "Physical optimization (paper, Table tab:completion, and tab:params)",
        (FULL, NO_DYNAMIC),
        (*_SUITE, "spread"),
        {
            "full": ("16.4 ± 1.0", "94%", "95%"),
            "no_dynamic": ("8.8 ± 2.1", "94%", "61%"),
        },
        ("paper: events", "paper: SLR", "paper: PPA"),
    ),
)


def chosen(names: list[str]) -> tuple[Ablation, ...]:
    """The ablations of `--ablations`: all without names.

    Args:
        names: Keys, also several in one with commas between.

    Raises:
        UserError: If one is none.
    """
    wanted = [part.strip() for name in names for part in name.split(",") if part.strip()]
    known = {ablation.key: ablation for ablation in ABLATIONS}
    unknown = [name for name in wanted if name not in known]
    if unknown:
        raise UserError(f"--ablations {', '.join(unknown)}: choose among {', '.join(known)}")
    return tuple(a for a in ABLATIONS if not wanted or a.key in wanted)


def variants_of(ablations: tuple[Ablation, ...]) -> dict[Variant, tuple[str, ...]]:
    """Every run that ablations need once, with the ids of its scenes (empty: all)."""
    out: dict[Variant, tuple[str, ...]] = {}
    for ablation in ablations:
        for variant in ablation.variants:
            before = out.get(variant)
            whole = before == () or not ablation.scenes
            scenes = () if whole else tuple(dict.fromkeys((*(before or ()), *ablation.scenes)))
            out[variant] = scenes
    return out
