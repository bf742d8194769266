"""The modes of a mechanism: their equations, the events that end them, and what follows these."""
