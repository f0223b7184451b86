"""Event losses: how far a rollout is from the timeline, and in what respect."""
