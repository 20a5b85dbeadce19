"""The page on which motions and fronts are explored: its data, its panels, and the page itself."""
