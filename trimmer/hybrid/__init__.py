"""The core: exact motion of anything that is linear between events, without a word of what moves.

``system`` is what it asks of that: statuses of parts, which together are a mode, and what follows events.
``tables`` keeps the modes that were met, and ``series`` writes their polynomials. ``integration`` goes from
event to event in compiled code, segment by ``segment``; ``step_event`` finds the next event with
``first_root`` and ``decaying_root``, ``tabulated_change`` does what follows it, ``work`` holds the arrays,
and ``advance`` calls it for a ``stretch``. ``variation`` differentiates the motion, ``nodes`` samples it, and
``calm`` says where in its period it had better begin. ``dry_friction`` says which of several parts that are
held at once go on being held, and where the others go. ``taylor``, ``linear_combination`` and ``compilation``
serve all.
"""
