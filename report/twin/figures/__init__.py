"""The figures of the chapter on the twin."""
