"""What the workflow computes from chains and fronts together."""
