"""Pictures: each function draws into axes that it is given, or returns the content of a whole file.

Matplotlib is imported by these modules alone; import them where a picture is wanted.
"""
