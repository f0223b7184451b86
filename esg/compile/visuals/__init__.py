"""What exports show: surfaces, meshes, ropes, cameras and light, one record for every format."""
