"""Methods kept for comparison: textbook variables, the θ-method, upwind, Fourier."""
