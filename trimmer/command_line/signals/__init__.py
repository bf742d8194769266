"""The subcommands for measured signals, with their options and texts."""
