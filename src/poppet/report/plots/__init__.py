"""Interactive plots of HTML pages: data of a figure, and the scripts that draw them."""
