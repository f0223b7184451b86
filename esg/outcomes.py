"""How a scene ended: an enum whose members carry what to try next, never a bare failure."""

from __future__ import annotations

import enum


class Outcome(str, enum.Enum):
    """Result of generating one scene (docs/cli.md)."""

    SOLVED = "solved"
    PARTIAL = "partial"
    NEAREST_FEASIBLE = "nearest_feasible"
    INFEASIBLE = "infeasible"
    NOT_CONVERGED = "not_converged"
    INVALID_DRAFT = "invalid_draft"
    CRASHED = "crashed"

    @property
    def advice(self) -> str:
        """One sentence on what the user can do about it."""
        return _ADVICE[self]

    @property
    def has_scene(self) -> bool:
        """Whether a compiled scene exists for this outcome."""
        return self.is_good or self is Outcome.NOT_CONVERGED

    @property
    def is_good(self) -> bool:
        """Whether that scene does what it claims."""
        return self in (Outcome.SOLVED, Outcome.PARTIAL, Outcome.NEAREST_FEASIBLE)


_ADVICE = {
    Outcome.SOLVED: "Every event, constraint and statement holds; nothing to do.",
    Outcome.PARTIAL: (
        "Every event happens, but not all that the prompt says is shown: `not_kept` has the words; "
        "say it otherwise or do without it (--strict counts this as a failure)."
    ),
    Outcome.NEAREST_FEASIBLE: (
        "Physics rules out one constraint; see `dynamics_result.relaxed` for which gave way and by "
        "how much, and relax it in the prompt."
    ),
    Outcome.INFEASIBLE: "No scene can satisfy the prompt; see `reason` and change what it names.",
    Outcome.NOT_CONVERGED: (
        "Some event was not reached; see `reason`, and try another --seed or other words."
    ),
    Outcome.INVALID_DRAFT: "The draft breaks the schema or the rules; see the violations.",
    Outcome.CRASHED: "A defect of this software; please report it with `log.jsonl`.",
}


class UserError(Exception):
    """A mistake the user can repair: shown as one message, exit code 2, never a traceback.

    Args:
        message: What was wrong, where, with which value, and what to do about it.
        exit_code: 2 for usage and input errors, 1 for an environment that fails.
    """

    def __init__(self, message: str, exit_code: int = 2) -> None:
        super().__init__(message)
        self.exit_code = exit_code
