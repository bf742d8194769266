"""The subcommands for the loops of the thesis's trimmer, with their options and texts."""
