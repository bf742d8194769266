"""The linear part of a mechanism: its ``matrices``, its ``outputs``, and its ``state_space``."""
