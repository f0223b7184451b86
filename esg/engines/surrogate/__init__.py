"""The fused surrogate: whole rollouts of many worlds in one launch, differentiable."""
