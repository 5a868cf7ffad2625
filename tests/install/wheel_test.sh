#!/usr/bin/env bash
# Makes the wheel with all libraries from a build, installs it in an environment of this machine's Python, and compares its runs.
# usage: wheel_test.sh BUILD_DIR SOURCE_DIR PYTHON
set -euo pipefail
build=$1 source=$2 python=$3
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
unset CASTAWAY_DATA PYTHONPATH

fail() { echo "wheel_test: $1" >&2; exit 1; }

SOURCE_DATE_EPOCH=0 "$source/scripts/release" --wheel --build "$build" --changed --out "$work"
cd "$work"
"$python" -m venv --system-site-packages venv
PIP_NO_INDEX=1 venv/bin/pip install --quiet --disable-pip-version-check ./castaway-*.whl

# Every library is listed, and has a name of its own unless it is of the compilers.
package=$(echo venv/lib/python3*/site-packages/castaway)
cut -f1 "$package/share/doc/castaway/PARTS.tsv" | grep '^lib/' | sort >parts.txt
(cd "$package" && find lib -type f | sort) | diff - parts.txt || fail "PARTS.tsv lists other libraries"
if grep '^lib/lib' parts.txt; then fail "these libraries have the names of the machine's"; fi

quick=(run --duration 3 --set 'outputs.snapshots={every_s: 2}')
"$build/castaway" "${quick[@]}" --out expected >expected.log
PATH="$work/venv/bin:$PATH" castaway "${quick[@]}" --out program >program.log || fail "its program fails"
cat >run.py <<'PY'
import pathlib
import castaway

castaway.run("lab/kidnap", set={"duration_s": 3, "outputs.snapshots": {"every_s": 2}}, out="python")
loaded = {line.split()[-1] for line in pathlib.Path("/proc/self/maps").read_text().splitlines() if ".so" in line}
assert [name for name in loaded if "/castaway/lib/cawLLVM" in name], "it draws with another renderer"
doubles = {name for name in loaded if any(word in name for word in ("/libLLVM", "/libEGL", "/libBullet", "/libyaml-cpp"))}
assert not doubles, f"it takes libraries of the machine: {doubles}"
PY
venv/bin/python run.py || fail "castaway.run fails"
for run in program python; do
  diff -rq -x timing.json -x timing.csv -x report.html expected "$run" || fail "its runs differ from those of the normal build"
done
[ -n "$(find python -name '*.png')" ] || fail "it leaves no pictures"
