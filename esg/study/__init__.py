"""A study of how people see scenes: the page that asks them, and what they said (docs/study.md)."""
