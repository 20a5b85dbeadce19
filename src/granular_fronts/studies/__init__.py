"""Studies: what the workflow computes by combining chains, fronts and equations."""
