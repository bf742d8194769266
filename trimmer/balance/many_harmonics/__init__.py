"""Balance of many harmonics: what elements give for inputs of any odd shape, and several elements in a loop.

``trigonometric`` is an input of odd harmonics, ``pieces`` the pieces of an output, ``steady_response`` its
harmonics. ``feedback`` solves for a plant with several elements, from starts that ``starts`` finds.
"""
