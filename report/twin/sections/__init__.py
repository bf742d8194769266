"""The sections of the chapter on the twin, a module each; each module ends with its SECTION."""
