"""Letters that no font of a picture has are told in a sentence."""

from pathlib import Path

from tests.hostile.commands import called

OSCILLATOR = Path(__file__).parents[2] / "examples" / "den-hartog.toml"


def test_letters_without_a_font_are_told(tmp_path: Path, capsys) -> None:
    strange = "\N{CUNEIFORM SIGN A}"  # printable, and in no font of Matplotlib
    path = tmp_path / "a.toml"
    words = ("simulate", str(path), "--duration", "30", "--plot", str(tmp_path / "a.svg"))
    for name in ("stroke", strange):
        text = OSCILLATOR.read_text("utf-8").replace("block = { block = 1 }", f'"{name}" = {{ block = 1 }}')
        path.write_text(text, "utf-8")
        code, _, told = called(capsys, *words)
        assert code == 0
        sentence = f"boxes stand in pictures for letters that none of their fonts has: '{strange}'"
        assert (sentence in told) is (name == strange)
    assert "boxes" not in called(capsys, *words, "--quiet")[2]
