"""The steps from each nonlinear element's waveform to its describing function, one module per subject."""
