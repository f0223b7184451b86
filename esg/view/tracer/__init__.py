"""A ray tracer in Warp: meshes, a ground plane, sun, sky and textures, on the CPU or a GPU."""
