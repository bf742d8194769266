"""What a mechanism or a loop settles to: exact periodic motions, and statistics of what does not repeat.

``shooting`` solves for a state that returns, ``orbit`` is what it gives, with its ``multipliers``, and
``forced_orbit`` its entry; ``by_itself`` is all of this without a drive, where the period is unknown.
``respond`` follows a motion from its start: ``settling`` looks for orbits on the way, ``recurrence`` says
whether the motion comes to one, and ``same`` whether two are one. What meets no event any more is solved for:
``linear_motion`` is it in closed form, ``linear_lines`` its exact measures, ``rest`` where it stands still,
``solved`` what it comes to. What does not settle is seen through a ``window`` of drive periods, whose means
have the errors that ``estimate`` gives, and ``verdict`` says what it is, with the help of ``zero_one``.
``response`` is the result, ``response_json`` its JSON.

``flows`` gives the motion of either, from which all here is asked. ``simulate`` is the entry of plain
simulation, ``motion`` its result for a mechanism, with ``energy``; ``starts`` reads where a motion begins.
"""

import lazy_loader

__getattr__, __dir__, __all__ = lazy_loader.attach_stub(__name__, __file__)
