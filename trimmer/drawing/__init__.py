"""Pictures of motions of mechanisms: each function draws into axes that it is given, so that others may too.

Matplotlib is imported by these modules alone; import them where a picture is wanted.
"""
