"""Exact motion of anything that is linear between events, without a word of what moves.

``taylor`` writes the flow over a step as a polynomial, ``first_root`` finds where an event function falls to
zero, ``linear_combination`` evaluates polynomials of states, and ``compilation`` keeps compiled code.
``dry_friction`` says which of several holds at once go on holding, and where the others go.
"""
