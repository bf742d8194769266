"""Solutions by ways of their own, which confirm what the claims derive."""
