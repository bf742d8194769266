"""Kept maps and branches: what was made from something else, or was changed, is noticed."""

import json
import shutil
from dataclasses import replace

import pytest

from report.numbers.future_work.all import ANSWERS
from report.numbers.twin.closed_loop import FILE as LOOP_FILE
from report.numbers.twin.closed_loop import FORCE as LOOP_FORCE
from report.numbers.twin.closed_loop import LOOP_COURSES
from report.numbers.twin.grids import COURSES, FRICTION_MAP, GRIDS, SPEED_MAP, Grid
from report.numbers.twin.kept_branch import FILE, read_branches, write_branches
from report.numbers.twin.kept_files import FOLDER, KeptDataError, digest_of, digest_of_files
from report.numbers.twin.kept_map import MEASURES, path_of, read_map
from report.numbers.twin.map_numbers import MapNumbers
from report.numbers.twin.mechanism import FORCE, GAP, twin
from report.twin import make_maps
from report.twin.cell_check import CellDifferenceError, check_cell, check_cells, name_of, seed_of
from report.twin.chapter import of_check, twin_chapter
from report.twin.sections import maps
from trimmer import FollowSettings, Mechanism, follow

MOST_BYTES = 1_500_000


@pytest.fixture(scope="module")
def friction():
    return read_map(FRICTION_MAP)


@pytest.fixture
def folder(tmp_path):
    for path in FOLDER.glob("*.json"):
        shutil.copy(path, tmp_path)
    return tmp_path


def altered(kept, number, **changes):
    cells = list(kept.cells)
    cells[number] = replace(cells[number], **changes)
    return replace(kept, cells=tuple(cells))


def number_of(kept, gap, force):
    gaps, forces = kept.values
    return int(abs(forces - force).argmin()) * gaps.size + int(abs(gaps - gap).argmin())


def test_the_twin_is_the_mechanism_of_the_example(project_folder):
    assert twin() == Mechanism.from_toml(project_folder / "examples" / "thesis-play.toml")


def test_all_files_are_there_and_moderate_in_size():
    assert {path.name for path in FOLDER.glob("*.json")} == {
        *(f"{grid.name}.json" for grid in GRIDS),
        "advice.json",
        "branches.json",
        "loop.json",
        *(answer.path.name for answer in ANSWERS),
    }
    assert sum(path.stat().st_size for path in FOLDER.glob("*.json")) < MOST_BYTES


def test_a_cell_that_is_as_kept_passes(friction):
    assert check_cell(friction, number_of(friction, 200e-6, 2.0))


def test_an_altered_cell_is_noticed_and_named(friction):
    number = number_of(friction, 200e-6, 2.0)
    with pytest.raises(
        CellDifferenceError, match=r"gap-friction, a gap of 200 µm and a friction of 2 N.*make maps"
    ):
        check_cell(altered(friction, number, period_count=1), number)


def test_an_altered_measure_is_noticed(friction):
    number = number_of(friction, 40e-6, 0.5)
    measures = list(friction.cells[number].measures)
    measures[MEASURES.index("second")] = 1e-6
    with pytest.raises(CellDifferenceError, match="40 µm"):
        check_cell(altered(friction, number, measures=tuple(measures)), number)


def test_a_chaotic_cell_that_is_said_to_repeat_is_noticed(friction):
    number = number_of(friction, 400e-6, 3.0)
    assert friction.cells[number].kind == "c"
    with pytest.raises(CellDifferenceError, match="but computed now is a chaotic motion"):
        check_cell(altered(friction, number, kind="p", period_count=3), number)


def test_the_draw_notices_an_altered_map(friction):
    small = Grid("gap-friction", twin(), {GAP: (0.0, 20e-6, 3), FORCE: (1.0, 2.0, 2)})
    numbers = [number_of(friction, gap, force) for force in (1.0, 2.0) for gap in (0.0, 10e-6, 20e-6)]
    part = replace(friction, grid=small, cells=tuple(friction.cells[n] for n in numbers), beside={})
    assert check_cells([part], 7, 6).drawn == 6
    with pytest.raises(CellDifferenceError):
        check_cells([altered(part, 4, period_count=2)], 7, 6)


@pytest.mark.slow
def test_the_draw_allows_few_cells_that_do_not_repeat_to_end_otherwise(friction, evidence):
    """Rounding decides how a long transient ends; some 20 of all cells differ for it."""
    small = Grid("gap-friction", twin(), {GAP: (400e-6, 420e-6, 3), FORCE: (3.0, 3.0, 1)})
    numbers = [number_of(friction, gap, 3.0) for gap in (400e-6, 410e-6, 420e-6)]
    said = replace(friction, grid=small, cells=tuple(friction.cells[n] for n in numbers), beside={})
    assert [cell.kind for cell in said.cells] == ["c", "c", "c"]
    for count in range(3):
        check = check_cells([said], 7, 3)
        told = of_check(check).finished(evidence).text
        assert len(check.others) == count == sum(name in told for name in check.cells)
        said = altered(said, count, kind="t")
    with pytest.raises(CellDifferenceError, match="kept is a torus"):
        check_cells([said], 7, 3)


@pytest.mark.slow
def test_cells_that_were_computed_again_end_the_section_on_maps_and_no_other(evidence):
    ends = {each.id: each.items[-1].id for each in twin_chapter(evidence, 3).sections}
    assert [name for name, end in ends.items() if end == "twin-cells"] == [maps.SECTION.id]


def test_the_draw_depends_on_the_seed_alone(friction):
    few = [check_cells([friction], seed, 2).cells for seed in (3, 3, 4)]
    assert few[0] == few[1] != few[2]
    assert seed_of("ff" * 32) == 0xFFFFFFFF


