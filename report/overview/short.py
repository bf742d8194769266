"""The thesis's loop in short: why a describing function, what it means, and how far it holds."""

from report.derivation.pictures import friction_backlash_picture
from report.judging.text import one_line
from report.numbers.evidence import Evidence
from report.pages.derivation import DerivationStep
from report.pages.figure import Equation, Figure


def short(known: Evidence) -> tuple[DerivationStep, ...]:
    """Return the steps, with the numbers as solved."""
    return _trimmer(known), _sine(), _play(), _balance(known), _orbit(known)


def _trimmer(known: Evidence) -> DerivationStep:
    *modes, last = (f"{mode.frequency:.0f}" for mode in known.numbers.modes)
    return _step(
        "short-trimmer",
        "The linear trimmer",
        f"""
        Motor, cutter, housing and guard ($q_1$ to $q_4$) move along one line, with springs and dampers
        between them. The pin on the motor moves the bridge, and the bridge's spring $k_2$ and damper $c_2$
        move the cutter. The thesis takes the displacement $u$ of the bridge as input, leaves its velocity
        out, and asks for the stroke of the cutter against the guard, $q_2 - q_4$. The natural frequencies are
        {", ".join(modes)} and {last} Hz.
        """,
        (
            r"M \ddot{q} + C \dot{q} + K q = k_2 \begin{pmatrix} -1 & 1 & 0 & 0 \end{pmatrix}^{\mathsf{T}} u",
            "",
        ),
        (
            r"G(s) = \frac{Q_2 - Q_4}{U} = \begin{pmatrix} 0 & 1 & 0 & -1 \end{pmatrix}"
            r" \left(M s^2 + C s + K\right)^{-1} k_2"
            r" \begin{pmatrix} -1 & 1 & 0 & 0 \end{pmatrix}^{\mathsf{T}}",
            "",
        ),
    )


def _sine() -> DerivationStep:
    return _step(
        "short-sine",
        "Which sine stands for the play's output",
        r"""
        A sine $x = A \sin\theta$, with $\theta = \omega t$, goes into the play. What comes out repeats with
        it, but is no sine. The trimmer lets its higher harmonics through far more weakly than the first. So
        one sine, $p \sin\theta + q \cos\theta$, shall stand for the output: the one that leaves the smallest
        mean square error.
        """,
        (r"E(p, q) = \frac{1}{2\pi} \int_0^{2\pi} (y - p \sin\theta - q \cos\theta)^2\, d\theta", ""),
        (
            r"p = \frac{1}{\pi} \int_0^{2\pi} y \sin\theta\, d\theta, \quad"
            r" q = \frac{1}{\pi} \int_0^{2\pi} y \cos\theta\, d\theta",
            "Both derivatives of $E$ are zero when nothing of this frequency is left over. Sine and cosine "
            "are orthogonal over a period, so each coefficient stands alone:",
        ),
        (
            r"N = \frac{p + j q}{A}",
            "These are the first Fourier coefficients; that is why it is this integral and no other. The "
            "describing function is the ratio of that sine to the one that went in:",
        ),
        (
            r"\oint y\, dx = A \int_0^{2\pi} y \cos\theta\, d\theta = \pi A^2 \operatorname{Im} N",
            "Its modulus says how much of the amplitude gets through, its angle how late. Its imaginary part "
            "is the area that output over input encloses in a period, negative for an output that lags:",
        ),
    )


def _play() -> DerivationStep:
    return _step(
        "short-play",
        "Play, with a load that friction holds",
        """
        While the pin pushes, the bridge follows it at half of the gap $b$. The pin turns round, and the
        bridge stays where it is until the pin has crossed the whole gap. From one turn of the pin to the
        next, and with the opposite sign in the other half of the period, the output is
        """,
        (
            r"y = \begin{cases} A - \frac{b}{2} & \quad \frac{\pi}{2} \le \theta < \pi - \psi \\"
            r" A \sin\theta + \frac{b}{2} & \quad \pi - \psi \le \theta < \frac{3\pi}{2} \end{cases}"
            r" \quad \text{with} \quad \sin\psi = 1 - \frac{b}{A}",
            "",
        ),
        (
            r"N = \frac{1}{\pi} \left(\frac{\pi}{2} + \psi + \sin\psi \cos\psi\right)"
            r" - \frac{j}{\pi} \cos^2\psi",
            "Both integrals over these two pieces, times two for the other half:",
        ),
        picture=friction_backlash_picture("short-play"),
    )


def _balance(known: Evidence) -> DerivationStep:
    unstable, stable = known.cycles.friction.unstable, known.cycles.friction.stable
    return _step(
        "short-balance",
        "A loop that keeps itself going",
        """
        Only $b/A$ has come into $N$. So each limit cycle grows in proportion to the gap, at a frequency that
        does not depend on the gap, and there is no smallest gap. In the thesis's loop the output goes back to
        the pin with the opposite sign. A first harmonic comes back as $-N G$ times itself, and keeps itself
        going if it comes back unchanged:
        """,
        (r"1 + N\left(\tfrac{b}{A}\right) G(j\omega) = 0", ""),
        (
            r"F_A\, \delta A + F_\omega\, (\delta\omega - j\sigma) = 0, \quad F = 1 + N G",
            f"One complex equation for two real numbers. It has two solutions: {unstable.amplitude:.4f} gaps "
            f"at {unstable.frequency:.2f} Hz and {stable.amplitude:.4f} gaps at {stable.frequency:.2f} Hz. "
            r"Which of them lasts? Let the amplitude be off by $\delta A$ and this deviation grow at the "
            r"rate $\sigma$, so that $j\omega$ becomes $j(\omega + \delta\omega) + \sigma$. To first order "
            "$F$ stays zero if",
        ),
        (
            r"\operatorname{Im}\left(\overline{F_A}\, F_\omega\right) > 0",
            r"Solved for $\sigma$: a deviation dies out, and the limit cycle is stable by Loeb's rule, if",
        ),
    )


def _orbit(known: Evidence) -> DerivationStep:
    exact, unstable = known.orbits.friction.stable, known.orbits.friction.unstable
    return _step(
        "short-orbit",
        "The same without the sine",
        f"""
        The larger of the two is stable, the smaller is not: small motions come to rest, and what lies well
        above it grows to the larger. All this assumed a sine at the pin. The loop needs no such assumption.
        While the bridge is pushed and while it stands, for the times $t_c$ and $t_f$, it is linear, and its
        motion is known in closed form. A motion of two equal halves closes if the state after both pieces is
        the negative of the first. Newton's method solves for it: the stable limit cycle has
        {exact.amplitude:.4f} gaps, the unstable one {unstable.amplitude:.4f} gaps at
        {unstable.frequency:.2f} Hz, and their Floquet multipliers confirm which of them lasts. Harmonic
        balance misses the stable amplitude by {abs(exact.amplitude_error):.2%} and the frequency by
        {abs(exact.frequency_error):.3%}.
        """,
        (
            r"x(t_c + t_f) = -x(0), \quad f = \frac{1}{2 (t_c + t_f)} = "
            rf"{exact.frequency:.2f}\ \mathrm{{Hz}}",
            "",
        ),
    )


def _step(
    name: str, title: str, text: str, *formulas: tuple[str, str], picture: Figure | None = None
) -> DerivationStep:
    equations = tuple(Equation(latex, words=words) for latex, words in formulas)
    return DerivationStep(name, title, one_line(text), equations, picture=picture)
