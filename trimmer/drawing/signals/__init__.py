"""Pictures of signals: samples, spectra, measured over simulated or fitted motion."""
