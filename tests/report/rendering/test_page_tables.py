"""Tables in a real browser: where there is no room for columns, rows become blocks, and stay rows to hear."""

from collections.abc import Callable

import pytest
from playwright.sync_api import Locator, Page

from tests.report.rendering.page_checks import Visit, resize, unfold

pytestmark = pytest.mark.browser

SIDE_BY_SIDE = """
  (table) => {
    const cells = [...table.querySelectorAll('tbody tr:first-child > *')];
    const boxes = cells.map((cell) => cell.getBoundingClientRect());
    return Math.max(...boxes.map(({ top }) => top)) < Math.min(...boxes.map(({ bottom }) => bottom));
  }
"""
ROLES = ("table", "row", "rowheader", "columnheader", "cell", "gridcell", "LayoutTable", "LayoutTableCell")
SCROLLING = "tables => tables.map(t => t.parentElement).filter(b => b.scrollWidth > b.clientWidth).length"


@pytest.fixture
def page(visit: Callable[..., Visit]) -> Page:
    page = visit().page
    unfold(page)
    return page


def parts(page: Page) -> Locator:
    return page.get_by_role("table").and_(page.locator("[id='eq-2.37'] table"))


def heard(page: Page) -> list[tuple[str, str]]:
    """Return role and name of all that Chromium gives a screen reader for tables."""
    session = page.context.new_cdp_session(page)
    nodes = session.send("Accessibility.getFullAXTree")["nodes"]
    session.detach()
    announced = [
        (node["role"]["value"], node.get("name", {}).get("value", "")) for node in nodes if "role" in node
    ]
    return [(role, name.strip()) for role, name in announced if role in ROLES]


def test_narrow_rows_are_blocks_and_none_scrolls_sideways(page: Page) -> None:
    tables = page.locator("table.stacking")
    assert tables.count() > 3
    assert all(table.evaluate(SIDE_BY_SIDE) for table in tables.all())
    resize(page, 360)
    unfold(page)
    assert not any(table.evaluate(SIDE_BY_SIDE) for table in tables.all())
    without_matrices = page.locator("table.stacking:not(.errata)")
    assert without_matrices.evaluate_all(SCROLLING) == 0


@pytest.mark.slow
def test_a_narrow_table_is_the_same_table_for_a_screen_reader(page: Page) -> None:
    wide = heard(page)
    assert ("columnheader", "As derived") in wide
    assert ("rowheader", "second line") in wide
    resize(page, 360)
    unfold(page)
    assert heard(page) == wide


def test_the_cells_of_a_narrow_table_carry_the_names_of_their_columns(page: Page) -> None:
    resize(page, 360)
    named = (
        parts(page)
        .locator("tr")
        .nth(1)
        .locator("td")
        .evaluate_all("cells => cells.map(cell => getComputedStyle(cell, '::before').content)")
    )
    assert [name.partition(" /")[0] for name in named] == ["none", '"Thesis, our wording"', '"As derived"']
