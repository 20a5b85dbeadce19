"""What a user asks for: parts, YAML files, sentences, sizes; nothing here computes."""
