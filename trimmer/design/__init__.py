"""What a designer asks of a mechanism: verdict, motions, maps, margins, sensitivities; no prose."""
