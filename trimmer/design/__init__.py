"""What a designer asks of a mechanism: verdict on targets, motions, maps, margins, sensitivities; no prose."""
