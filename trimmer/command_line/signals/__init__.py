"""The subcommand for measured signals, with its options and texts."""
