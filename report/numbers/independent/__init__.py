"""Numbers computed by other ways, which confirm what is derived."""
