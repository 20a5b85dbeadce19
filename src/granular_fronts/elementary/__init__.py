"""Elementary functions of numbers and arrays, for the compiled kernels of every wing."""
