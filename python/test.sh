#!/usr/bin/env bash
# Builds the wheel, installs it into an environment of its own, and runs pytest and the notebooks on what was installed.
set -euo pipefail
root=$(cd "$(dirname "$0")/.." && pwd)
work=${1:-}
if [ -z "$work" ]; then
    work=$(mktemp -d)
    trap 'rm -rf "$work"' EXIT
fi
# Debian keeps venv in a package of its own.
python3 -c "import ensurepip, venv" 2>/dev/null || (apt-get update -q && apt-get install -qy python3-venv)
python3 -m venv "$work/build" "$work/use"
"$work/build/bin/pip" install -q "maturin>=1.9,<2"
cd "$root/python"
PATH="$work/build/bin:$PATH" maturin build --release --out "$work/wheels" --interpreter "$work/use/bin/python"
"$work/use/bin/pip" install -q "$(echo "$work"/wheels/driftpost-*.whl)[fleet]" -r requirements-test.txt
cd "$work"
"$work/use/bin/python" -m pytest -q --rootdir "$root" -p no:cacheprovider "$root/python/tests"
