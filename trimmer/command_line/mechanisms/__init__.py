"""The subcommands for any mechanism, with their options and texts."""
