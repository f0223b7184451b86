"""The plan: theta, the control program it stands for, and the physical scene it runs in."""
