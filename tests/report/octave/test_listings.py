"""The texts of the corrected listings: names, headers, language, repeatable bytes."""

import io
import re
import zipfile
from dataclasses import replace

from derivations.linear_trimmer import derive_linear_trimmer
from report.data.statements import read_inventory
from report.octave.archive import archive, files, write_files
from report.octave.contents import contents
from report.octave.listings import corrected_programs
from trimmer import TrimmerParameters

OCTAVE_ALONE = (
    *(r"^[^'%]*#", '"', "!", r"\b(printf|puts|fdisp)\b", r"\*\*", r"^\s*(do|until|unwind_protect)\b"),
    *(r"\bend(if|for|while|function|switch)\b", r"[-+*/|&^]=", r"\+\+|--"),
    r"\b(vpasolve|sym|syms|sym2poly|fsolve|optimset|optimoptions|fmincon|sim)\(",
)
"""Of Octave alone: comments, strings, operators and statements; of toolboxes, which MATLAB may lack."""


def test_one_program_for_each_listing_of_the_thesis(programs):
    listings = [entry.id for entry in read_inventory().values() if entry.id.startswith("lst-A.")]
    assert [program.claim for program in programs] == [*listings, "", ""]
    sections = {entry.id: entry.section for entry in read_inventory().values()}
    assert [content.section for content in contents()] == [sections[content.claim] for content in contents()]


def test_a_file_is_called_as_its_function(programs):
    *functions, script = programs
    assert script.name == "run_all.m"
    assert not re.search(r"^\s*function\b", script.text, re.MULTILINE)
    for program in functions:
        first = program.text.partition("\n")[0]
        assert re.fullmatch(rf"function .*\b{program.name.removesuffix('.m')}\(.*\)", first), first


def test_headers_say_what_is_corrected_and_how_it_was_made(programs):
    for program in programs:
        header = " ".join(line.lstrip("% ") for line in program.text.splitlines()[1:] if line.startswith("%"))
        assert "Generated from" in header
        assert "do not edit" in header
        for fault in program.faults:
            assert fault in header
        if program.claim:
            assert program.faults
            assert f"Corrects Listing {program.claim.removeprefix('lst-')} (section A." in header


def test_lines_are_short_and_of_ascii_alone(programs):
    for program in programs:
        assert program.text.isascii()
        assert program.text.endswith("end\n")
        assert max(map(len, program.text.splitlines())) <= 100
        assert not re.search(r"[ \t]$", program.text, re.MULTILINE)


def test_language_is_that_of_both_and_no_toolbox_is_needed_but_for_the_state_space(programs):
    for program in programs:
        lines = [line for line in program.text.splitlines() if not line.lstrip().startswith("%")]
        assert [line for line in lines for each in OCTAVE_ALONE if re.search(each, line)] == []
        assert ("ss(" in "\n".join(lines)) == (program.name == "listing_a_1.m")


def test_parameters_are_those_of_the_parameter_set(programs):
    changed = replace(TrimmerParameters.thesis(), k5=1234.5, m2=0.0031)
    first, *others = corrected_programs(derive_linear_trimmer(), changed)
    assert "    k5 = 1234.5; % N/m" in first.text
    assert "    m2 = 0.0031; % kg" in first.text
    assert [program.text for program in others] == [program.text for program in programs[1:]]


def test_same_input_gives_the_same_bytes(programs):
    again = corrected_programs(derive_linear_trimmer(), TrimmerParameters.thesis())
    assert again == programs
    assert archive(again) == archive(programs)


def test_archive_and_folder_hold_the_files(programs, tmp_path):
    with zipfile.ZipFile(io.BytesIO(archive(programs))) as packed:
        assert packed.testzip() is None
        held = {name: packed.read(name).decode() for name in packed.namelist()}
        assert {entry.date_time for entry in packed.infolist()} == {(1980, 1, 1, 0, 0, 0)}
    write_files(programs, tmp_path / "octave")
    written = {path.name: path.read_text(encoding="utf-8") for path in (tmp_path / "octave").iterdir()}
    assert held == written == files(programs)


def test_the_readme_names_each_file_and_how_to_run_them(programs):
    names = set(re.findall(r"^\| `([^`]+)` \|", files(programs)["README.md"], re.MULTILINE))
    assert names == {program.name for program in programs}
    assert "octave-cli run_all.m" in files(programs)["README.md"]
    part = files(programs[:1])["README.md"]
    assert "`listing_a_1.m`" in part and "run_all" not in part
    assert files(()) == {}
