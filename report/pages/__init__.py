"""What turns Markdown and figures into pages, HTML and PDF: whoever has something to show uses it."""
