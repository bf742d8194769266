"""What the thesis states and what was measured, as files, and what reads them."""
