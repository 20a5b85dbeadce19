"""Other people's solvers on our problems, for the study of speed against error."""
