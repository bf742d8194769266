"""What a report shows, as frozen data: a file per part of it."""
