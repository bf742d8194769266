"""Drawings of a report: those that come finished, those that are made of its findings, and their colours."""
