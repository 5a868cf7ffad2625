#!/usr/bin/env bash
# Makes the portable bundle from a build and runs it on this machine: started from anywhere, with programs and libraries as localizers.
# usage: bundle_test.sh BUILD_DIR SOURCE_DIR FOLDER   (the archive stays in FOLDER, for the test bundle_bare)
set -euo pipefail
build=$1 source=$2 folder=$3
rm -rf "$folder"
mkdir -p "$folder"
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
unset CASTAWAY_DATA

fail() { echo "bundle_test: $1" >&2; exit 1; }

SOURCE_DATE_EPOCH=0 "$source/scripts/release" --build "$build" --level 1 --changed --out "$folder"
(cd "$folder" && sha256sum --quiet -c ./*.sha256)
mkdir "$work/a b"
tar --zstd -C "$work/a b" -xf "$folder"/castaway-*.tar.zst
bundle="$work/a b/castaway" castaway="$work/a b/castaway/bin/castaway"

# Every library is listed, with a licence.
(cd "$bundle" && find lib -type f | sort) >"$work/files.txt"
cut -f1 "$bundle/share/doc/castaway/PARTS.tsv" | grep '^lib/' | sort | diff - "$work/files.txt" || fail "PARTS.tsv lists other libraries"
while IFS=$'\t' read -r _ package _ _ _ licence text; do
  if [ -z "$licence" ] || [ ! -s "$bundle/share/doc/castaway/$text" ]; then fail "no licence of $package"; fi
done < <(tail -n +2 "$bundle/share/doc/castaway/PARTS.tsv")

# From any folder, by a link, without HOME.
cd "$work"
mkdir bin && ln -s "$castaway" bin/castaway
env -u HOME PATH="$work/bin:$PATH" castaway scenarios >scenarios.txt
grep -qF "$bundle/share/castaway/worlds/lab/scenarios/kidnap.yaml" scenarios.txt || fail "it does not take its own data"
code=0
"$castaway" run nothing.yaml >/dev/null 2>&1 || code=$?
[ $code -eq 2 ] || fail "bad input ends with $code in place of 2"

# A localizer in Python gets the user's environment, as it was.
cat >spy.py <<'PY'
import os
import pathlib
import runpy
import sys

pathlib.Path("environment.txt").write_text("".join(f"{name}={value}\n" for name, value in sorted(os.environ.items())))
sys.path.insert(0, sys.argv[1])
runpy.run_path(sys.argv[1] + "/dead_reckoning.py", run_name="__main__")
PY
quick=(run --duration 3)
LD_LIBRARY_PATH="$work" LIBGL_DRIVERS_PATH=/of/the/user "$castaway" "${quick[@]}" --localizer mh_amcl \
  --localizer "program:python3 spy.py $source/examples/program" --out program >program.log || fail "it cannot use a program"
for line in "LD_LIBRARY_PATH=$work" "LIBGL_DRIVERS_PATH=/of/the/user"; do
  grep -qxF "$line" environment.txt || fail "a program does not get $line"
done
if grep -F "$bundle" environment.txt; then fail "a program gets variables of the bundle"; fi

# Libraries that are built here: in C; in C++ with its own libstdc++; with a C library that is newer than the bundle's.
gcc -std=c11 -O2 -shared -fPIC -I "$bundle/include" "$source/examples/library/dead_reckoning.c" -lm -o libdead.so
sed -n '/^cat > mine\/mine.cpp/,/^END$/p' "$source/docs/your-localizer.md" | sed '1d;$d' >still.cpp
g++ -std=c++17 -O2 -shared -fPIC -static-libstdc++ -static-libgcc -I "$bundle/include" still.cpp -o libstill.so
for name in dead still; do
  "$castaway" "${quick[@]}" --localizer "library:./lib$name.so" --out "library-$name" >library.log || fail "it cannot use lib$name.so"
done
"$castaway" "${quick[@]}" --localizer "program:bin/castaway serve library:./libdead.so" --out served >served.log || fail "it cannot serve"
echo 'GLIBC_2.99 { global: newer; };' >newer.map
echo 'int newer(void) { return 1; }' | gcc -x c -shared -fPIC - -Wl,-soname,libm.so.6 -Wl,--version-script=newer.map -o libnewer.so
echo 'int newer(void); int use(void) { return newer(); }' | gcc -x c -shared -fPIC - -L. -lnewer -o libtoo.so
code=0
"$castaway" "${quick[@]}" --localizer library:./libtoo.so --out too >too.log 2>&1 || code=$?
[ $code -ne 0 ] || fail "it loads a library of a newer C library"
[ "$(grep -c "GLIBC_2.99' not found.*build it on an older system" too.log)" -eq 1 ] || { cat too.log; fail "it does not say why"; }

# Workers, and pictures without the machine's renderer.
"$castaway" run --seeds 2 -j 2 --duration 3 --out seeds >seeds.log || fail "its workers fail"
"$castaway" check-robot waffle --out robot >robot.log || fail "it draws no robot"
