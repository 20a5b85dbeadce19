"""What the workflow computes by combining the wings."""
