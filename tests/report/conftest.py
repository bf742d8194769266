"""Evidence and claims, made once for each test process."""

import pytest

from report.chapters.all_claims import SECTIONS, claims_of, require_known_once
from report.evidence import gather
from report.inventory import read_inventory
from report.record import ClaimRecord, modules, records


@pytest.fixture(scope="session")
def inventory():
    return read_inventory()


@pytest.fixture(scope="session")
def evidence():
    return gather()


@pytest.fixture(scope="session")
def claims_of_sections(evidence):
    """Claims by the name of the module that makes them."""
    return {section.__name__: claims_of(section, evidence) for section in SECTIONS}


@pytest.fixture(scope="session")
def claims(claims_of_sections, inventory):
    made = [claim for claims in claims_of_sections.values() for claim in claims]
    require_known_once((claim.id for claim in made), inventory)
    return {claim.id: claim for claim in made}


@pytest.fixture(scope="session")
def records_by_id():
    return {record.id: record for module in modules() for record in records(module, ClaimRecord)}
