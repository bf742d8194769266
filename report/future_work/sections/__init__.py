"""The six answers, each in a file with its figure."""
