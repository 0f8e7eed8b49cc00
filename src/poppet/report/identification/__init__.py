"""Reports of identifications and of experiment designs."""
