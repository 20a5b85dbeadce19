"""Contact laws at work: materials, regimes, numerical damping; James (2021), section 3.1."""
