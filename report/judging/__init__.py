"""What a claim, a finding and a verdict are, and how one is judged; nothing here knows of this thesis."""
