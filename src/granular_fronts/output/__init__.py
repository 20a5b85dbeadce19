"""What leaves the project: datasets, tables, figures, and their provenance."""
