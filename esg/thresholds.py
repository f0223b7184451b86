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

# -- statements: the second edition of the suite format, where a reason stands it is ours --

MOMENT_S = 0.1
"""A statement about an event is about so long on either side of it."""
OPENING_S = 0.5
"""A statement about motion at the start or the end is about so long: what moves for that long has
moved (`MOVING_FOR_S`)."""
SAMPLE_S = 0.05
"""Statements of place are sampled so often: shorter than a moment, and what touches without a pause
this long touches on (`HIT_GAP_S`)."""
MOST = 0.95
"""What holds in this share of the samples holds throughout."""
CARRIED_M = 0.01
"""What is this close from below carries; what is this close touches."""
FROM_BELOW = 0.25
"""Sunk by `CARRIED_M`, what is carried comes nearer to what carries it by this share of that: a
surface of up to 75 degrees carries, a wall does not."""
ABOVE_TOLERANCE = 0.10
"""A stated distance above something may be off by this share."""
DIRECTION_DEG = 35.0
"""A displacement may be so far off its direction."""
SIDE_SHARE, SIDE_DEG = 0.2, 60.0
"""A contact point counts for a side if it is farther from it than from the nearest one by no more
than this, in halves of the bounding box (engines log one corner of a contact patch, and bumpers are
rounded), and if the surface there looks no farther off it than this."""
ROLLING, ROLLING_SHARE = (0.85, 1.15), 0.7
"""What rolls has this spin over v/r in this share of the samples in which it moves on its
support."""
SLIDING = 0.2
"""What slides has less spin over v/r, in the same share."""
WHEELS_DEG = 20.0
"""Wheels roll while they go within this angle of their heading: the slip at which a tyre has lost
its grip (passenger cars peak at 8 to 12 degrees)."""
SPUN_DEG = 180.0
"""What spins turns about its vertical by more: half a turn is more than any corner asks for."""
TUMBLED_DEG = 90.0
"""What tumbles tilts by more; by half of it, it has toppled (`TOPPLED_DEG`)."""
LEANING_DEG = 5.0
"""What leans has no axis this close to the vertical: settling leaves under 1 degree."""
TOGETHER_M = 0.05
"""What is carried along stays in its place by this much."""
UPRIGHT_DEG = 30.0
STILL_M = 0.02
"""Less is no motion."""
AFLOAT_M = 0.002
"""What floats is so far off the bottom of its liquid at least."""
SUNK_SHARE = 0.1
"""What has sunk is no further over the bottom than this share of the liquid's depth."""
AT_REST_MPS = 0.05
ON_WATER_M = 1.0
"""Who walks or drives toward water goes no farther out on it."""
AT_PART_SHARE, AT_PART_M = 0.15, 0.03
"""From what is at an end, an edge or a corner to that, over the way across the top, and at least: a
fifth or so of a table is called its end."""
OFF_MIDDLE_SHARE = 0.2
"""What is on the left side of a top is so far off its middle, over half of the way across."""
NEAR_END_M = 0.5
"""What ends near something is no farther from it than this, or than its own size."""
SAME_TIME_S = 0.3
BEFORE_S = 0.1
"""Least time by which one event comes before another."""
SIZE_TOLERANCE = 0.15
WORN_COLOR = 0.15
"""What is worn has a stated colour within this in each channel: the table of colours has its red
and its maroon 0.34 apart, its black and its navy 0.26."""
LIT_COLOR = 0.3
"""A light has a stated colour within this in each channel: signal red and pure red are 0.14 apart,
red and amber 0.63."""
LIT_MOMENT_S = 0.1
"""A light that changes is asked so long before and after its moment: two frames of a film."""
SWAYS_SHARE = 0.03
"""The tip of what sways goes at least this share of its size to and fro: less is not seen."""
GESTURE_SHARE = 0.05
"""Hand, head or tail go at least this share of a body's height: 8 cm of somebody."""
GESTURE_S = 0.5
"""A gesture is made for so long at least."""
PUFFS = 3
"""What gives off smoke or dust has so many puffs of it at least."""
FACES_DEG = 35.0
"""Whom somebody faces is no farther off straight ahead of him: as a direction that he takes."""
FALLS_MPS = {"rain": (4.0, 12.0), "storm": (4.0, 12.0), "snow": (0.5, 2.0), "hail": (8.0, 20.0)}
"""How fast what falls from the sky does [m/s], by what it is (`esg/lexicon/weathers.csv`)."""
SIGHT_M = 100.0
"""In fog what is farther than this is mostly gone: a thick one, in which one drives with lights."""
ALONG_M = 1.0
"""What moves along something stays this close to it, or as close as its own size: an arm's reach
and half a lane's margin beside a kerb."""
ACROSS_SHARE = 0.5
"""What moves across something goes over this share of it: it leaves the half on which it came."""
ACROSS_LENGTHS = 2.0
"""What moves across a floor or a field goes this many of its own lengths: nobody waits for half."""
CUT_SHORT_LENGTHS = 0.2
"""The same where something on that way ends it: the words say what it moves on, not how far."""
WIDE_M = 8.0
"""Floors, fields and squares are wider than this both ways: four lanes of a road are not."""
SLOPE_SHARE = 0.25
"""What moves up or down something rises or sinks by this share of its height: shorter ways are a
shake, longer ones leave out what starts half way."""
SLOPE_GRADE = 0.05
"""What moves up or down along a surface that is not named gains this share of its way: what is less
steep is a walking surface, not a ramp (ADA Standards 403.3)."""
CLIMBED_SHARE, CLIMBED_SIZE = 0.5, 0.6
"""Who climbs something gets up so much of its height, or so much of its own size: lower is a
step."""
WOBBLES_DEG, WOBBLES_TIMES = 1.0, 3
"""What wobbles leans by so much [degrees] to so many sides on end."""
POSTURE_S = 0.3
"""Who is said to sit, lie or crouch between two moments does so for so long [s]."""
CLIMBED_TOLERANCE = 0.15
"""A stated height of a climb may be off by this share."""
CLIMBING_M = 0.15
"""Who climbs stays this close to what it climbs, or as close as its own size: hands and feet, which
bodies do not move, reach as far."""
AROUND_DEG, BEND_DEG = 120.0, 40.0
"""What moves around something sees it turn by so much while its course bends by so much: a straight
way past sees up to 180 degrees and bends by none."""
ROUND_DEG = 300.0
"""What runs in circles, or around the yard that it is in, has a course that bends by so much: a
round but for what a course that does not close leaves open."""

