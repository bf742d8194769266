"""How figures are drawn: their style, parts that several share, and SVG."""
