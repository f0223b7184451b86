"""Films of recorded scenes: `cutting` decides which instants, `shooting` draws, `encoding` writes.

Cameras are the director's (`esg.view.director`), pictures the scan-line renderer's
(`esg.view.scan`).
"""
