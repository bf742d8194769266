"""Sampled signals and their files.

``signal`` is what the rest works on. ``read`` reads one from a CSV file, in this order: ``text_file`` gives
text, ``csv_layout`` and ``csv_table`` rows and headings, ``columns`` the columns that are meant, ``cells``
numbers, ``missing`` and ``time_stamps`` samples at a known rate. ``write`` writes CSV and ``wav`` audio.
"""
