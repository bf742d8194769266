"""Mechanisms with other numbers, tried cheaply: sensitivities, scatter, unknown ranges, remedies."""
