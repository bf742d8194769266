"""A made-up text copy, with what makes the real one hard to read."""

TEXT = r"""A THESIS OF NOBODY

Chapter 1

Where pendulums come from and go to

They swing.

1.1 Motion of a pendulum

A pendulum hangs from a ceiling and moves

Figure 1.1: A pendulum: hung up

to and fro. Its angle obeys:

$$\ddot{x} = -x \quad (1.1)$$

¹Only if it swings little

where x is its angle.

² and nothing else is:

$$\begin{aligned}
 y &= 2x \\

 z &= 3x
 \end{aligned}\tag{1.2}$$

Without friction

(a) says more. It ends with a formula $x$

It begins anew, and:

$$z = 4x$$

(a) Left

(b) Right**Figure 1.2:** Two pendulums

1.2 Numbers

Table 1.1: Periods

Length	Period
1	2.0
4	4.0

Both were measured.

Appendix A

Code

A.1 The program

Listing A.1: Swing

```
1 x = 1;

2 y = 2;
```

```
3 z = 3;
```

Nothing follows."""
"""Lines are counted from 1: the chapter's number stands on line 3."""
LINES = TEXT.split("\n")


def line_of(words: str) -> int:
    """Return the number of the first line that holds these words."""
    return 1 + next(index for index, line in enumerate(LINES) if words in line)
