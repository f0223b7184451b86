"""Choreography: where the participants of a timeline start, how they meet, what follows."""
