"""Proofs of identity, exponentials, Laplace transform, stability, and terms written without evaluation."""
