"""Pure functions: flow after ISO 6358, gas and heat, curves over a stroke."""
