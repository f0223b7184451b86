"""Scene Language (Zhang et al., CVPR 2025): its programs as scenes that our engine plays."""
