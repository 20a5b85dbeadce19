"""What the workflow computes by combining chains, fronts and equations."""
