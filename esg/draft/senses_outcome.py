"""Verbs of where a mover ends or what it gets by: enter, pot, score, miss, avoid."""

from __future__ import annotations

from esg.draft import lexicon as lex
from esg.draft.frames import Frame
from esg.draft.senses_topple import ToppleSenses
from esg.graph.models import NodeEvent


class OutcomeSenses(ToppleSenses):
    """Targets that are entered or missed."""

    def _do_enter(self, f: Frame, s: list[str], o: list[str]) -> None:
        onto = f.phrase("onto", "on", "against")
        met = onto.mention.entities if onto is not None and onto.mention is not None else []
        if s and not o and f.phrase("into", "in") is None and any(map(self._aimable, met)):
            self._read_as("land", f, s, [])  # "splashes onto a parked car"
            return
        wet = f.phrase("into", "in")
        named = [*o, *(wet.mention.entities if wet is not None and wet.mention else [])]
        if f.verb.lemma == "splash" and not any(map(self._enterable, named)):
            self.scene.ignored[(f.verb.start, f.verb.end)] = "water is not simulated"
            return
        into = f.phrase("into", "in")
        if not o and into is not None and into.mention is not None:
            o = [i for i in into.mention.entities if self._enterable(i) or self._holds(i)]
        for actor in s:
            target = next((t for t in o if not self.structural(t)), None)
            if target is not None and actor in self.world.entities and self.movable(actor):
                self._ensure_mover(f, actor, target)
                self.enter(f, actor, target, f.object, self._time(f))
            else:
                self.use(f, "continues on its way")

    def _do_pocket(self, f: Frame, s: list[str], o: list[str]) -> None:
        if f.verb.passive:
            by = f.phrase("by")
            o, s = s, list(by.mention.entities) if by and by.mention else []
        bodies = o
        if f.verb.lemma == "sink" and any(self.kind(x) == "watercraft" for x in o or s):
            self.scene.ignored[(f.verb.start, f.verb.end)] = "sinking is not simulated"
            return
        if f.verb.lemma == "sink" and not o:
            p = f.phrase("in", "into")
            bodies = s
            s = []
            if p is None:
                self.scene.ignored[(f.verb.start, f.verb.end)] = "sinking is not simulated"
                return
        strikers = [x for x in s if self.kind(x) in ("billiard", "ball")]
        if strikers and bodies and not self._already_hit(f, strikers, bodies):
            self._hit(f, strikers[:1], bodies, self._time(f))
        for b in bodies[:1]:
            self._ensure_mover(f, b, None)
            p = f.phrase("in", "into", "to")
            goal = [i for i in (p.mention.entities if p and p.mention else [])]
            if goal:
                self.enter(f, b, goal[0], p.mention if p else None, self._time(f))
            else:
                self.scene.needs.append(("billiard_table", b))
                self.event(
                    NodeEvent.ENTER_REGION,
                    (b,),
                    f,
                    self._time(f),
                    region="billiard_table_1/bottom left pocket",
                )

    def _do_score(self, f: Frame, s: list[str], o: list[str]) -> None:
        balls = [i for i, e in self.world.entities.items() if e.noun.kind in ("ball", "sliding")]
        ball = next((i for i in [*o, *s] if i in balls), balls[-1] if balls else None)
        if ball is None:
            ball = self.world.add(lex.nouns()["soccer ball"], "soccer ball", mentioned=False).id
        goal = next((i for i, e in self.world.entities.items() if "goal" in e.noun.traits), None)
        if goal is None:
            name = "basketball hoop" if self.e(ball).noun.name == "basketball" else "goal"
            goal = self.world.add(lex.nouns()[name], name, mentioned=False).id
        if any(n.event is NodeEvent.ENTER_REGION and ball in n.participants for n in self.tl.nodes):
            self.use(f, "goal")
            return
        self._ensure_mover(f, ball, goal)
        self.enter(f, ball, goal, None, self._time(f))

    def _do_miss(self, f: Frame, s: list[str], o: list[str]) -> None:
        by = f.phrase("by")
        if f.verb.passive and by is not None and by.mention is not None and by.mention.entities:
            s, o = list(by.mention.entities), s  # "is nearly hit by a motorbike"
        targets = self._hit_targets(f, s, o)
        if f.verb.lemma in ("catch", "grab") and f.verb.negated:
            for thing in o:
                if self.pending.get(thing, (None,))[0] is NodeEvent.REACH:
                    del self.pending[thing]
            self.scene.ignored[(f.verb.start, f.verb.end)] = "negated"
            return
        if not targets and len(s) > 1:
            s, targets = s[:1], s[1:2]  # "they nearly collide"
        for actor in s:
            if not targets and actor in self.aim:
                targets = [self.aim[actor]]
            if not targets:
                targets = self._target_of_mates(actor)
            self._ensure_mover(f, actor, targets[0] if targets else None)
            for other in targets[:1]:
                if other != actor:
                    self.event(NodeEvent.MISS, (actor, other), f, self._time(f))

    def _target_of_mates(self, actor: str) -> list[str]:
        """ "A ball hits a window, a second ball misses": what the others aimed at or hit."""
        aimed = self._aim_of_mates(actor)
        if aimed is not None and aimed != actor:
            return [aimed]
        kind = self.e(actor).noun.name
        for node in reversed(self.tl.nodes):
            like = [p for p in node.participants if self.e(p).noun.name == kind and p != actor]
            others = [p for p in node.participants if p not in like and p != actor]
            if node.event in (NodeEvent.COLLISION, NodeEvent.MISS) and like and others:
                return others[:1]
        return []

    def _do_clear(self, f: Frame, s: list[str], o: list[str]) -> None:
        """ "clears the fence": goes over it without touching it."""
        moving = [a for a in s if self.movable(a) and self.kind(a) != "person"] or s
        if moving and o and self.tl.tracks.get(moving[0]) is not None:
            self._do_avoid(f, moving, o)
        else:
            self.scene.ignored[(f.verb.start, f.verb.end)] = "clearing away is not simulated"

    def _do_avoid(self, f: Frame, s: list[str], o: list[str]) -> None:
        event = f.object is not None and f.object.head in ("collision", "crash", "accident")
        if event and not o and len(s) == 1:  # "brakes hard and avoids a collision"
            named = [ids[0] for ids in reversed(self.world.salience) if len(ids) == 1]
            fit = [i for i in named if i in self.world.entities and i not in s]
            o = [i for i in fit if self._aimable(i)][:1]
        for actor in s:
            for other in [x for x in o if x != actor][:1]:
                self._ensure_mover(f, actor, None)
                self.event(NodeEvent.MISS, (actor, other), f, self._time(f))
