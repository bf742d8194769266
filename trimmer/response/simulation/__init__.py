"""Plain simulation: its entry, its motion of a mechanism, with energies and how contacts close."""
