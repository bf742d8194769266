"""Random TOML texts, written in all the ways that TOML has, with the line of each key."""

import json

from hypothesis import strategies as st

NAMES = st.text(st.sampled_from("abzAZ09_- .#='[]{}\\\"\n\tµé😀"), max_size=5)
TEXTS = st.text(st.sampled_from("ab ,#='[]{}\\\"\n\tµ"), max_size=12)
LEAVES = st.one_of(st.integers(0, 9), st.booleans(), TEXTS, st.sampled_from([1.5e-3, -2.0]))
VALUES = st.recursive(
    LEAVES,
    lambda inner: st.one_of(st.lists(inner, max_size=3), st.dictionaries(NAMES, inner, max_size=3)),
    max_leaves=8,
)
DOCUMENTS = st.dictionaries(NAMES, VALUES, max_size=4)


class Writer:
    """Writes a document and notes on which line each key begins."""

    def __init__(self, draw: st.DrawFn) -> None:
        self.draw, self.text, self.lines = draw, "", {}

    def document(self, content: dict) -> None:
        self.table((), content)

    def table(self, place: tuple, content: dict) -> None:
        below = {name: value for name, value in content.items() if self.gets_a_heading(value)}
        for name, value in content.items():
            if name not in below:
                self.blank_lines()
                self.assignment(place, (name,), value)
                self.end_line()
        for name, value in below.items():
            if isinstance(value, dict):
                self.heading((*place, name), "[", "]")
                self.table((*place, name), value)
                continue
            for count, entry in enumerate(value):
                self.heading((*place, name), "[[", "]]", (str(count),))
                for key, inner in entry.items():
                    self.assignment((*place, name, str(count)), (key,), inner)
                    self.end_line()

    def gets_a_heading(self, value: object) -> bool:
        of_tables = isinstance(value, list) and value and all(isinstance(each, dict) for each in value)
        return (isinstance(value, dict) or of_tables) and self.chance()

    def heading(self, place: tuple, opening: str, closing: str, entry: tuple = ()) -> None:
        self.blank_lines()
        for length in range(1, len(place + entry) + 1):
            self.note((place + entry)[:length])
        self.write(opening + self.spaces() + ".".join(map(self.key, place)) + self.spaces() + closing)
        self.end_line()

    def assignment(self, place: tuple, key: tuple, value: object) -> None:
        while isinstance(value, dict) and len(value) == 1 and self.chance():  # a dotted key
            ((name, value),) = value.items()
            key = (*key, name)
        for length in range(1, len(key) + 1):
            self.note((*place, *key[:length]))
        dot = self.spaces() + "." + self.spaces()
        self.write(dot.join(map(self.key, key)) + self.spaces() + "=" + self.spaces())
        self.value((*place, *key), value)

    def value(self, place: tuple, value: object) -> None:
        match value:
            case dict():
                self.write("{" + self.spaces())
                for count, (name, inner) in enumerate(value.items()):
                    self.write(", " if count else "")
                    self.assignment(place, (name,), inner)
                self.write(self.spaces() + "}")
            case list():
                self.write("[")
                for count, inner in enumerate(value):
                    self.write("," if count else "")
                    self.end_line(inside=True)
                    self.note((*place, str(count)))
                    self.value((*place, str(count)), inner)
                self.write("," if value and self.chance() else "")
                self.end_line(inside=True)
                self.write("]")
            case str():
                self.write(self.string(value))
            case bool():
                self.write(str(value).lower())
            case _:
                self.write(repr(value))

    def string(self, text: str) -> str:
        ways = [json.dumps(text, ensure_ascii=False)]
        if "'" not in text and "\n" not in text:
            ways.append(f"'{text}'")
        if "'''" not in text and not text.endswith("'" * 3):
            ways.append(f"'''\n{text}'''")
        escaped = text.replace("\\", "\\\\").replace('"""', '""\\"')
        ways.append(f'"""\n{escaped}"""')
        return self.draw(st.sampled_from(ways))

    def key(self, name: str) -> str:
        ways = [json.dumps(name, ensure_ascii=False)]
        if "'" not in name and "\n" not in name:
            ways.append(f"'{name}'")
        if name and name.isascii() and name.replace("_", "a").replace("-", "a").isalnum():
            ways.append(name)
        return self.draw(st.sampled_from(ways))

    def chance(self) -> bool:
        return self.draw(st.booleans())

    def spaces(self) -> str:
        return self.draw(st.sampled_from(["", " ", " \t"]))

    def end_line(self, inside: bool = False) -> None:
        if inside and self.chance():
            self.write(self.spaces())
            return
        self.write(self.draw(st.sampled_from(["\n", " # a = [1]\n", "\r\n", '# "\n'])))

    def blank_lines(self) -> None:
        self.write(self.draw(st.sampled_from(["", "\n", "# x = 1\n", "\r\n\n", "  \t"])))

    def note(self, place: tuple) -> None:
        self.lines.setdefault(place, self.text.count("\n") + 1)

    def write(self, text: str) -> None:
        self.text += text


@st.composite
def toml_texts(draw: st.DrawFn) -> tuple[str, dict, dict]:
    """A text, what it holds, and the line of each key."""
    content = draw(DOCUMENTS)
    writer = Writer(draw)
    writer.document(content)
    return writer.text, content, writer.lines
