"""What leaves the project: datasets, tables and figures."""
