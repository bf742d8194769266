"""Evidence, claims and findings, made once in each run of the tests."""

import pytest

from report.building.collect import collect
from report.cache.source_closure import SourceTree
from report.data.statements import read_inventory
from report.judging.judge import judge
from report.numbers.evidence import gather
from tests.report.made_once import MadeOnce


@pytest.fixture(scope="session")
def made_once(tmp_path_factory, request):
    return MadeOnce.of_this_run(tmp_path_factory, request.config)


@pytest.fixture(scope="session")
def inventory():
    return read_inventory()


@pytest.fixture(scope="session")
def source_tree(made_once):
    return made_once.get("source_tree", SourceTree.read)


@pytest.fixture(scope="session")
def evidence(made_once):
    return made_once.of_sources("evidence", gather)


@pytest.fixture(scope="session")
def records(inventory):
    return collect(inventory)


@pytest.fixture(scope="session")
def claims(evidence, records, made_once):
    return made_once.of_sources(
        "claims", lambda: {claim_id: record.claim(evidence) for claim_id, record in records.by_id.items()}
    )


@pytest.fixture(scope="session")
def findings(claims, inventory, made_once):
    return made_once.of_sources(
        "findings",
        lambda: {claim_id: judge(claims[claim_id], entry) for claim_id, entry in inventory.items()},
    )
