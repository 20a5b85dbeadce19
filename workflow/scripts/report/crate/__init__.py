"""The record of a run as a Workflow Run RO-Crate, for the script write_crate."""
