"""Diagrams of the documentation: what leads to what, where a picture says it sooner than a page."""

from __future__ import annotations

from benchmarks.lib.svg import COLORS, Box, boxes

blue, red, green, orange, violet = COLORS
DIAGRAMS = {
    "compile": boxes(
        [
            Box("doc", 0, 1, ("esg.json", "poses, masses, joints", "control program"), blue),
            Box("class", 1, 0, ("Unreal class", ".h and .cpp"), violet),
            Box("manifest", 1, 1, ("manifest.json", "scene and program"), violet),
            Box("shim", 2, 0, ("compiled by g++", "against a shim of", "Unreal's API"), orange),
            Box("physx", 3, 0, ("PhysX, Rapier", "240 steps a second"), orange),
            Box("judge", 3, 1, ("judge", "did it happen?"), green),
            Box("plugin", 2, 1, ("Unreal plugin", "--to unreal"), blue),
            Box("others", 2, 2, ("USD, MJCF, GLB", "--to usd|mjcf|glb"), blue),
        ],
        [("doc", "class"), ("doc", "manifest"), ("class", "shim"),
         ("shim", "physx"), ("physx", "judge"), ("class", "plugin"),
         ("manifest", "others")],
    ),
    "unreal": boxes(
        [
            Box("values", 0, 0, ("AEsgScene_S6", "values, program, events"), violet),
            Box("base", 1, 0, ("AEsgScene", "spawns and drives"), blue),
            Box("world", 2, 0, ("Chaos", "moves the bodies"), orange),
            Box("tick", 2, 1, ("contacts, poses",), orange),
            Box("events", 1, 1, ("events", "named when they happen"), green),
            Box("panel", 0, 1, ("Details panel", "every value with its unit"), blue),
        ],
        [("values", "base"), ("base", "world"), ("world", "tick"),
         ("tick", "events"), ("panel", "values")],
    ),
    "trust": boxes(
        [
            Box("folder", 0, 1, ("a stranger's folder", "data and C++"), red),
            Box("checks", 1, 1, ("checked", "links, sizes, SHA256SUMS"), orange),
            Box("data", 2, 0, ("report, view, render,", "export, check: no code runs"), green),
            Box("same", 2, 1, ("replay", "is the class ours?"), orange),
            Box("child", 3, 1, ("yes: a child without", "network, files, processes"), green),
            Box("program", 3, 2, ("no: the program", "alone is played"), green),
            Box("trust", 2, 2, ("replay --trust", "any class: you vouch"), red),
        ],
        [("folder", "checks"), ("checks", "data"), ("checks", "same"),
         ("checks", "trust"), ("same", "child"), ("same", "program")],
        column=215, wide=178,
    ),
    "store": boxes(
        [
            Box("worker", 0, 1, ("workers", "a scene each"), orange),
            Box("cache", 1, 0, ("artifacts/", "a file a stage, by content"), blue),
            Box("parts", 1, 1, ("Parquet parts", "one a batch"), blue),
            Box("folder", 1, 2, ("scene folder", "MCAP, films, exports"), blue),
            Box("set", 2, 0, ("dataset", "splits, card, statistics"), violet),
            Box("db", 2, 1, ("DuckDB", "one writer, any reader"), violet),
            Box("sql", 3, 1, ("esg sql", "views, CSV, Markdown"), green),
            Box("load", 3, 0, ("esg.load_dataset", "pandas, polars, torch"), green),
        ],
        [("worker", "cache"), ("worker", "parts"), ("worker", "folder"),
         ("parts", "set"), ("parts", "db"), ("db", "sql"), ("set", "load")],
        column=205, wide=168,
    ),
    "drafting_llm": boxes(
        [
            Box("scene", 0, 0, ("request 1: scene", "assets, objects, places"), violet),
            Box("time", 1, 0, ("request 2: timeline", "events, motions, statements"), violet),
            Box("code", 2, 0, ("assembly", "names, regions, joints"), orange),
            Box("check", 3, 0, ("verifier", "all violations at once"), green),
            Box("back", 2, 1, ("revision", "to the stage that owns it"), violet),
            Box("doc", 3, 1, ("document", "the same as by rules"), blue),
        ],
        [("scene", "time"), ("time", "code"), ("code", "check"),
         ("check", "back"), ("back", "time"), ("check", "doc")],
        column=212, wide=176,
    ),
    "judging": boxes(
        [
            Box("file", 0, 1, ("anybody's motion", "GLB, USD, CSV, Kubric"), blue),
            Box("names", 1, 0, ("names", "whose body is which"), orange),
            Box("bodies", 1, 1, ("bodies and poses", "resampled, in metres"), orange),
            Box("contacts", 2, 1, ("contacts", "recomputed from shapes"), orange),
            Box("suite", 2, 0, ("suite", "written from the prompt"), violet),
            Box("judge", 3, 1, ("judge", "the same as for ours"), green),
        ],
        [("file", "bodies"), ("names", "bodies"), ("bodies", "contacts"),
         ("contacts", "judge"), ("suite", "judge")],
        column=205, wide=168,
    ),
}  # fmt: skip
