"""What the first pages say: highlights, answers to the research questions, corrected predictions."""
