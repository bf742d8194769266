"""Ways of holding a printed thing against a derived one, one small class each."""
