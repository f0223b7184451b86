"""Rollouts: Newton (reference), PhysX (verify) and Rapier (audit) behind one interface."""
