"""What a response holds: the motions that were found, their JSON, and which of them are one."""
