"""Controllers as function blocks of structured text, and a small evaluator of it."""
