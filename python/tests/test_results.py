"""What results are as Python objects."""

import pickle

import driftpost


def test_rows_of_a_table_are_dicts_and_survive_a_pickle():
    table = driftpost.Table.from_json('[{"line": 30, "form": "ramp", "mm": 0.5}, {"line": 31, "form": null}]')
    rows = [{"line": 30, "form": "ramp", "mm": 0.5}, {"line": 31, "form": None, "mm": None}]
    assert table.rows() == rows and len(table) == 2
    assert repr(table) == "<driftpost.Table, 2 rows: form, line, mm>"
    again = pickle.loads(pickle.dumps(table))
    assert again.rows() == rows and again.column_names == table.column_names


def test_results_can_be_pickled(pytestconfig):
    cube = pytestconfig.rootpath / "fixtures" / "robodk" / "irc5" / "Cube45.mod"
    result = driftpost.compensate(cube, form="ramp")
    again = pickle.loads(pickle.dumps(result))
    assert (again.files, again.text, again.report()) == (result.files, result.text, result.report())
    assert again.motions.rows() == result.motions.rows()


def test_no_name_of_a_file_in_between_is_told(pytestconfig):
    cube = pytestconfig.rootpath / "fixtures" / "robodk" / "irc5" / "Cube45.mod"
    text = driftpost.compensate(cube, form="ramp").text
    found = driftpost.simulate(text, cube.read_text(), minutes=[0, 60])
    told = found.report() + repr(found.data)
    assert found.within and "/tmp" not in told and "driftpost-" not in told, told
