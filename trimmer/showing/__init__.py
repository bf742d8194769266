"""How results show themselves: in one line as text, as HTML in a notebook, as a data frame."""
