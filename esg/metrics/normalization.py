"""Text normalisation: case, accents, punctuation, spelling variants of compounds, singulars."""

from __future__ import annotations

import re
import unicodedata

_IRREGULAR = {
    "taxis": "taxi", "skis": "ski", "kiwis": "kiwi", "jacuzzis": "jacuzzi", "yetis": "yeti",
    "people": "person", "men": "man", "women": "woman", "children": "child", "mice": "mouse",
    "dice": "die", "knives": "knife", "shelves": "shelf", "leaves": "leaf", "wolves": "wolf",
    "loaves": "loaf", "buses": "bus", "dominoes": "domino", "dominos": "domino",
    "tomatoes": "tomato", "potatoes": "potato", "geese": "goose", "feet": "foot",
    "billiards": "billiard", "vases": "vase", "cases": "case", "axes": "axe", "houses": "house",
    "hoses": "hose", "trapezes": "trapeze", "horses": "horse", "bases": "base",
    "briefcases": "briefcase", "suitcases": "suitcase", "bookcases": "bookcase",
    "staircases": "staircase",
}  # fmt: skip
_SINGULAR_S = {
    "stairs", "steps", "scissors", "glasses", "binoculars", "bus", "canvas", "gas", "cactus",
    "compass", "mattress", "dress", "chess", "tennis", "grass", "glass", "lens", "bleachers",
    "news", "physics", "trellis", "iris",
}  # fmt: skip

_PHRASE_FORMS = {
    "trash can": "trashbin", "trash bin": "trashbin", "garbage can": "trashbin",
    "garbage bin": "trashbin", "rubbish bin": "trashbin", "waste bin": "trashbin",
    "litter bin": "trashbin", "dust bin": "trashbin", "waste basket": "trashbin",
    "trash basket": "trashbin", "recycling bin": "trashbin", "wheelie bin": "trashbin",
    "waste paper basket": "trashbin", "refuse bin": "trashbin",
    "foot ball": "football", "basket ball": "basketball", "base ball": "baseball",
    "volley ball": "volleyball", "ping pong": "pingpong", "table tennis": "pingpong",
    "skate board": "skateboard", "motor cycle": "motorcycle", "motor bike": "motorcycle",
    "pick up": "pickup", "pickup truck": "pickup", "street light": "streetlamp",
    "street lamp": "streetlamp", "lamp post": "streetlamp", "light pole": "streetlamp",
    "fire hydrant": "hydrant", "mail box": "mailbox", "post box": "mailbox",
    "letter box": "mailbox", "ice cream": "icecream", "book shelf": "bookshelf",
    "book case": "bookcase", "note book": "notebook", "lap top": "laptop",
    "shopping cart": "cart", "shopping trolley": "cart", "goal post": "goal",
    "inclined plane": "ramp", "ten pin": "tenpin", "nine pin": "ninepin", "push bike": "bicycle",
    "mobile phone": "phone", "cell phone": "phone", "smart phone": "phone",
    "station wagon": "car", "motor car": "car", "passenger car": "car", "eight ball": "8 ball",
    "stair case": "staircase", "stair way": "stairs", "flower pot": "flowerpot",
    "plant pot": "flowerpot", "side walk": "sidewalk", "cross road": "crossroad",
    "wheel barrow": "wheelbarrow", "parking lot": "parkinglot", "utility pole": "pole",
    "telephone pole": "pole", "traffic light": "trafficlight", "road sign": "sign",
}  # fmt: skip


def normalize(text: str) -> str:
    """Lower case, no accents, hyphens and underscores as spaces, possessives dropped."""
    text = unicodedata.normalize("NFKD", text)
    text = "".join(c for c in text if not unicodedata.combining(c)).lower()
    text = re.sub(r"['’]s\b", "", text)
    text = text.replace("no.", "number ").replace("#", " number ")
    text = re.sub(r"[^a-z0-9.]+", " ", text).replace(".", " ")
    text = re.sub(r"(?<=[a-z])(?=\d)", " ", text)
    text = " ".join(text.split())
    return _merge_words(text)


def _merge_words(text: str) -> str:
    words = text.split()
    out: list[str] = []
    i = 0
    while i < len(words):
        for n in (3, 2):
            key = (
                " ".join([*words[i : i + n - 1], singular(words[i + n - 1])])
                if i + n <= len(words)
                else ""
            )
            if key in _PHRASE_FORMS:
                plural = words[i + n - 1] != singular(words[i + n - 1])
                out.append(_PHRASE_FORMS[key] + ("s" if plural else ""))
                i += n
                break
        else:
            out.append(words[i])
            i += 1
    return " ".join(out)


def singular(word: str) -> str:
    """Singular of an English noun (rules and the irregular ones that scenes contain)."""
    if word in _IRREGULAR:
        return _IRREGULAR[word]
    if word in _SINGULAR_S or len(word) < 3 or not word.endswith("s") or word.endswith("ss"):
        return word
    if word.endswith("ies") and len(word) > 4:
        return word[:-3] + "y"
    if re.search(r"(ch|sh|x|ss|zz)es$", word):
        return word[:-2]
    if word.endswith(("us", "is")):
        return word
    return word[:-1]
