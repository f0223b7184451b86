"""Places on a top that words name without saying which of several is meant: ends, edges, corners."""

from __future__ import annotations

END, OTHER_END, EDGE, CORNER = "end", "other end", "edge", "corner"
PARTS = (END, OTHER_END, EDGE, CORNER)
"""What a statement that something is at a part of a top may say (`Predicate.AT_PART`)."""
