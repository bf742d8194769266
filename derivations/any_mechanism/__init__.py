"""What any declared mechanism leads to: equations, laws of contact and friction, LaTeX, numeric module."""
