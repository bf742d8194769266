"""A mechanism as data: bodies, and what holds, pushes and rubs them.

``parts`` are the parts, ``mechanism`` puts them together.
"""
