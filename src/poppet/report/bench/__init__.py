"""Reports of valve benches and of dynamic limits."""