def test_the_name_of_a_cell_says_its_values():
    kept = read_map(SPEED_MAP)
    assert name_of(kept, 1) == "map gap-speed, a gap of 10 µm and a drive of 60 Hz"


@pytest.mark.parametrize(
    "changed",
    [
        replace(FRICTION_MAP, mechanism=twin(frequency=111.0)),
        replace(FRICTION_MAP, values={**FRICTION_MAP.values, FORCE: (0.0, 4.1, 41)}),
        replace(FRICTION_MAP, starts=2),
    ],
    ids=["mechanism", "values", "settings"],
)
def test_other_inputs_are_refused_with_what_to_do(changed):
    with pytest.raises(
        KeptDataError, match=r"gap-friction\.json .* was made from another .*: run `make maps`"
    ):
        read_map(changed)


def test_a_changed_file_is_refused(folder):
    path = path_of(FRICTION_MAP, folder)
    data = json.loads(path.read_text())
    data["content"]["period_count"][0][0] = 2
    path.write_text(json.dumps(data))
    with pytest.raises(KeptDataError, match="was changed after it was made: run `make maps`"):
        read_map(FRICTION_MAP, folder)
    data["digest"] = digest_of(data["content"])
    path.write_text(json.dumps(data))
    assert read_map(FRICTION_MAP, folder).period_count[0, 0] == 2


@pytest.mark.parametrize("content", [None, "", "{}", "[1]"])
def test_what_is_no_kept_file_is_refused(folder, content):
    path = path_of(FRICTION_MAP, folder)
    path.unlink() if content is None else path.write_text(content)
    with pytest.raises(KeptDataError, match=r"cannot be read .*make maps"):
        read_map(FRICTION_MAP, folder)


def test_the_digest_of_the_files_changes_with_any_of_them(folder):
    before = digest_of_files(folder)
    assert before == digest_of_files()
    (folder / "branches.json").write_text("{}")
    assert digest_of_files(folder) != before


def test_maps_are_made_resumed_and_read(tmp_path, capsys):
    grid = Grid("tiny", twin(), {GAP: (0.0, 40e-6, 2), FORCE: (1.0, 2.0, 2)})
    work, kept = tmp_path / "work", tmp_path / "kept"
    make_maps.make(work, kept, [grid])
    first = path_of(grid, kept).read_bytes()
    whole = (work / "tiny.map").read_text().splitlines(keepends=True)
    (work / "tiny.map").write_text("".join(whole[:2]) + whole[2][:10])
    path_of(grid, kept).unlink()
    make_maps.make(work, kept, [grid])
    assert path_of(grid, kept).read_bytes() == first
    assert read_map(grid, kept).period_count.tolist() == [[1, 1], [1, 1]]
    wider = replace(grid, values={**grid.values, FORCE: (1.0, 3.0, 2)})
    make_maps.make(work, kept, [wider])
    assert read_map(wider, kept).values[1].tolist() == [1.0, 3.0]
    capsys.readouterr()


@pytest.mark.parametrize(("courses", "path"), [(COURSES, FILE), (LOOP_COURSES, LOOP_FILE)])
def test_branches_begin_where_they_are_said_to(courses, path):
    branches = read_branches(courses, path)
    for course in courses:
        first = next(each for each in branches if each.course.name == course.name)
        assert first.parted == ""
        assert first.values[0] == pytest.approx(course.start)
        assert len(first.states) == len(first.strokes) == len(first.stable) == len(first.values)


def test_reach_and_shares_of_a_map_by_hand(friction):
    numbers = MapNumbers(friction)
    assert sum(numbers.shares.values()) == pytest.approx(1.0)
    row = friction.period_count[numbers.row(0.5)]
    until = next(at for at, count in enumerate(row) if count != 1)
    assert numbers.reach(0.5) == pytest.approx(numbers.first[until - 1])
    column = friction.period_count[:, numbers.column(40e-6)]
    begin = max(at for at, count in enumerate(column) if count != 1) + 1
    assert numbers.from_where_on(40e-6) == pytest.approx(numbers.second[begin])
    assert numbers.from_where_on(300e-6) == float("inf")
    assert numbers.within((0.0, 10e-6), (0.0, 0.1)).sum() == 4


def test_branches_are_kept_with_those_that_part_from_them(tmp_path):
    course, begun = COURSES[0], read_branches(COURSES, FILE)[0].states[0]
    interval, settings = (GAP, course.start, course.stop), FollowSettings(most_points=2, quiet=True)
    branch = follow(course.subject, *interval, state=begun, settings=settings)
    path = tmp_path / "branches.json"
    write_branches([(course, replace(branch, branches=(branch,)))], path)
    kept = read_branches((course,), path)
    assert len(kept) == 2
    for each in kept:
        assert each.values == pytest.approx([point.value for point in branch.points], rel=1e-9)
        strokes = [point.outputs[course.output].peak_to_peak for point in branch.points]
        assert each.strokes == pytest.approx(strokes, rel=1e-4)
        assert each.stable.tolist() == [point.stable for point in branch.points]
        assert each.states[-1] == pytest.approx(branch.points[-1].state, rel=1e-9)
    with pytest.raises(KeptDataError):
        read_branches((replace(course, stop=22e-6),), path)


def test_branches_of_a_loop_with_another_number_are_refused():
    first, *others = LOOP_COURSES
    other = replace(first, subject=first.subject.with_value(LOOP_FORCE, 2e-3))
    with pytest.raises(KeptDataError, match=r"loop\.json .* was made from another .*: run `make maps`"):
        read_branches((other, *others), LOOP_FILE)
