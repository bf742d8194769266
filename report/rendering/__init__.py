"""Presentation of a finished report document: Markdown, HTML, PDF and JSON."""
