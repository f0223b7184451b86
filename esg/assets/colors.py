"""Colour words."""

from __future__ import annotations

COLORS: dict[str, tuple[int, int, int]] = {
    "black": (24, 24, 26),
    "white": (240, 240, 236),
    "red": (196, 28, 30),
    "green": (40, 130, 58),
    "blue": (36, 84, 170),
    "yellow": (238, 196, 36),
    "orange": (236, 116, 30),
    "purple": (112, 52, 148),
    "violet": (120, 70, 170),
    "pink": (236, 130, 170),
    "brown": (118, 76, 44),
    "gray": (130, 132, 136),
    "grey": (130, 132, 136),
    "silver": (192, 195, 200),
    "gold": (206, 166, 60),
    "golden": (206, 166, 60),
    "beige": (222, 206, 176),
    "cyan": (40, 180, 196),
    "turquoise": (52, 186, 176),
    "teal": (24, 128, 128),
    "magenta": (196, 40, 140),
    "navy": (26, 42, 92),
    "maroon": (110, 26, 34),
    "crimson": (176, 20, 48),
    "scarlet": (206, 34, 26),
    "olive": (110, 112, 44),
    "lime": (150, 206, 50),
    "ivory": (244, 240, 222),
    "cream": (244, 236, 208),
    "tan": (200, 164, 116),
    "khaki": (176, 160, 106),
    "bronze": (150, 104, 52),
    "copper": (184, 110, 62),
    "indigo": (64, 48, 140),
    "lavender": (184, 168, 220),
    "coral": (240, 124, 92),
    "salmon": (240, 144, 120),
    "mint": (160, 220, 180),
    "amber": (240, 170, 30),
    "charcoal": (54, 56, 60),
    "ochre": (204, 119, 34),
    "burgundy": (112, 22, 44),
    "mauve": (176, 138, 168),
    "lilac": (200, 162, 204),
    "aqua": (88, 204, 204),
    "fuchsia": (214, 44, 140),
    "azure": (52, 140, 220),
    "emerald": (38, 150, 100),
    "peach": (246, 190, 152),
    "plum": (112, 50, 96),
    "transparent": (214, 228, 234),
    "clear": (214, 228, 234),
}


def find_color(text: str | None) -> tuple[float, float, float] | None:
    """RGB in [0, 1] of a colour word, phrase ("dark blue") or "#rrggbb"; None if there is none."""
    if not text:
        return None
    text = text.strip().lower()
    if len(text) == 7 and text.startswith("#"):
        try:
            return tuple(int(text[i : i + 2], 16) / 255.0 for i in (1, 3, 5))  # type: ignore[return-value]
        except ValueError:
            return None
    words = text.replace("-", " ").replace("_", " ").split()
    for word in reversed(words):
        stem = word[:-3] if word.endswith("ish") else word
        base = COLORS.get(word) or COLORS.get(stem) or COLORS.get(stem[:-1])
        if base:
            factor = 0.6 if "dark" in words else 1.0
            lift = 0.4 if {"light", "pale", "bright"} & set(words) else 0.0
            return tuple(  # type: ignore[return-value]
                c / 255.0 * factor * (1 - lift) + lift for c in base
            )
    return None


def color_word(color: tuple[float, float, float]) -> str:
    """The colour word nearest to an RGB in [0, 1]."""

    def off(word: str) -> float:
        return sum((255.0 * a - b) ** 2 for a, b in zip(color, COLORS[word], strict=True))

    return min(COLORS, key=off)
