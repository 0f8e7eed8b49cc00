"""Identification of flow characteristics from tank tests according to ISO 6358-2."""
