"""Numbers found a second way, which confirm what the report derives."""
