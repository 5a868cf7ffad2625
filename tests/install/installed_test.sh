#!/usr/bin/env bash
# Installs castaway into an empty folder, runs the program there, and builds programs outside of the tree with its libraries.
# usage: installed_test.sh BUILD_DIR SOURCE_DIR COMPILER
set -euo pipefail
build=$1 source=$2 compiler=$3
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
unset CASTAWAY_DATA

fail() { echo "installed_test: $1" >&2; exit 1; }

# tools/quickstart builds the target castaway alone; what is installed must belong to it.
for file in castaway.1.gz castaway.bash _castaway; do
  ninja -C "$build" -t commands castaway | grep -qF "${file%.gz}" || fail "the target castaway does not make $file"
done

cmake --install "$build" --prefix "$work/usr" >"$work/install.log"

cd "$work"
usr/bin/castaway run --duration 2 --set outputs.snapshots=false --out run >run.log
[ -s run/summary.json ] || fail "the installed program left no summary.json"
usr/bin/castaway scenarios >scenarios.txt  # Not into grep -q, which ends before all is written.
grep -q "$work/usr/share/castaway/worlds/lab/scenarios/kidnap.yaml" scenarios.txt ||
  fail "the installed program does not take its own data"
zcat usr/share/man/man1/castaway.1.gz >castaway.1
grep -q "SH COMMANDS" castaway.1 || fail "no manual page"
bash -c '. usr/share/bash-completion/completions/castaway; complete -p castaway' | grep -q castaway || fail "no completion"

# What is not public is not installed.
(cd usr/include && find . -type f | sort) >headers.txt
diff headers.txt - <<'END' || fail "other headers are installed than the public ones"
./castaway/amcl.hpp
./castaway/evaluate.hpp
./castaway/frame.hpp
./castaway/grid.hpp
./castaway/localizer.h
./castaway/localizer.hpp
./castaway/mh_amcl.hpp
./castaway/plugin.hpp
./castaway/pose.hpp
./castaway/readings.hpp
./castaway/run.hpp
./castaway/scenario.hpp
./castaway/simulation.hpp
./castaway/stamp.hpp
END

# Debug information and sanitizers name source files, and what is built outside must be linked with sanitizers, too.
flags="$(grep -oP '(?<=^CMAKE_CXX_FLAGS_DEBUG:STRING=).*' "$build/CMakeCache.txt" || true)"
grep -q '^CMAKE_BUILD_TYPE:STRING=Debug' "$build/CMakeCache.txt" || flags=""
if [ -z "$flags" ] && grep -aqF "$source/" usr/bin/castaway; then fail "the program holds a path of the source tree"; fi
outside() {  # NAME SOURCES
  cmake -S "$2" -B "$1" -G Ninja -DCMAKE_CXX_COMPILER="$compiler" -DCMAKE_PREFIX_PATH="$work/usr" -DCMAKE_CXX_FLAGS="$flags" >"$1.log"
  cmake --build "$1" >>"$1.log" || { cat "$1.log"; fail "$1 does not build"; }
}
outside embed "$source/examples/embed"
embed/embed | tail -1 | grep -qx "found itself" || fail "examples/embed does not find itself"
outside library "$source/examples/library"
for name in dead_reckoning mh_amcl; do
  usr/bin/castaway run --duration 2 --set outputs.snapshots=false --localizer "library:library/lib$name.so" --out "run-$name" >"run-$name.log" ||
    fail "castaway cannot use examples/library/$name"
done
# The page of a run is made and a log evaluated by what is installed, too.
outside simulate "$source/examples/simulate"
(cd simulate && ./simulate >simulate.log) || { cat simulate/simulate.log; fail "examples/simulate fails"; }
for line in "kidnap after 1. scans" "run: 0 localizers failed" '.*"localizer":"doubter".*'; do
  grep -qx "$line" simulate/simulate.log || { cat simulate/simulate.log; fail "examples/simulate does not print '$line'"; }
done
