"""Any numbers of any circuit from any recordings."""
