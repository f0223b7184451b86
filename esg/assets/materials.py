"""Contact materials: friction, restitution and density, with the source of each figure.

Pairs combine by average, so a value is a property of one surface against an ordinary partner. Ball
restitutions follow the rebound rules of their sports, e = sqrt(h_rebound / h_drop).
"""

from __future__ import annotations

from dataclasses import dataclass


@dataclass(frozen=True)
class Material:
    """One surface and substance.

    Args:
        name: Key.
        density: Of the substance [kg/m^3].
        friction: Coefficient of dry friction.
        restitution: Coefficient of restitution.
        source: Where the figures come from.
    """

    name: str
    density: float
    friction: float
    restitution: float
    source: str


_TOOLBOX = "Engineering ToolBox, friction coefficients and densities of common materials"
_ROWS = (
    ("wood", 600, 0.45, 0.40, f"{_TOOLBOX}: wood on wood 0.25-0.5; pine-oak 500-750 kg/m3"),
    ("wood_panel", 680, 0.40, 0.35, f"{_TOOLBOX}: wood on wood; chipboard and MDF 600-750"),
    (
        "wood_lacquered",
        700,
        0.20,
        0.40,
        "USBC lane inspection: friction below 0.39, oiled 0.04-0.2",
    ),
    ("steel", 7850, 0.40, 0.45, f"{_TOOLBOX}: steel on steel 0.42-0.57 dry sliding"),
    (
        "steel_hardened",
        7850,
        0.20,
        0.95,
        "Goldsmith, Impact (1960): hardened steel balls 0.9-0.95 at low speeds; polished",
    ),
    ("cast_iron", 7200, 0.40, 0.40, f"{_TOOLBOX}: cast iron 0.15-1.1, 6800-7800 kg/m3"),
    ("aluminium", 2700, 0.40, 0.45, f"{_TOOLBOX}: aluminium on steel 0.47"),
    ("brass", 8500, 0.38, 0.45, f"{_TOOLBOX}: brass on steel 0.35-0.51"),
    ("copper", 8960, 0.40, 0.40, f"{_TOOLBOX}: copper on steel 0.36-0.53"),
    ("gold", 19300, 0.40, 0.30, f"{_TOOLBOX}: density 19300"),
    ("lead", 11340, 0.45, 0.15, f"{_TOOLBOX}: density 11340; lead is nearly inelastic"),
    ("glass", 2500, 0.35, 0.55, f"{_TOOLBOX}: glass on glass 0.4; soda-lime 2500 kg/m3"),
    ("ceramic", 2400, 0.40, 0.45, f"{_TOOLBOX}: porcelain 2300-2500 kg/m3"),
    ("stone", 2600, 0.60, 0.30, f"{_TOOLBOX}: stone on stone 0.6-0.7; granite 2650"),
    (
        "stone_polished",
        2700,
        0.15,
        0.35,
        "polished granite: 0.1-0.4 dry, 0.01 on pebbled ice (Nyberg)",
    ),
    ("marble_stone", 2700, 0.45, 0.40, f"{_TOOLBOX}: marble 2700 kg/m3"),
    ("concrete", 2400, 0.65, 0.25, f"{_TOOLBOX}: rubber on concrete 0.6-0.85; 2400 kg/m3"),
    ("brick", 1900, 0.62, 0.25, f"{_TOOLBOX}: brick on wood 0.6; 1900 kg/m3"),
    ("asphalt", 2300, 0.70, 0.30, f"{_TOOLBOX}: rubber on asphalt 0.5-0.9"),
    ("grass", 1200, 0.35, 0.30, f"{_TOOLBOX}: rubber on grass 0.35"),
    ("rubber", 1150, 0.70, 0.70, f"{_TOOLBOX}: rubber on dry asphalt 0.5-0.9, 1100-1200 kg/m3"),
    ("rubber_hard", 1350, 0.20, 0.45, "IIHF puck of vulcanized rubber, frozen for play"),
    ("plastic", 950, 0.35, 0.45, f"{_TOOLBOX}: polyethylene on steel 0.2, polystyrene 0.3-0.35"),
    ("plastic_hard", 1050, 0.35, 0.50, f"{_TOOLBOX}: ABS and polycarbonate 0.3-0.5"),
    ("composite", 1600, 0.35, 0.45, "carbon-fibre laminate data sheets, 1550-1650 kg/m3"),
    ("phenolic", 1300, 0.18, 0.65, "USBC ball specification: lane friction below 0.32"),
    (
        "phenolic_ball",
        1700,
        0.06,
        0.95,
        "Alciatore, pool physics: ball-ball e 0.92-0.98, mu 0.03-0.08",
    ),
    (
        "cloth_table",
        700,
        0.25,
        0.50,
        "Alciatore, pool physics: cloth mu 0.15-0.4; cushion e with a ball 0.7-0.85",
    ),
    ("leather_ball", 85, 0.50, 0.76, "FIFA quality programme: rebound 115-155 cm from 200 cm"),
    ("basketball", 85, 0.60, 0.83, "FIBA: rebound 124-136 cm (lower edge) from 180 cm"),
    ("felt_ball", 360, 0.60, 0.74, "ITF: rebound 135-147 cm from 254 cm"),
    ("hard_ball", 700, 0.50, 0.55, "MLB: coefficient of restitution 0.514-0.578"),
    ("golf_ball", 1130, 0.35, 0.80, "USGA: ball and club COR at most 0.83"),
    ("celluloid", 84, 0.30, 0.89, "ITTF: rebound 24-26 cm from 30.5 cm"),
    ("inflatable", 20, 0.55, 0.65, "estimate between FIFA rebound and a slack bladder"),
    ("paper", 800, 0.40, 0.15, f"{_TOOLBOX}: paper 700-1200 kg/m3"),
    ("cardboard", 150, 0.45, 0.20, "corrugated board data sheets, mu 0.4-0.6"),
    ("textile", 250, 0.60, 0.10, f"{_TOOLBOX}: cotton on cotton 0.3-0.6"),
    ("leather", 900, 0.50, 0.30, f"{_TOOLBOX}: leather on wood 0.3-0.54"),
    ("foam", 40, 0.60, 0.20, "polyurethane foam data sheets, 25-60 kg/m3"),
    ("wicker", 300, 0.45, 0.25, "as wood; rattan 300-400 kg/m3"),
    ("wax", 900, 0.40, 0.20, f"{_TOOLBOX}: paraffin 900 kg/m3"),
    ("ice", 917, 0.05, 0.30, f"{_TOOLBOX}: ice on ice 0.02-0.09; 917 kg/m3"),
    ("flesh", 985, 0.50, 0.20, "human body density 985 kg/m3; skin friction 0.3-0.7 (Derler)"),
    ("fruit", 850, 0.45, 0.25, "produce handling tables: apple 750-900 kg/m3"),
    ("car_body", 150, 0.30, 0.20, "bumper impacts: e 0.1-0.3 (Kolisnyk, crash test reviews)"),
)
MATERIALS: dict[str, Material] = {row[0]: Material(*row) for row in _ROWS}  # type: ignore[arg-type]

