"""Warp kernels of the search; `esg.layout.search` is their only caller.

`planar` is the problem on the device, `energy` and `collide` its terms, `proposals` the candidates,
`descent` the steps; `cpu` runs one start a thread, `gpu` shares a start between many, `evaluation`
sums a state. Nothing is exported: importing a module compiles it.
"""
