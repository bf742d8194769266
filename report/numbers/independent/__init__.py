"""Second ways to numbers of the report, each independent of the way that the claims take first."""
