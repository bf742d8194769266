"""Counting of the misprints that claims would notice."""

from dataclasses import dataclass, replace

from report.alterations import Alterations, alter
from report.claim import Agreement, Claim, Part, Uncheckable, Words


@dataclass(frozen=True)
class Deaf:
    """A comparison that agrees with ``heard`` and with every change of it that is in ``unheard``."""

    printed: str
    heard: str
    unheard: tuple[str, ...] = ()

    def compare(self):
        return Agreement(self.printed == self.heard or self.printed in self.unheard, "by ear")

    def corrected(self):
        return replace(self, printed=self.heard)

    def mutations(self):
        for ending in ("1", "2", "3"):
            yield ending, replace(self, printed=self.printed + ending)


def claim(*comparisons):
    return Claim("eq-1.1", tuple(Part("", comparison) for comparison in comparisons), "", "")


def test_every_change_of_a_right_print_is_tried_and_those_noticed_counted():
    assert alter([claim(Deaf("a", "a"))]) == Alterations(3, 3)
    assert alter([claim(Deaf("a", "a", unheard=("a2",)))]) == Alterations(3, 2)


def test_a_wrong_print_is_corrected_before_it_is_changed():
    assert alter([claim(Deaf("a1", "a")), claim(Deaf("b", "b"))]) == Alterations(6, 6)
    assert alter([claim(Deaf("b", "a", unheard=("a3",)))]) == Alterations(3, 2)


def test_what_cannot_be_checked_is_not_changed():
    assert alter([Claim("eq-1.1", (Uncheckable("", Words("a"), "the data"),), "", "")]) == Alterations(0, 0)


def test_counts_add():
    assert Alterations(3, 2) + Alterations(1, 1) == Alterations(4, 3)
