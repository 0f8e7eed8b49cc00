"""The friction of a body, and of a cylinder's seals, from velocity-force tables and recordings of motion."""
