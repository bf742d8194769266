"""Limit cycles of many trimmers at once, each with its own parameters and gap."""
