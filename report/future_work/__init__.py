"""What section 6.4 of the thesis asks for, answered: each answer with a figure, its evidence and its limits."""
