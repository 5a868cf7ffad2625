#!/usr/bin/env bash
# Builds castaway with colcon, and after it a package that depends on it, and runs both from the workspace.
# usage: colcon_test.sh BUILD_DIR SOURCE_DIR COMPILER   (castaway's own build goes beside BUILD_DIR, as deep as it: so ccache knows it)
set -euo pipefail
build=$1 source=$2 compiler=$3
beside=$(dirname "$build")
work=$(mktemp -d)
trap 'rm -rf "$work" "$beside/castaway" "$beside/castaway_user"' EXIT
unset CASTAWAY_DATA

fail() { echo "colcon_test: $1" >&2; exit 1; }
cached() { sed -n "s/^$1:[A-Z]*=//p" "$build/CMakeCache.txt"; }

mkdir "$work/src"
cp -r "$source/examples/embed" "$work/src/castaway_user"
cat >"$work/src/castaway_user/package.xml" <<'XML'
<package format="3">
  <name>castaway_user</name>
  <version>0.0.0</version>
  <description>A robot's program that carries castaway::localization.</description>
  <maintainer email="nobody@example.org">nobody</maintainer>
  <license>Apache-2.0</license>
  <depend>castaway</depend>
  <export><build_type>cmake</build_type></export>
</package>
XML
echo 'install(TARGETS embed)' >>"$work/src/castaway_user/CMakeLists.txt"

cd "$work"
colcon list --base-paths "$source" src | cut -f1,3 | diff - <(printf 'castaway\t(ros.cmake)\ncastaway_user\t(ros.cmake)\n') ||
  fail "colcon takes them for other packages"
colcon --log-base log build --base-paths "$source" src --build-base "$beside" --executor sequential --cmake-args -G Ninja \
  "-DCMAKE_CXX_COMPILER=$compiler" "-DCASTAWAY_WERROR=$(cached CASTAWAY_WERROR)" -DCASTAWAY_WEB=OFF \
  "-DCASTAWAY_ROS2=$(cached CASTAWAY_ROS2)" "-DCMAKE_POSITION_INDEPENDENT_CODE=$(cached CASTAWAY_PYTHON)" >colcon.log 2>&1 ||
  { tail -n 40 colcon.log; fail "colcon build fails"; }
grep -q '^CMAKE_BUILD_TYPE:STRING=Release$' "$beside/castaway/CMakeCache.txt" || fail "the build is no release"
[ ! -e "$beside/castaway/tests" ] || fail "it builds tests that nobody asked for"

set +u
. install/setup.bash
set -u
[ "$(command -v castaway)" = "$work/install/castaway/bin/castaway" ] || fail "the workspace's castaway is not on the PATH"
cmp "$source/package.xml" install/castaway/share/castaway/package.xml || fail "package.xml is not installed"
castaway run --duration 2 --set outputs.snapshots=false --out run >run.log
[ -s run/summary.json ] || fail "the workspace's castaway left no summary.json"
embed | tail -1 | grep -qx "found itself" || fail "the package that depends on castaway does not find itself"
