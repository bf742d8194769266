"""How a build goes: stages, tasks, and what is kept for the next one."""
