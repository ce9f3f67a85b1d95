"""The wheel is tested as it is installed; fixtures are the repository's."""

import pathlib

import pytest

ROOT = pathlib.Path(__file__).resolve().parents[2]


@pytest.fixture
def fixtures():
    return ROOT / "fixtures"


@pytest.fixture
def cube(fixtures):
    return fixtures / "robodk" / "irc5" / "Cube45.mod"