# -- further events: the second edition of the suite format --

BOUNCE_MPS = 0.3
"""What bounces leaves faster than this."""
PASS_M, PASS_SIZES = 3.0, 2.0
"""What misses something passes it this close, or within so many times its size."""
PICKED_M, PICKED_SHARE = 0.05, 1.0 / 3.0
"""What is picked up rises by this, or by this share of its height, whichever is less."""
BALLISTIC = 0.5
"""What falls or flies freely loses more than this share of g upwards; what is held does not."""
JUMP_SHARE, JUMP_OWN_S = 0.1, 0.25
"""What jumps rises by this share of its height, and is set in motion no longer before."""
OPEN_SHARE = 1.0 / 3.0
"""What slides open goes over this share of its way."""
SHUT_SHARE = 1.0 / 6.0
"""What is closed stands open by at most this share of what counts as open."""
PIECES, PIECE_GAP_M = 3, 0.02
"""What is broken is in so many pieces so far apart."""

# -- how a scene is filmed (`filmed` statements); terms of Brown, Cinematography, 4th ed., 2022 --

FILMED_ASPECT = 16.0 / 9.0
"""Width over height of the picture in which shares are measured: that of films."""
FILMED_ABOVE_DEG, FILMED_AERIAL_DEG, FILMED_HIGH_DEG, FILMED_LOW_DEG = 75.0, 55.0, 25.0, 5.0
"""How far down an overhead, an aerial and a high-angle shot look at least, a low-angle one at most;
a person's eyes look down at things on the ground by some 10 to 20 degrees."""
FILMED_LEVEL_DEG = 20.0
"""At eye level the camera looks up or down by at most this."""
FILMED_SIDE_DEG = 40.0
"""Half of a quarter turn, less 5: a three-quarter view is neither from the front nor the side."""
FILMED_OWN_DEG = 20.0
"""Who sees through somebody's eyes looks where he heads."""
FILMED_CLOSE, FILMED_EXTREME, FILMED_WIDE = 0.6, 0.85, 0.36
"""Share of the picture's width or height, whichever is more, in a close-up and an extreme one at
least; geometric mean of both shares in a wide shot at most."""
FILMED_MEDIUM = (0.4, 0.85)
"""Share of the picture's width or height, whichever is more, in a medium shot."""
FILMED_INSIDE_SHARE, FILMED_CLEAR_SHARE = 0.9, 0.5
"""What is filmed is in the picture for so much of the time, and for so much of it not hidden."""
FILMED_AWAY_RATIO, FILMED_ALONG = 1.75, 0.5
"""What follows keeps its distance within this ratio, also where it comes nearer, and goes over
this share of the way itself."""
FILMED_GROWTH = 1.25
"""What is zoomed at grows by this factor."""
FILMED_ACROSS = 0.2
"""A camera that moves goes over this part of its distance."""
FILMED_TURN_DEG, FILMED_ORBIT_DEG = 12.0, 45.0
"""A camera that pans or tilts turns by so much, one that orbits goes so far around."""
FILMED_STILL_M, FILMED_STILL_DEG = 1e-3, 0.1
"""A camera that stands still stays within this."""
FILMED_SHAKE_DEG = (0.05, 2.0)
"""A hand shakes by so much about its calm way (root of the mean square)."""
FILMED_SLOW, FILMED_FAST = 0.5, 2.0
"""Seconds of the scene in a second of film, of slow motion at most, of a time lapse at least."""

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
HARD_BRAKING_MPS2, GENTLE_BRAKING_MPS2 = 3.4, 1.7
"""What "brakes hard" means at least, "brakes gently" at most: most drivers are at ease up to
3.4 m/s^2, and brake harder when surprised (AASHTO Green Book, stopping sight distance); half."""
BRAKING_DRY_G, BRAKING_WET_G, BRAKING_ICY_G = 0.8, 0.3, 0.1
"""The hardest braking on dry, wet and icy ground, over g: what good tyres pass on to asphalt (0.7
to 0.9), to wet cobbles or packed snow (0.2 to 0.4) and to ice (0.1)."""
