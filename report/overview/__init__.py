"""What the first pages say: the first screen, answers to the research questions, corrected predictions."""
