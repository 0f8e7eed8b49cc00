"""Tables, figures and reports of ensembles."""
