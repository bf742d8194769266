"""Motions that meet no event any more: linear ones in closed form, and rests."""
