"""Renderers behind one interface: the same scenery, poses and cameras in, pictures out.

`kinds` lists them; `records` says what goes in and comes out.
"""
