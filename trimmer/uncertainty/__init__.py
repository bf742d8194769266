"""What a mechanism does when its numbers scatter: distributions, samples, yield, and which number matters."""
