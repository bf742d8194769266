"""Numeric code that `trimmer derive` writes; not edited by hand."""
