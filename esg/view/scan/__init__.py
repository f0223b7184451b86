"""A scan-line renderer for films and for asking what a camera sees: depth buffer, one sun, shadows.

An order of magnitude faster than tracing rays on a processor, and without their exactness: soft
shadows are filtered maps, glass is a dither. `kernels` holds the loops, `drawer` the scene.
"""
