"""The step response of a controlled mechanism, and how long it is followed."""
