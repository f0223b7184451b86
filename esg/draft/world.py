"""Discourse: which object each noun phrase and pronoun means."""

from __future__ import annotations

from dataclasses import dataclass, field
import re

from esg.draft import lexicon as lex
from esg.draft.quantities import Amount
from esg.draft.syntax import Mention

_ORDINALS = {
    "first": 0, "1st": 0, "second": 1, "2nd": 1, "third": 2, "3rd": 2, "fourth": 3, "4th": 3,
    "fifth": 4, "5th": 4, "sixth": 5, "seventh": 6, "eighth": 7, "ninth": 8, "tenth": 9,
}  # fmt: skip
_FRONT = frozenset({"front", "lead", "leading", "foremost"})
_REAR = frozenset({"rear", "back", "trailing", "following", "hindmost", "rearmost"})
_OTHER = frozenset({"other", "remaining", "another", "next", "opposite"})
_HYPERNYMS: dict[str, frozenset[str]] = {
    "vehicle": frozenset({"vehicle", "cart", "robot", "toyvehicle"}),
    "animal": frozenset({"animal"}),
    "toy": frozenset({"toy", "toyvehicle", "block", "game"}),
    "container": frozenset({"container", "box", "barrel", "bottle"}),
    "furniture": frozenset({"furniture", "table", "seat"}),
    "fruit": frozenset({"food"}),
    "projectile": frozenset({"ball", "rock", "projectile"}),
    "person": frozenset({"person"}),
    "child": frozenset({"person"}),
}
_NUMBERS = frozenset("eight nine seven six five four three two one 8 9 7 6 5 4 3 2 1".split())
_DISTINCT = frozenset({"person", "animal", "food", "tool", "plant", "tableware", "ground", "book"})
"""Kinds whose synonyms name different things (man and woman, lemon and orange)."""
_ANYTHING = frozenset({"object", "thing", "item", "body", "prop", "entity", "projectile"})
_NAMED_GROUPS = frozenset({"tower", "pyramid", "pile", "heap", "convoy"})

MAX_COUNT = 40
"""Most members of one plural."""
UNKNOWN_MASS_KG = 5.0


@dataclass
class Entity:
    """One object of the scene (or one member of a plural).

    Args:
        id: Node id.
        noun: Lexicon entry, a fallback for unknown nouns.
        head: The prompt's own noun.
        label: The prompt's phrase without article.
        group: Name shared by the members of a plural.
    """

    id: str
    noun: lex.Noun
    head: str
    label: str
    adjectives: list[str] = field(default_factory=list)
    letter: str = ""
    group: str | None = None
    pattern: str | None = None
    mentioned: bool = True
    known: bool = True
    mass_kg: float | None = None
    mass_prescribed: bool = False
    mass_factor: float = 1.0
    dimensions_cm: list[float] | None = None
    dimensions_prescribed: bool = False
    static: bool = False
    freed: bool = False
    """Normally fixed, but the prompt moves it (a fence post that falls over)."""
    place: str = ""
    """front, rear, left, right or an ordinal, once known."""
    origin: int = -1
    """Offset of the first mention, for coverage."""

    @property
    def movable(self) -> bool:
        """Whether it can move in the simulation."""
        traits = self.noun.traits
        return not ({"structural", "decal"} & traits) and (self.freed or "fixed" not in traits)

    @property
    def color(self) -> str | None:
        return next((lex.COLORS[a] for a in self.adjectives if a in lex.COLORS), None)


def slug(text: str) -> str:
    return re.sub(r"[^a-z0-9]+", "_", text.lower()).strip("_")


def unknown_noun(head: str) -> lex.Noun:
    """A sized stand-in for a noun outside the lexicon."""
    return lex.Noun(
        name=head,
        kind="generic",
        dimensions_cm=(40.0, 40.0, 40.0),
        mass_kg=UNKNOWN_MASS_KG,
        material="plastic",
        shape="box",
        traits=frozenset(),
        description=head,
    )


