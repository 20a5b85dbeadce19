"""Contact laws and what follows from them: jump conditions, collisions, scalings."""
