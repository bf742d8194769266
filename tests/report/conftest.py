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
