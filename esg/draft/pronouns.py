"""What pronouns, ordinals and "one" mean."""

from __future__ import annotations

from esg.draft import lexicon as lex
from esg.draft.elements import Mention
from esg.draft.entities import FRONT, ORDINALS, REAR, STACKED, Entity, slug
from esg.draft.meetings import before_this, meeting, the_others
from esg.draft.persons import named_by_no_person, of_other_gender
from esg.draft.ranks import RANKS, extreme, rank, same_quantity
from esg.draft.registry import Registry

_NEAR = 80
"""Characters within which "former" and "latter" mean the same two things."""
_WAYS = frozenset({"stairs", "ramp"})
"""What things move along."""


class Pronouns(Registry):
    """Referents of phrases without a noun of their own."""

    _two: tuple[int, list[str]] = (-1, [])
    """Where "the former" or "the latter" was told last, and of which two things."""

    def _of_stack(self, m: Mention, names: list[Entity]) -> list[str]:
        raise NotImplementedError

    def _pronoun(self, m: Mention, subject: bool, avoid: list[str]) -> list[str]:
        p = m.pronoun
        if p in ("he", "she", "him", "her", "himself", "herself", "someone", "everyone"):
            other = p in ("him", "her") and not subject  # never the subject of its own clause
            people = [
                ids
                for ids in reversed(self.salience)
                if len(ids) == 1 and self.entities[ids[0]].noun.kind == "person"
                and not (other and ids[:1] == avoid[:1])
            ]  # fmt: skip
            like = (x for x in people if not of_other_gender(p, self.entities[x[0]].head))
            if who := next(like, next(iter(people), None)):
                return who
            if p not in ("someone", "everyone") and not m.determiner:
                being = named_by_no_person(p, self.entities, self.salience, subject, avoid)
                if being:
                    return being
            if p in ("he", "she", "someone") and subject:
                person = lex.nouns()["person"]
                return [self.add(person, "person", label=p, origin=m.start).id]
            return []
        if p in ("i", "we", "you", "something", "everything"):
            return []
        if p == "another" and not self.groups:
            last = self.salience[-1] if self.salience and m.after_prep == "to" else []
            one = len(last) == 1 and self.entities[last[0]].label.lower().startswith("one ")
            others = (
                last if one else avoid or (self.subjects[-1] if subject and self.subjects else [])
            )
            solid = (self.entities[i] for i in others)
            model = next((e for e in solid if "structural" not in e.noun.traits), None)
            if model is not None:
                other = self.add(
                    model.noun,
                    model.head,
                    adjectives=["second"],
                    label=f"second {model.head}",
                    known=model.known,
                    origin=m.start,
                )
                return [other.id]
        if p == "ones" and m.count and m.count > 1 and "other" in m.adjectives and avoid:
            known = self.groups.get(self.entities[avoid[0]].group or "", [])
            if not known and "structural" not in self.entities[avoid[0]].noun.traits:
                like = self.entities[avoid[0]]
                return self._create(
                    Mention(
                        m.start, m.end, head=like.head, noun=like.noun, count=m.count, plural=True
                    )
                )
        if p == "ones" and m.count is None and m.adjectives == ["other"]:
            rest = the_others(self.salience, self.groups, self.entities)
            if rest:
                return rest
        if p in (
            "they",
            "them",
            "themselves",
            "these",
            "those",
            "both",
            "ones",
            "all",
            "each",
            "some",
            "many",
            "several",
        ):
            pool = self.subjects if subject and p not in ("both",) else self.salience
            two = self._last_two_alike() if p == "both" and subject else []
            if two:
                return two
            keep = m.count if m.count in (1, 2, 3) and p in ("them", "these", "those") else None
            for ids in reversed(pool):
                if len(ids) > 1 and (subject or not set(ids) <= set(avoid)):
                    return list(ids)[:keep]
            for ids in reversed(self.salience):
                if len(ids) > 1:
                    return list(ids)[:keep]
            for ids in reversed(self.salience) if p not in ("both", "each") else ():
                group = self.groups.get(self.entities[ids[0]].group or "", [])
                if len(ids) == 1 and len(group) > 1:
                    return list(group)  # "the first domino ... they all topple"
            recent: list[str] = []
            for ids in reversed(self.salience):
                for i in ids:
                    if subject and p == "they" and self.entities[i].noun.kind in _WAYS:
                        continue  # "rolls down the ramp, and they collide"
                    if i not in recent and "structural" not in self.entities[i].noun.traits:
                        recent.append(i)
                if len(recent) >= 2 and (p != "both" or len(recent) > 3):
                    break
            alike = [i for i in recent if self.entities[i].noun == self.entities[recent[0]].noun]
            recent = alike if p == "both" and len(alike) > 1 else recent
            if len(recent) >= 2:
                met = meeting(self.subjects, recent, self.entities) if subject else []
                return met or recent[:2][::-1]
            return recent
        if p in ("latter", "former"):
            two = list(dict.fromkeys(i for i in self.movers if i in self.entities))
            if 0 <= m.start - self._two[0] < _NEAR:
                two = self._two[1]  # "the former hits the latter"
            if len(two) < 2:
                last = [i for ids in self.salience[-6:] for i in ids if i in self.entities]
                solid = [i for i in last if "structural" not in self.entities[i].noun.traits]
                two = list(dict.fromkeys(reversed(solid)))[:2][::-1]
            self._two = (m.start, two)
            return two[-1:] if p == "latter" else two[:1]
        if p == "one" and m.determiner in ("this", "that") and not m.adjectives:
            for ids in reversed(self.salience):  # "hits the red ball and this one rolls away"
                if len(ids) == 1 and "structural" not in self.entities[ids[0]].noun.traits:
                    return list(ids)
        if p in ("one", "another", "other"):
            named = next((a for a in m.adjectives if a in ORDINALS), None)
            like = before_this(named, avoid, self.entities)
            if like:
                return like
            told = [e.id for e in self.entities.values() if named and e.place == named]
            if named and told:
                return told[-1:]  # "a third car hits the second"
            if named and m.determiner == "the" and not self.groups and m.adjectives == [named]:
                solid = [e.id for e in self.entities.values() if self._counts(e)]
                pair = next((ids for ids in reversed(self.salience) if len(ids) == 2), solid)
                solid = list(pair) if len(solid) != 2 else solid
                placed = any(e.place in ORDINALS for e in self.entities.values())
                if len(solid) == 2 and ORDINALS[named] < 2 and not placed:
                    return [solid[ORDINALS[named]]]  # "a car and a fence. The first one hits"
            return self._one_of(m, avoid)
        # it, itself, this, that
        pools = [self.subjects, self.salience] if subject else [self.salience]
        for pool in pools:
            for ids in reversed(pool):
                fits = [
                    i
                    for i in ids
                    if i not in avoid
                    and "structural" not in self.entities[i].noun.traits
                    and self.entities[i].noun.kind != "person"
                    and self.entities[i].noun.name != "arm"
                    and (self.entities[i].noun.kind not in _WAYS or not self._anything_else(avoid))
                ]
                if len(ids) == 1 and fits:
                    return fits
                whole = self.entities[ids[0]].group in self.collective
                if fits and len(ids) > 1 and whole and not (subject and pool is self.salience):
                    return list(ids)
        for ids in reversed(self.salience):
            if ids and not set(ids) <= set(avoid):
                grown = p == "it" and all(self._grown_up(i) for i in ids)
                return [] if grown else list(ids)
        return []

    def _grown_up(self, i: str) -> bool:
        """Whether "it" is no word for a person ("the child ... it" is one)."""
        e = self.entities[i]
        return e.noun.kind == "person" and e.head in ("person", "he", "she", "man", "woman")

    @staticmethod
    def _counts(e: Entity) -> bool:
        """Whether it is a thing of its own, no ground, road or place."""
        traits = e.noun.traits
        return not ({"ground", "decal"} & traits) and ("structural" not in traits or e.mentioned)

    def _last_two_alike(self) -> list[str]:
        """The subjects of the clauses before, if they are of one kind ("and both brake")."""
        last = [ids[0] for ids in self.subjects[-4:] if len(ids) == 1 and ids[0] in self.entities]
        two = list(dict.fromkeys(reversed(last)))[:2][::-1]
        if len(two) < 2 or len(self.subjects[-1]) > 1:
            return []
        one, other = (self.entities[i] for i in two)
        return two if one.noun == other.noun and (one.group is None or other.group is None) else []

    def _anything_else(self, avoid: list[str]) -> bool:
        """Whether the prompt named something that moves, which "it" rather means."""
        return any(
            e.movable and e.noun.kind not in ("person", *_WAYS)
            for ids in self.salience[-4:]
            for i in ids
            if i not in avoid and (e := self.entities.get(i)) is not None
        )

    def _another_like(self, m: Mention, avoid: list[str]) -> list[str]:
        """ "The first runner falls, the second ...", "a blue car ... the red one", "the yellow"."""
        colors = [a for a in m.adjectives if a in lex.COLORS]
        ordinal = next((a for a in m.adjectives if a in ORDINALS), None)
        solid = [
            e for e in reversed(list(self.entities.values())) if "structural" not in e.noun.traits
        ]
        model = None
        if colors and not any(e.group and e.color is None for e in solid):
            balls = [e for e in solid if e.noun.kind == "billiard"]
            tinted = [e for e in solid if e.color is not None]
            model = next(iter(balls or tinted), None)
            if self.billiards or (model is not None and model.noun.kind == "billiard"):
                label = f"{colors[0]} ball"
                ball = lex.nouns()["billiard ball"]
                return [self.add(ball, "ball", adjectives=colors, label=label, origin=m.start).id]
            if model is None and m.adjectives == colors:  # "Red knocks blue away"
                ball = lex.nouns()["ball"]
                label = f"{colors[0]} ball"
                return [self.add(ball, "ball", adjectives=colors, label=label, origin=m.start).id]
        elif ordinal is not None and self._beyond_last(ordinal):
            model = self.entities[next(reversed(list(self.groups.values())))[0]]
        elif ordinal is not None and not any(e.group for e in solid):
            model = next((e for e in solid if e.place in ORDINALS and e.place != ordinal), None)
        if model is None or (model.id in avoid and not ordinal and model.color is None):
            return []
        named = [ordinal] if ordinal else colors
        label = " ".join([*[x for x in named if x], model.head])
        e = self.add(
            model.noun,
            model.head,
            adjectives=[x for x in named if x],
            label=label,
            known=model.known,
            origin=m.start,
        )
        return [e.id]

    def _ranked(self, m: Mention, things: list[Entity], avoid: list[str]) -> list[str]:
        """ "the heavier one", "the tallest bottle": by what is known of sizes, masses, speeds."""
        word = rank(m)
        best = extreme(word, things, self.facts) if word else None
        if best is None and word and len(things) == 2 and things[0].group:
            end = RANKS[word]  # "the smaller one turns, but the larger one scrapes it"
            other = self.ends.get((end[0], -end[1]), "")
            taken = {*avoid, self.current(other) if other else ""}
            free = [e for e in things if e.id not in taken] or things
            best = self.entities.get(self.current(self.ends.setdefault(end, free[0].id)))
        return [best.id] if best is not None else []

    def _comparable(self, avoid: list[str]) -> list[Entity]:
        """What "the heavier one" may be: the plural told last, else two things of one kind, else
        whatever can move.
        """
        group = next(reversed(list(self.groups.values())), [])
        told = dict.fromkeys(i for ids in self.salience for i in ids if i not in avoid)
        recent = [self.entities[i] for i in told if i in self.entities]
        alike = [e for e in recent if sum(e.noun == x.noun for x in recent) > 1]
        movable = [e for e in recent if e.movable]
        return [self.entities[i] for i in group] or alike or movable

    def _beyond_last(self, ordinal: str) -> bool:
        """ "passes three gates and hits the fourth": one more than the plural has."""
        group = next(reversed(list(self.groups.values())), [])
        return ordinal in ORDINALS and len(group) > 1 and ORDINALS[ordinal] == len(group)

    def _one_of(self, m: Mention, avoid: list[str]) -> list[str]:
        comparable = self._comparable(avoid)
        if found := self._ranked(m, comparable, avoid):
            return found
        if heavy := [e.id for e in comparable if same_quantity(m, e, self.facts)]:
            return heavy[:1]  # "the 5 kg one"
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
        side = next((a for a in m.adjectives if a in ("left", "right")), "")
        group = next(reversed(list(self.groups.values())), [])
        mates = [i for i in group if i not in avoid and not self.entities[i].place]
        if side and mates and len(group) <= 3:
            chosen = self.entities[mates[0]]  # "the left one ... the right one"
            chosen.place, chosen.label = side, f"{side} {chosen.head}"
            self._rename(chosen, self._new_id(slug(chosen.label)))
            return [chosen.id]
        end = next((a for a in m.adjectives if a in FRONT | REAR), "")
        if end and 2 <= len(group) <= 3:
            where = "front" if end in FRONT else "rear"
            chosen = self.entities[group[0] if end in FRONT else group[-1]]
            if chosen.place in ("", where):
                chosen.place, chosen.label = where, f"{where} {chosen.head}"
                self._rename(chosen, self._new_id(slug(chosen.label)))
                return [chosen.id]  # "the rear one ... the front one"
        if end and not group:
            fore = FRONT if end in REAR else REAR
            like = [e for e in self.entities.values() if fore & {e.place, *e.adjectives}]
            if like and not any(e.place == end for e in self.entities.values()):
                return [
                    self.add(
                        like[-1].noun, like[-1].head, adjectives=[end],
                        label=f"{end} {like[-1].head}", known=like[-1].known, origin=m.start,
                    ).id
                ]  # fmt: skip
        if "next" in m.adjectives and not self.groups:
            solid = [e for e in self.entities.values() if "structural" not in e.noun.traits]
            before = avoid or (self.subjects[-1] if self.subjects else [])
            last = next((ids for ids in reversed(self.salience) if not set(ids) <= {*before}), [])
            alone = len(last) == 1 and last[0] in self.entities and bool(before)
            passed = alone and self.entities[last[0]].label.lower().startswith("one ")
            kinds = ("person", "animal", "vehicle", "flyer", "watercraft", "robot", "toyvehicle")
            if passed or (alone and self.entities[before[0]].noun.kind in kinds):
                before = last  # "past one table, brushes against the next"
            model = [e for e in solid if e.id in before[:1]]
            if solid:  # "A domino falls and hits the next one", "One ball ..., the next one ..."
                like = (model or solid)[-1]
                label = f"next {like.head}"
                other = self.add(
                    like.noun, like.head, adjectives=["next"], label=label,
                    known=like.known, origin=m.start,
                )  # fmt: skip
                return [other.id]
        fresh = self._another_like(m, avoid)
        if fresh:
            return fresh
        last_group = next(reversed(list(self.groups.values())), None)
        own = next((self.entities[i].group for i in avoid if self.entities[i].group), None)
        if own in self.groups and "next" in m.adjectives:
            mates = self.groups[own]  # "the first domino hits the next": of its own row
            k = max((mates.index(i) for i in avoid if i in mates), default=0)
            return mates[k + 1 : k + 2] or mates[-1:]
        colors = [a for a in m.adjectives if a in lex.COLORS]
        if colors and last_group:
            plain = [
                self.entities[i]
                for i in last_group
                if self.entities[i].color is None and i not in avoid
            ]
            if plain:
                chosen = plain[0]
                chosen.adjectives.append(colors[0])
                chosen.label = f"{colors[0]} {chosen.head}"
                chosen.place = chosen.place or colors[0]
                self._rename(chosen, self._new_id(slug(chosen.label)))
                return [chosen.id]
        ordinal = next((a for a in m.adjectives if a in ORDINALS or a == "last"), None)
        if last_group and avoid and any(a.endswith("er") for a in m.adjectives):
            mates = [i for i in last_group if i not in avoid]
            if mates and "other" not in m.adjectives:
                return mates[:1]  # "the heavier crate ... the lighter one"
        if set(STACKED) & set(m.adjectives):
            stacks = [g for g in self.groups.values() if self.entities[g[0]].pattern == "stack"]
            level = self._of_stack(m, [self.entities[i] for i in stacks[-1]]) if stacks else []
            if level:
                return level
        if last_group and "next" in m.adjectives:
            return last_group[1:2]
        if last_group:
            if (
                m.pronoun == "one"
                and m.determiner == "the"
                and "other" in m.adjectives
                and not avoid
            ):
                return [last_group[-1]]
            if ordinal is not None:
                model = self.entities[last_group[0]]
                return self._ordinal(
                    Mention(m.start, m.end, head=model.head, noun=model.noun), ordinal
                )
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

    def _ordinal(self, m: Mention, ordinal: str) -> list[str]:
        names = [e for e in self.entities.values() if self._same_kind(m, e)]
        exact = [e for e in names if e.place == ordinal]
        if exact:
            return [exact[0].id]
        grouped = [e for e in names if e.group]
        pool = grouped or names
        k = len(pool) - 1 if ordinal in ("last", "final") else ORDINALS[ordinal]
        if ordinal not in ORDINALS and not grouped and all(e.place for e in pool[-1:]):
            return []  # "the front car brakes ... the last car hits it"
        if ordinal in ORDINALS and not grouped:
            # "a ball ... the second ball": the first is the one already there
            taken = [e for e in pool if e.place in ("", "first")]
            if ordinal == "first" and taken:
                return [taken[0].id]
            alike = [e for e in pool if e.head == m.head and e.place in ("", "first")]
            k = ORDINALS[ordinal]
            return [alike[k].id] if 0 < k < len(alike) else []
        if 0 <= k < len(pool):
            e = pool[k]
            if not e.letter and len(grouped) <= 6:
                e.place = ordinal
                e.label = f"{ordinal} {m.head}"
                e.adjectives.append(ordinal)
                self._rename(e, self._new_id(slug(f"{ordinal} {m.head}")))
            return [e.id]
        return []
