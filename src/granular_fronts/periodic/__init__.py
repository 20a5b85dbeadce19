"""A ring of beads beside its amplitude equations (James 2021, section 4.3)."""
