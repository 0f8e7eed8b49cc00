"""Pages on identifications."""