_ALIASES = {
    "wooden": "wood",
    "oak": "wood",
    "pine": "wood",
    "timber": "wood",
    "bamboo": "wood",
    "plywood": "wood_panel",
    "metal": "steel",
    "metallic": "steel",
    "iron": "cast_iron",
    "stainless steel": "steel",
    "aluminum": "aluminium",
    "bronze": "brass",
    "silver": "steel",
    "golden": "gold",
    "porcelain": "ceramic",
    "clay": "ceramic",
    "china": "ceramic",
    "terracotta": "ceramic",
    "granite": "stone",
    "rock": "stone",
    "marble": "marble_stone",
    "cement": "concrete",
    "tarmac": "asphalt",
    "plastic": "plastic_hard",
    "polymer": "plastic",
    "nylon": "plastic",
    "acrylic": "plastic_hard",
    "carbon": "composite",
    "fabric": "textile",
    "cloth": "textile",
    "cotton": "textile",
    "wool": "textile",
    "felt": "textile",
    "carton": "cardboard",
    "crystal": "glass",
    "styrofoam": "foam",
    "sponge": "foam",
    "rubbery": "rubber",
    "tin": "steel",
    "frozen": "ice",
    "grassy": "grass",
}


_MADE_OF: dict[str, frozenset[str]] = {
    "leather_ball": frozenset({"leather", "rubber", "plastic", "plastic_hard", "textile"}),
    "basketball": frozenset({"rubber", "leather", "plastic", "plastic_hard"}),
    "felt_ball": frozenset({"textile", "rubber"}),
    "hard_ball": frozenset({"leather"}),
    "golf_ball": frozenset({"plastic", "plastic_hard", "rubber"}),
    "celluloid": frozenset({"plastic", "plastic_hard"}),
    "inflatable": frozenset({"plastic", "plastic_hard", "rubber"}),
    "phenolic": frozenset({"plastic", "plastic_hard", "composite"}),
    "phenolic_ball": frozenset({"plastic", "plastic_hard", "composite"}),
    "car_body": frozenset({"steel", "aluminium", "cast_iron", "composite"}),
    "cloth_table": frozenset({"wood", "textile", "stone", "wood_panel"}),
    "wood_panel": frozenset({"wood"}),
    "wood_lacquered": frozenset({"wood", "wood_panel"}),
    "plastic_hard": frozenset({"plastic"}),
    "rubber_hard": frozenset({"rubber"}),
    "cast_iron": frozenset({"steel"}),
    "asphalt": frozenset({"concrete"}),
    "grass": frozenset({"stone", "asphalt"}),
}
"""Plain materials that a composite row already stands for: naming them changes nothing."""


def is_usual(asked: Material, own: str) -> bool:
    """Whether a request for `asked` only repeats what an entry of material `own` is made of."""
    return asked.name == own or asked.name in _MADE_OF.get(own, frozenset())


def find_material(text: str | None) -> Material | None:
    """The material that a word or phrase names ("wooden", "stainless steel"), or None."""
    if not text:
        return None
    words = text.lower().replace("_", " ").replace("-", " ").strip()
    for key in (words, *reversed(words.split())):
        name = _ALIASES.get(key, key.replace(" ", "_"))
        if name in MATERIALS:
            return MATERIALS[name]
    return None
