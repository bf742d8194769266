"""Pictures of a design; each function only draws what was computed."""
