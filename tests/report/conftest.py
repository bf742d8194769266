"""Evidence and claims, made once for each test process."""

import pytest

from report.collect import collect
from report.evidence import gather
from report.inventory import read_inventory


@pytest.fixture(scope="session")
def inventory():
    return read_inventory()


@pytest.fixture(scope="session")
def evidence():
    return gather()


@pytest.fixture(scope="session")
def records(inventory):
    return collect(inventory)


@pytest.fixture(scope="session")
def claims(evidence, records):
    return {claim_id: record.claim(evidence) for claim_id, record in records.by_id.items()}
