"""The code of docs/PYTHON.md runs as pasted, from the repository's root."""

import re


def test_the_page(fixtures, monkeypatch, capsys):
    monkeypatch.chdir(fixtures.parent)
    page = (fixtures.parent / "docs" / "PYTHON.md").read_text()
    blocks = re.findall(r"```python\n(.*?)```", page, re.DOTALL)
    assert len(blocks) > 4
    names = {}
    for block in blocks:
        exec(block, names)
    assert "input::truncated cell/A.mod 1" in capsys.readouterr().out
