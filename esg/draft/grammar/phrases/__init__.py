"""Phrases: tokens become noun phrases, verb groups and small words."""
