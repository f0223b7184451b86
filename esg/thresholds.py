"""Did it happen? The thresholds of every event type, for the judge and for the planner alike.

The judge (`esg.metrics`) counts an event by the values of the first part. Those marked ECR are the
paper's (Supp. Mat., Event Completion Rate), which knows hits only; the others are those of the
suite format (docs/metrics.md). The planner (`esg.dynamics`) asks for a little more, the second
part: what only just counts in one engine does not count in another.
"""

from __future__ import annotations

T_MAX_S = 15.0
"""What happens later does not count (ECR, condition 1)."""
MIN_EVENT_GAP_S = 0.1
"""A hit that follows another event comes at least this much later (ECR, chain events)."""

# -- hits --

MAX_CONTACT_DEPTH_M = 0.05
"""A hit that is as deep at its first touch is none (ECR, condition 2)."""
MIN_IMPULSE_NS = 0.1
"""A touch whose impulse is no more than this is no hit (ECR, condition 3)."""
RECHECK_AFTER_S = 0.2
MAX_RECHECK_DEPTH_M = 0.02
"""So long after a hit the two are no deeper in each other than that (ECR, condition 4)."""
HIT_GAP_S = 0.05
"""Contact of a pair that pauses for longer than this starts a new hit."""
BLOW_FACTOR = 5.0
BLOW_WINDOW_S = 0.1
"""A blow on a pair at rest against each other starts a new hit too: an impulse this many times
larger than any in the time before."""
BLOW_IMPULSE_NS = 0.1
"""Least impulse of such a blow."""
IMPULSE_WINDOW_S = 0.05
IMPULSE_FRAMES = 3
"""The impulse of a hit is accumulated over this time or this many frames, whichever is longer."""

# -- motion --

MOVING_MPS = 0.2
MOVING_FOR_S = 0.5
"""What is faster than this for so long has moved; who is slower overtakes nobody."""
STOPPED_MPS = 0.1
STOPPED_FOR_S = 0.2
"""What has moved and is slower than this for so long has stopped."""
TURN_TOLERANCE_DEG = 20.0
"""A turn may miss its angle by this much."""
BRAKED_TO = 0.5
"""Braking leaves at most this share of the speed."""

# -- place and attitude --

ENTERED_FOR_S = 0.2
"""What stays inside for so long has entered."""
TOPPLED_DEG = 45.0
"""What tilts by more has toppled."""
FALLEN_BY = 0.5
"""What comes down by more than this share of its height has fallen."""
REACH_M = 0.3
"""What comes this close has reached something."""
HANGS_M = 0.02
"""What could sink so far at the start without meeting anything hangs in the air."""
MEETS_M = 0.001
"""Overlap from which on it would meet something."""

# -- what the planner asks for --

SAFE_IMPULSE_NS = 0.25
"""Impulse of a hit that surely counts: of `MIN_IMPULSE_NS` another engine may see less."""
SAFE_DEPTH_M = 0.035
"""Depth of a hit that surely counts, against `MAX_CONTACT_DEPTH_M`."""
NEAR_M = 0.25
"""What comes this close surely has reached something (`REACH_M`)."""
SAFE_TOPPLED_DEG = 47.0
"""A tilt that surely counts (`TOPPLED_DEG`)."""
SAFE_FALLEN_BY = 0.525
"""A way down that surely counts, over the height (`FALLEN_BY`)."""
SAFE_BRAKED_TO = 0.45
"""Share of its speed that a braked body may keep (`BRAKED_TO`)."""
SAFE_TURN_DEG = 15.0
"""By how much a turn may miss its angle (`TURN_TOLERANCE_DEG`)."""