class World:
    """Entities in order of mention, and the references between them."""

    def __init__(self) -> None:
        self.entities: dict[str, Entity] = {}
        self.groups: dict[str, list[str]] = {}
        self.collective: set[str] = set()
        """Groups that "it" can mean ("a tower of blocks")."""
        self.salience: list[list[str]] = []
        """Referent sets, most recent last."""
        self.subjects: list[list[str]] = []
        self.resolved: dict[int, list[str]] = {}
        self.warnings: list[str] = []
        self.conflicts: list[str] = []
        """Two values stated for one property."""
        self.file_of_two = False
        """The prompt says "one in front of the other"."""

    # -- creation --------------------------------------------------------------------------------

    def _new_id(self, stem: str) -> str:
        n = 1
        while f"{stem}_{n}" in self.entities:
            n += 1
        return f"{stem}_{n}"

    def add(
        self,
        noun: lex.Noun,
        head: str,
        *,
        adjectives: list[str] | None = None,
        letter: str = "",
        label: str = "",
        group: str | None = None,
        pattern: str | None = None,
        mentioned: bool = True,
        known: bool = True,
        origin: int = -1,
    ) -> Entity:
        """Creates one entity with a readable node id."""
        adjectives = list(adjectives or [])
        naming = [
            a
            for a in adjectives
            if a in lex.COLORS or a in _FRONT or a in _REAR or a in _ORDINALS or a in ("left", "right")
        ]
        stem = slug(" ".join([*naming, head]))
        if letter:
            name = slug(f"{head}_{letter}")
            name = name if name not in self.entities else self._new_id(name)
        else:
            name = self._new_id(stem)
        entity = Entity(
            name, noun, head, label or head, adjectives, letter, group, pattern, mentioned, known,
            origin=origin,
        )  # fmt: skip
        for adjective in adjectives:
            self._place(entity, adjective)
        self.entities[name] = entity
        return entity

    @staticmethod
    def _place(entity: Entity, adjective: str) -> None:
        if adjective in _FRONT:
            entity.place = "front"
        elif adjective in _REAR:
            entity.place = "rear"
        elif adjective in _ORDINALS:
            entity.place = adjective
        elif adjective in ("left", "right", "leftmost", "rightmost"):
            entity.place = adjective[:5].removesuffix("m")

    # -- resolution ------------------------------------------------------------------------------

    def note(self, ids: list[str], subject: bool = False) -> None:
        """Makes a referent set the most salient one."""
        if ids and self.entities[ids[0]].noun.kind != "region":
            self.salience.append(ids)
            if subject:
                self.subjects.append(ids)

    def resolve(self, m: Mention, *, subject: bool = False, avoid: list[str] | None = None) -> list[str]:
        """Node ids of a mention (and of what is coordinated with it); new objects are created.

        Args:
            m: The noun phrase.
            subject: Whether it is a grammatical subject (pronouns prefer the last subject then).
            avoid: Ids that it cannot mean (the subject of its own clause).
        """
        key = id(m)
        if key in self.resolved:
            ids = self.resolved[key]
        else:
            ids = self._one(m, subject, avoid or [])
            for other in m.coordinated:
                extra = self.resolve(other, avoid=avoid)
                ids = ids + [e for e in extra if e not in ids]
            self.resolved[key] = ids
            m.entities = ids
        self.note(ids, subject)
        return ids

    def _one(self, m: Mention, subject: bool, avoid: list[str]) -> list[str]:
        if m.attribute or (not m.head and not m.pronoun):
            if m.possessor is not None:
                return self.resolve(m.possessor)
            return []
        if m.count == 0:
            return []
        if m.pronoun:
            return self._pronoun(m, subject, avoid)
        if m.role and m.noun is not None:
            driven = [
                ids for ids in reversed(self.salience)
                if len(ids) == 1 and self.entities[ids[0]].noun.kind in ("vehicle", "flyer", "cart", "watercraft")
            ]  # fmt: skip
            if m.possessor is not None:
                return self.resolve(m.possessor)
            if driven and m.determiner != "a":
                return driven[0]
        found = self._existing(m, avoid)
        if found:
            self._enrich(m, found)
            return found
        return self._create(m)

    # -- existing --------------------------------------------------------------------------------

    def _matches(self, m: Mention, e: Entity) -> bool:
        if m.letters:
            return e.letter in m.letters and (m.head == "@" or self._same_kind(m, e))
        if not self._same_kind(m, e):
            return False
        for a in m.adjectives:
            if a in lex.COLORS and e.color is not None and lex.COLORS[a] != e.color:
                return False
            if a in lex.COLORS and e.color is None and (e.group is None or e.letter):
                return False
            if a in lex.MATERIALS and a not in e.adjectives and a not in e.head.split():
                return False
            if a in lex.SIZES and any(b in lex.SIZES and lex.SIZES[b] != lex.SIZES[a] for b in e.adjectives):
                return False
            if a in lex.WEIGHTS and any(b in lex.WEIGHTS and lex.WEIGHTS[b] != lex.WEIGHTS[a] for b in e.adjectives):
                return False
            if a in _FRONT and e.place == "rear":
                return False
            if a in _REAR and e.place == "front":
                return False
            if a in _ORDINALS and (e.place != a):
                return False
            if a in ("left", "right", "leftmost", "rightmost") and e.place and not a.startswith(e.place):
                return False
        return True

    @staticmethod
    def _same_kind(m: Mention, e: Entity) -> bool:
        if m.head in _ANYTHING:
            return "structural" not in e.noun.traits
        if m.head in _HYPERNYMS and e.noun.kind in _HYPERNYMS[m.head]:
            return True
        if m.noun is not None and e.known:
            if m.noun.name == e.noun.name:
                if m.head == e.head:
                    return True
                numbered = {*m.head.replace("-", " ").split(), *e.head.replace("-", " ").split()} & _NUMBERS
                if numbered or m.noun.kind in _DISTINCT:
                    return m.head == m.noun.name and not numbered
                return True
            words, own = m.head.split(), e.noun.name.split() + e.head.split()
            if len(words) == 1 and words[0] in own and (
                e.noun.name.split()[-1] == words[0] or e.head.split()[-1] == words[0]
            ):
                return True
            if m.head == "ball" and "round" in e.noun.traits and e.noun.kind in ("ball", "billiard"):
                return True
            return False
        return m.head == e.head

    def _existing(self, m: Mention, avoid: list[str]) -> list[str]:
        if (m.determiner in ("a", "an", "one", "any") or (m.count == 1 and not m.determiner)) and not m.plural and not m.letters and m.count in (None, 1):
            return self._member(m, avoid)
        definite = m.determiner in ("the", "this", "that", "these", "those", "its", "his", "her", "their", "both", "all", "each", "every") or bool(m.letters)
        structural = m.noun is not None and "structural" in m.noun.traits
        bare = m.determiner == "" and not m.pattern
        if not (definite or structural or bare):
            return []
        if "another" in (m.determiner,) or ("other" in m.adjectives and not definite):
            return []
        names = [e for e in self.entities.values() if self._matches(m, e)]
        if m.letters:
            by_letter = {e.letter: e.id for e in names}
            ids = [by_letter[x] for x in m.letters if x in by_letter]
            missing = [x for x in m.letters if x not in by_letter]
            for x in missing:
                ids.append(self._letter(m, x))
            return ids
        if "other" in m.adjectives or "remaining" in m.adjectives:
            last = self.salience[-1] if self.salience else []
            rest = [e.id for e in names if e.id not in last and e.id not in avoid]
            return rest if m.plural else rest[:1]
        ordinal = next((a for a in m.adjectives if a in _ORDINALS or a in ("last", "final")), None)
        if ordinal is not None:
            found = self._ordinal(m, ordinal)
            if not found and ordinal == "first" and m.noun is not None and m.noun.kind == "domino":
                row = Mention(m.start, m.end, head=m.head, noun=m.noun, plural=True, text=m.head)
                self._create(row)
                found = self._ordinal(m, ordinal)
            return found
        place = next((a for a in m.adjectives if a in _FRONT | _REAR), None)
        if place is not None:
            want = "front" if place in _FRONT else "rear"
            exact = [e for e in names if e.place == want]
            if exact:
                return [exact[-1].id]
            member = [e for e in names if e.group is not None and not e.place]
            if member:
                chosen = member[0] if want == "front" else member[-1]
                self._specialize(m, chosen)
                return [chosen.id]
            if bare and not definite:
                return []
        if not names:
            return []
        if m.plural or (m.count or 1) > 1:
            ids = [e.id for e in names]
            groups = {e.group for e in names if e.group}
            if m.count and len(ids) != m.count and len(groups) > 1:
                recent = next((g for g in reversed(list(self.groups)) if g in groups), None)
                if recent is not None and len(self.groups[recent]) == m.count:
                    return list(self.groups[recent])
            if m.count and m.count > len(ids) and not definite:
                return []
            if bare and m.count is None and not structural and len(ids) < 2:
                return []
            return ids
        if bare and not structural and not definite:
            # a bare singular ("car hits wall") repeats an object only if one is there
            singles = [e for e in names if e.group is None]
            return [singles[-1].id] if singles else []
        color = next((a for a in m.adjectives if a in lex.COLORS), None)
        if color is not None:
            exact = [e for e in names if e.color == lex.COLORS[color]]
            if exact:
                return [exact[-1].id]
            member = [e for e in names if e.group is not None and not e.letter]
            if member and member[0].noun.kind != "billiard":
                self._specialize(m, member[0])
                return [member[0].id]
            return []
        order = [i for ids in self.salience for i in ids]
        candidates = [e for e in names if e.id not in avoid] or names
        exact_heads = [e for e in candidates if e.head == m.head or e.noun.name == m.head]
        pool = exact_heads or candidates
        if m.head == "ball" and any(e.noun.kind == "billiard" for e in pool):
            pool = [e for e in pool if not (e.group and e.noun.kind == "billiard")] or pool
        pool.sort(key=lambda e: max((k for k, i in enumerate(order) if i == e.id), default=-1))
        return [pool[-1].id]

    def _member(self, m: Mention, avoid: list[str]) -> list[str]:
        """ "two blue balls ... hits a blue ball": an indefinite that picks a member of a plural."""
        if any(a in _OTHER for a in m.adjectives):
            return []
        colors = {lex.COLORS[a] for a in m.adjectives if a in lex.COLORS}
        pool = [e for e in self.entities.values()
                if e.group and e.id not in avoid and self._matches(m, e)
                and e.noun == m.noun and (not colors or e.color in colors)]  # fmt: skip
        return [pool[0].id] if pool else []

    def _letter(self, m: Mention, letter: str) -> str:
        """Names a member of a plural, or creates the individual."""
        pool = [e for e in self.entities.values() if e.group and not e.letter and self._same_kind(m, e) and not e.place]
        if pool:
            e = pool[0]
            self._rename(e, slug(f"{m.head}_{letter}"))
            e.letter = letter
            e.label = f"{m.head} {letter}"
            return e.id
        noun = m.noun or unknown_noun(m.head)
        plain = [a for a in m.adjectives if not a.startswith("@")]
        entity = self.add(noun, m.head, adjectives=plain, letter=letter, label=f"{m.head} {letter}",
                          known=m.noun is not None, origin=m.start)  # fmt: skip
        self._amounts(m, entity)
        return entity.id

    def _rename(self, e: Entity, name: str) -> None:
        if name in self.entities:
            return
        old = e.id
        self.entities = {(name if k == old else k): v for k, v in self.entities.items()}
        e.id = name
        swap = lambda ids: [name if i == old else i for i in ids]  # noqa: E731
        self.groups = {g: swap(ids) for g, ids in self.groups.items()}
        for ids in [*self.salience, *self.subjects, *self.resolved.values()]:
            ids[:] = swap(ids)

    def _specialize(self, m: Mention, e: Entity) -> None:
        """A member of a plural gets its own name ("two cars ... the front car")."""
        for a in m.adjectives:
            if not a.startswith("@") and a not in e.adjectives:
                e.adjectives.append(a)
            self._place(e, a)
        e.label = m.text or e.label
        e.place = e.place or next((a for a in m.adjectives if a in lex.COLORS), "")
        keep = [a for a in m.adjectives if a in lex.COLORS or a in _FRONT | _REAR or a in _ORDINALS or a in ("left", "right")]
        if keep:
            self._rename(e, self._new_id(slug(" ".join([*keep, e.head]))))
        others = [x for x in self.groups.get(e.group or "", []) if x != e.id]
        if len(others) == 1 and e.place in ("front", "rear"):
            o = self.entities[others[0]]
            if not o.place:
                o.place = "rear" if e.place == "front" else "front"
                o.label = f"{o.place} {o.head}"
                o.adjectives.append(o.place)
                self._rename(o, self._new_id(slug(o.label)))

    def _ordinal(self, m: Mention, ordinal: str) -> list[str]:
        names = [e for e in self.entities.values() if self._same_kind(m, e)]
        exact = [e for e in names if e.place == ordinal]
        if exact:
            return [exact[0].id]
        grouped = [e for e in names if e.group]
        pool = grouped or names
        k = len(pool) - 1 if ordinal in ("last", "final") else _ORDINALS[ordinal]
        if ordinal in _ORDINALS and not grouped:
            # "a ball ... the second ball": the first is the one already there
            taken = [e for e in pool if e.place in ("", "first")]
            if ordinal == "first" and taken:
                return [taken[0].id]
            return []
        if k < len(pool):
            e = pool[k]
            if not e.letter and len(grouped) <= 6:
                e.place = ordinal
                e.label = f"{ordinal} {m.head}"
                e.adjectives.append(ordinal)
                self._rename(e, self._new_id(slug(f"{ordinal} {m.head}")))
            return [e.id]
        return []

    def _pronoun(self, m: Mention, subject: bool, avoid: list[str]) -> list[str]:
        p = m.pronoun
        if p in ("he", "she", "him", "her", "himself", "herself", "someone", "everyone"):
            for ids in reversed(self.salience):
                if len(ids) == 1 and self.entities[ids[0]].noun.kind == "person":
                    return ids
            return []
        if p in ("i", "we", "you", "something", "everything"):
            return []
        if p == "another" and not self.groups:
            model = next((self.entities[i] for i in avoid), None)
            if model is not None:
                other = self.add(model.noun, model.head, adjectives=["second"], label=f"second {model.head}",
                                 known=model.known, origin=m.start)  # fmt: skip
                return [other.id]
        if p in ("they", "them", "themselves", "these", "those", "both", "ones", "all", "each", "some", "many", "several"):
            pool = self.subjects if subject and p not in ("both",) else self.salience
            for ids in reversed(pool):
                if len(ids) > 1 and (subject or not set(ids) <= set(avoid)):
                    return list(ids)
            for ids in reversed(self.salience):
                if len(ids) > 1:
                    return list(ids)
            recent: list[str] = []
            for ids in reversed(self.salience):
                for i in ids:
                    if i not in recent and "structural" not in self.entities[i].noun.traits:
                        recent.append(i)
                if len(recent) >= 2:
                    return recent[:2][::-1]
            return recent
        if p in ("one", "another", "other"):
            return self._one_of(m, avoid)
        # it, itself, this, that
        pools = [self.subjects, self.salience] if subject else [self.salience]
        for pool in pools:
            for ids in reversed(pool):
                fits = [i for i in ids if i not in avoid and "structural" not in self.entities[i].noun.traits
                        and self.entities[i].noun.kind != "person"]  # fmt: skip
                if len(ids) == 1 and fits:
                    return fits
                if fits and len(ids) > 1 and self.entities[ids[0]].group in self.collective:
                    return list(ids)
        for ids in reversed(self.salience):
            if ids and not set(ids) <= set(avoid):
                return list(ids)
        return []

    def _one_of(self, m: Mention, avoid: list[str]) -> list[str]:
        for a in m.adjectives:
            for group in reversed(list(self.groups.values())):
                for i in group:
                    e = self.entities[i]
                    if (a in lex.COLORS and e.color == lex.COLORS[a]) or e.place == a:
                        return [i]
        for a in m.adjectives:
            if a in lex.COLORS:
                for e in reversed(list(self.entities.values())):
                    if e.color == lex.COLORS[a]:
                        return [e.id]
        last_group = next(reversed(list(self.groups.values())), None)
        colors = [a for a in m.adjectives if a in lex.COLORS]
        if colors and last_group:
            plain = [self.entities[i] for i in last_group if self.entities[i].color is None and i not in avoid]
            if plain:
                chosen = plain[0]
                chosen.adjectives.append(colors[0])
                chosen.label = f"{colors[0]} {chosen.head}"
                chosen.place = chosen.place or colors[0]
                self._rename(chosen, self._new_id(slug(chosen.label)))
                return [chosen.id]
        ordinal = next((a for a in m.adjectives if a in _ORDINALS or a == "last"), None)
        if last_group and "next" in m.adjectives:
            return last_group[1:2]
        if last_group:
            if m.pronoun == "one" and m.determiner == "the" and "other" in m.adjectives and not avoid:
                return [last_group[-1]]
            if ordinal is not None:
                k = len(last_group) - 1 if ordinal == "last" else _ORDINALS[ordinal]
                return [last_group[k]] if k < len(last_group) else []
            if "other" in m.adjectives and set(last_group) <= set(avoid):
                return [last_group[-1]]
            if "other" in m.adjectives or m.pronoun in ("other", "another"):
                used = avoid or (self.salience[-1] if self.salience else [])
                rest = [i for i in last_group if i not in used]
                return rest[:1]
            if m.pronoun == "one":
                return [last_group[0]]
        recent = [i for ids in reversed(self.salience) for i in reversed(ids) if i not in avoid]
        return recent[:1]

    # -- creation from mentions ------------------------------------------------------------------

    def _create(self, m: Mention) -> list[str]:
        noun = m.noun or unknown_noun(m.head)
        if noun.name == "net" and m.after_prep in ("into", "in"):
            noun = lex.nouns()["goal"]
        elif noun.name == "hoop" and m.after_prep in ("through", "into", "in"):
            noun = lex.nouns()["basketball hoop"]
        if "structural" in noun.traits and "decal" not in noun.traits:
            return ["ground_1"] if "ground_1" in self.entities else self._ground(noun, m)
        plain = [a for a in m.adjectives if not a.startswith("@")]
        if m.letters:
            return [self._letter(m, x) for x in m.letters]
        count = self._count(m, noun)
        pattern = self._pattern(m, noun, count)
        if "structural" in noun.traits:
            count = 1
        if count <= 1:
            e = self.add(noun, m.head, adjectives=plain, label=m.text or m.head,
                         known=m.noun is not None, origin=m.start)  # fmt: skip
            self._amounts(m, e)
            return [e.id]
        group = slug(" ".join([*[a for a in plain if a in lex.COLORS], m.head])) + "s"
        base = group
        n = 2
        masses = [a for a in m.amounts if a.dimension == "mass"]
        while group in self.groups:
            group, n = f"{base}_{n}", n + 1
        ids: list[str] = []
        for _ in range(count):
            label = f"{m.group_word} of {m.head}s" if m.group_word in _NAMED_GROUPS else m.head
            e = self.add(noun, m.head, adjectives=plain, label=label, group=group, pattern=pattern,
                         known=m.noun is not None, origin=m.start)  # fmt: skip
            self._amounts(m, e)
            if len(masses) == count:
                self.apply_amount(e, masses[len(ids)])
            ids.append(e.id)
        self.groups[group] = ids
        if m.group_word and m.group_word not in ("pair", "couple", "number", "lot", "dozen"):
            self.collective.add(group)
        if self.file_of_two and count == 2:
            self.file_of_two = False
            for i, place in zip(list(ids), ("front", "rear"), strict=True):
                e = self.entities[i]
                e.place, e.label = place, f"{place} {m.head}"
                e.adjectives.append(place)
                self._rename(e, self._new_id(slug(e.label)))
        return list(self.groups[group])

    def _ground(self, noun: lex.Noun, m: Mention) -> list[str]:
        e = Entity("ground_1", noun, m.head, m.text or m.head, list(m.adjectives), origin=m.start)
        self.entities["ground_1"] = e
        return ["ground_1"]

    def _count(self, m: Mention, noun: lex.Noun) -> int:
        if m.count is not None:
            if m.count > MAX_COUNT:
                self.warnings.append(f'"{m.text}": {MAX_COUNT} of {m.count} are placed, the most a scene holds.')
            return max(1, min(m.count, MAX_COUNT))
        if not m.plural and m.pattern is None:
            return 1
        if noun.kind == "pin":
            return 10
        if noun.kind == "domino":
            return 8
        return {"row": 5, "stack": 3, "rack": 6, "queue": 3, "pins": 10}.get(m.pattern or "", 4 if m.pattern else 3)

    @staticmethod
    def _pattern(m: Mention, noun: lex.Noun, count: int) -> str | None:
        if count <= 1:
            return None
        if noun.kind == "pin" and m.pattern in (None, "scatter", "pins", "rack"):
            return "pins"
        if noun.kind == "domino" and m.pattern is None:
            return "row"
        if m.pattern:
            return m.pattern
        if noun.kind in ("vehicle",):
            return "queue" if count <= 3 else "row"
        if count <= 4 and noun.kind in ("ball", "billiard", "box", "block", "barrel"):
            return "scatter"
        return "scatter"

    def _enrich(self, m: Mention, ids: list[str]) -> None:
        for i in ids:
            e = self.entities[i]
            self._amounts(m, e)
            if e.group is None:
                for a in m.adjectives:
                    if a in lex.COLORS and e.color is None:
                        e.adjectives.append(a)

    def _amounts(self, m: Mention, e: Entity) -> None:
        for amount in m.amounts:
            word = next((a.split(":")[1] for a in m.adjectives if a.startswith(f"@{amount.start}:")), "")
            self.apply_amount(e, amount, word)

    def apply_amount(self, e: Entity, amount: Amount, word: str = "") -> str:
        """Applies a mass or size to an entity; returns the field it set or ""."""
        if amount.dimension == "mass":
            if e.mass_prescribed and e.mass_kg is not None and abs(e.mass_kg - amount.middle) > 1e-6:
                self.conflicts.append(f"{e.label} weighs {e.mass_kg:g} kg and {amount.middle:g} kg")
            e.mass_kg, e.mass_prescribed = amount.middle, True
            return "expected_mass_kg"
        if amount.dimension == "length":
            dims = e.dimensions_cm or list(e.noun.dimensions_cm)
            x = amount.middle
            if word in ("tall", "high", "deep", "height"):
                dims[2] = x
            elif word in ("wide", "width"):
                dims[1] = x
            elif word in ("long", "length"):
                dims[0] = x
            elif word in ("diameter", "radius", "thick", "in diameter"):
                x = 2.0 * x if word == "radius" else x
                if e.noun.shape == "sphere":
                    dims = [x, x, x]
                else:
                    dims[0] = dims[1] = x
            else:
                largest = max(dims)
                dims = [d * x / largest for d in dims]
            if e.noun.shape == "sphere":
                dims = [x, x, x]
            e.dimensions_cm, e.dimensions_prescribed = dims, True
            return "expected_dimensions_cm"
        return ""
