"""What the thesis's trimmer does, in numbers: each solved once for all claims and figures that need it."""
