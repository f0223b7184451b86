"""The paper's strategies `ad`, `fd` and `hybrid`: gradients of the event losses."""
