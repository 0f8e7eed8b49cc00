"""What an ensemble tells, as tables, figures and one page."""
