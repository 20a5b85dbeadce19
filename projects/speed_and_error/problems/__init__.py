"""Problems for speed against error, each with its answer and the methods that solve it."""
