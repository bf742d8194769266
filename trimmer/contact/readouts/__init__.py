"""What is read of the motion of a mechanism: outputs, forces, impacts, and what its parts do."""
