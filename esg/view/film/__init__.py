"""Films of recorded scenes: `cutting` decides which instants, `encoding` writes them, `shooting` both.

Cameras are the director's (`esg.view.director`), pictures the scan-line renderer's (`esg.view.scan`).
"""
