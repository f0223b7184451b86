"""What is lit, sways and falls in a document, with the parts of the models that show it."""

from __future__ import annotations

from dataclasses import replace

from esg.assets.appearance import Appearance
from esg.assets.appearances import appearances
from esg.assets.colors import find_color
from esg.assets.configuration import parametric_entry
from esg.assets.geometry.sketch import Part as SketchPart
from esg.assets.library.catalogue import build_sketch
from esg.engines.scene import GivesOff, Shine
from esg.graph.casting import effective
from esg.graph.models import EsgDocument, Predicate, Statement
from esg.lexicon.plumes import plumes
from esg.lexicon.shown import LIVELY, Sway, read_lit, swaying

FLAME = "flame"
"""Name of the part that flames are."""
TOPMOST = "+"
"""Behind the name of parts of which only those shine that reach the top of the model."""
FLASH_S, FLICKER_S = 0.5, 0.9
"""Periods of flashing and flickering lights [s]: UN ECE R65 asks for 2 to 4 flashes a second."""
_TRAFFIC = {"red": "green", "green": "red", "amber": "green"}
"""What a traffic light shows before it turns."""


def shines_of(doc: EsgDocument) -> dict[str, tuple[Shine, ...]]:
    """Lights and flames by the id of a node, of those that are said to be lit.

    Args:
        doc: A resolved document.
    """
    told = [s for s in doc.statements or () if s.predicate is Predicate.LIT]
    out: dict[str, tuple[Shine, ...]] = {}
    for s in told:
        for name in s.object:
            if name in doc.spatial_relation_graph.nodes:
                out[name] = out.get(name, ()) + _shines(s, [p.name for p in sketched(doc, name)])
    return {name: shines for name, shines in out.items() if shines}


def _shines(s: Statement, parts: list[str]) -> tuple[Shine, ...]:
    said = read_lit(s.noun or "")
    if said is None:
        return ()
    light, turned, how, color = said
    rgb = find_color(color) or light.color
    event = s.when if s.when not in ("start", "end", "throughout") and turned else ""
    lit = Shine(FLAME, rgb, not turned and how != "off", how != "off", event)
    if turned and how == "off":
        lit = replace(lit, before=True, after=False)
    if how == "flashing":
        lit = replace(lit, period_s=FLASH_S if light.name == "beacon" else FLICKER_S)
    if light.flame:
        return (lit,)
    told = tuple(p.removesuffix(TOPMOST) for p in light.parts)
    topmost = {p.removesuffix(TOPMOST) for p in light.parts if p.endswith(TOPMOST)}
    own = [p + TOPMOST * (p in topmost) for p in dict.fromkeys(parts) if p.startswith(told)]
    colored = [p for p in own if p.endswith(f"_{color}")]
    if light.name == "traffic light":
        other = [p for p in own if p.endswith(f"_{_TRAFFIC.get(color, '')}")] if turned else []
        own = colored or own[:1]
        hues = {"red": "#db1411", "green": "#199e47", "amber": "#f2b214"}
        before = tuple(
            replace(
                lit,
                part=p,
                before=True,
                after=False,
                color=find_color(hues[_TRAFFIC[color]]) or rgb,
            )
            for p in other
        )
        return (*(replace(lit, part=p) for p in own), *before)
    return tuple(replace(lit, part=p) for p in own)


def sways_of(doc: EsgDocument) -> dict[str, Sway]:
    """How nodes sway, by their ids, of those that are said to.

    Args:
        doc: A resolved document.
    """
    out: dict[str, Sway] = {}
    told = [s for s in doc.statements or () if s.predicate is Predicate.SWAYS]
    for s in told:
        for name in s.object:
            node = doc.spatial_relation_graph.nodes.get(name)
            if node is None:
                continue
            asset = doc.asset_requirement.get(node.asset_id)
            config = effective(doc).asset_configurations[node.asset_id]
            called = [
                config.category.replace("_", " "),
                *(() if asset is None else [asset.asset_category.replace("_", " ")]),
            ]
            row = next((swaying()[c] for c in called if c in swaying()), None)
            if row is not None:
                much = LIVELY.get(s.noun or "", 1.0)
                out[name] = replace(row, degrees=row.degrees * much)
    return out


def plumes_of(doc: EsgDocument) -> dict[str, tuple[GivesOff, ...]]:
    """Smoke, steam, dust and sparks by the id of the node that is said to give them off."""
    out: dict[str, tuple[GivesOff, ...]] = {}
    for s in doc.statements or ():
        if s.predicate is Predicate.GIVES_OFF and s.noun in plumes():
            for name in s.object:
                out[name] = (*out.get(name, ()), GivesOff(s.noun, since(s)))
    return out


def since(s: Statement) -> str:
    """The event from which on a statement holds; empty if it does from the start."""
    first = s.when.partition("..")[0]
    return "" if first in ("start", "throughout", "end") else first


def weather_of_scene(doc: EsgDocument) -> tuple[str, ...]:
    """What falls or hangs in the air, as statements name it."""
    told = [s.noun for s in doc.statements or () if s.predicate is Predicate.WEATHER and s.noun]
    return tuple(dict.fromkeys(told))


def named(parts: list[SketchPart], name: str) -> list[SketchPart]:
    """Parts of a name; with a "+" behind it those of them that reach the top of the model."""
    own = [p for p in parts if p.name == name.removesuffix(TOPMOST)]
    if not name.endswith(TOPMOST):
        return own
    tops = [float(p.mesh().bounds[1, 2]) for p in parts]
    return [p for p in own if float(p.mesh().bounds[1, 2]) >= max(tops) - 0.1]


def sketched(doc: EsgDocument, name: str, look: Appearance | None = None) -> list[SketchPart]:
    """The parts of a node's model before it is finished; none of what no builder draws.

    Args:
        doc: A resolved document.
        name: Id of the node.
        look: What it looks like; default as in the document.
    """
    doc = effective(doc)
    config = doc.asset_configurations[doc.spatial_relation_graph.nodes[name].asset_id]
    entry = parametric_entry(config)
    if entry is None:
        return []
    look = appearances(doc)[name] if look is None else look
    return build_sketch(entry, config.dimensions_cm, config.color_rgb, look).parts
