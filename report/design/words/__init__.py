"""What was found, in words: phrases, the verdict, sentences of the report."""
