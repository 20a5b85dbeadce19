"""What leaves the project: datasets, tables, figures, and the record of their origin."""
