"""What section 6.4 of the thesis asks for, answered: with figures, evidence and limits."""
