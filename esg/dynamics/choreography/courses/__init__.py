"""Ways that lead somewhere: down a chute, through a gate, up a ramp, from one side to another."""
