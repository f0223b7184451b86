"""The lexicon: a table of the kinds of objects, and a morphology of nouns (docs/lexicon.md).

The drafter reads from it what a noun means, the library how a kind is drawn; size and mass stand
in it once. The judge does not read it: what a suite names is bound by rules of its own.
"""

from esg.lexicon.kinds import Kind, kinds
from esg.lexicon.morphology import plural, singular

__all__ = ["Kind", "kinds", "plural", "singular"]
