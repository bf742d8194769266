"""A motion followed until it settles, is solved for, or is judged as what it is."""
