"""The derivation as a chain: steps with numbers, lines of code, pictures, symbols, places of claims."""
