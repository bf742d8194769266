"""Evidence and claims, made once for each test process."""

import pytest

from report.claims.all_claims import all_claims
from report.evidence import gather
from report.inventory import read_inventory


@pytest.fixture(scope="session")
def inventory():
    return read_inventory()


@pytest.fixture(scope="session")
def evidence():
    return gather()


@pytest.fixture(scope="session")
def claims(evidence, inventory):
    return {claim.id: claim for claim in all_claims(evidence, inventory)}


def pytest_collection_modifyitems(items: list[pytest.Item]) -> None:
    """Keep the tests of claims in one process: to make all claims takes a tenth of the whole run."""
    for item in items:
        if "claims" in getattr(item, "fixturenames", ()):
            item.add_marker(pytest.mark.xdist_group("claims"))
