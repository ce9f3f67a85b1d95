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


@pytest.fixture(scope="session")
def plant(tmp_path_factory):
    """20 robots: two weeks of measurements and a program each, and what one process makes of them."""
    pytest.importorskip("pyarrow")
    import fleet_plant

    from driftpost import fleet

    folder = tmp_path_factory.mktemp("plant")
    fleet_plant.weeks(folder, 20)
    fleet.run(fleet.DIAGNOSE, str(folder / "weeks" / "second.parquet"), str(folder / "diagnosed"), ray=False)
    fleet_plant.programs(folder, 20, folder / "diagnosed" / "results", ROOT / "fixtures")
    fleet.run(fleet.COMPENSATE, str(folder / "programs.parquet"), str(folder / "compensated"), ray=False)
    return folder
