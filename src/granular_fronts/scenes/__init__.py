"""What a user asks for: schema, YAML files, constraints, sizes; nothing here computes."""
