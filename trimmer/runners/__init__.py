"""Who does the work of many independent cells: this process, several, or a cluster."""
