#!/usr/bin/env bash
# Plays scripts/gate as a CI does, in a repository that holds nothing but a user's localizer: in Python, in C++, and as a node of ROS 2.
# usage: gate_test.sh SOURCE_DIR FOLDER_OF_THE_ARCHIVE [ROS2_PEER [SUITE]]   SUITE: in a root of that Debian, from $MIRROR (as root, with mmdebstrap)
set -euo pipefail
source=$1 archive=$(echo "$2"/castaway-*.tar.zst) peer=${3:-} suite=${4:-}
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
fail() { echo "gate_test: $1" >&2; exit 1; }

root='' repository=$work/repository
mkdir "$work/repository"
if [ -n "$suite" ]; then
  root=$work/root repository=$work/root/repository
  mmdebstrap --quiet --variant=essential --include=python3,zstd "$suite" "$root" ${MIRROR:+"$MIRROR"}
  mkdir "$repository" "$root/castaway"
  cp "$archive" "$root/castaway/archive.tar.zst"
  mount -t proc proc "$root/proc"
  mount --bind /dev "$root/dev"
  trap 'umount -l "$root/proc" "$root/dev"; rm -rf "$work"' EXIT
  archive=/castaway/archive.tar.zst
fi
cp "$source/examples/program/protocol.py" "$repository"
cp "$source/scripts/gate" "$repository/castaway-gate"

# The localizers: of docs/your-localizer.md, in Python and in C++; scenarios that they pass and that they fail.
sed -n '/^cat > mine\/mine.py/,/^END$/p' "$source/docs/your-localizer.md" | sed '1d;$d' >"$repository/mine.py"
sed -n '/^cat > mine\/mine.cpp/,/^END$/p' "$source/docs/your-localizer.md" | sed '1d;$d' >"$work/mine.cpp"
g++ -std=c++17 -O2 -shared -fPIC -static-libstdc++ -static-libgcc -I "$source/include" "$work/mine.cpp" -o "$repository/mine.so"
scenario() { # NAME METRIC CONDITION
  printf 'name: %s\nworld: lab\nduration_s: 20\nevents:\n  - kidnap: {kind: teleport, at_s: 10.05, min_distance_m: 3}\n' "$1"
  printf 'localizers: [mh_amcl]\noutputs: {snapshots: false}\nexpect:\n  collisions: "== 0"\n  %s: "%s"\n' "$2" "$3"
}
scenario passes mine.tracking_error_m.mean "< 3" >"$repository/passes.yaml"
scenario fails mine.recovery.success ">= 1" >"$repository/fails.yaml"
scenario node ros2.recovery.success ">= 0" >"$repository/node.yaml"

# Runs the gate as CI does, with `kept` beside the runs of an earlier one; leaves its exit code in `code` and the page of the job in page.md.
gate() {
  [ -n "${kept:-}" ] || rm -rf "$repository/gate"
  rm -f "$repository/page.md"
  code=0
  local clean=(env -i PATH=/usr/sbin:/usr/bin:/sbin:/bin GITHUB_STEP_SUMMARY=page.md)
  if [ -n "$root" ]; then
    "${clean[@]}" chroot "$root" sh -c 'cd /repository && exec sh ./castaway-gate "$@"' gate --archive "$archive" "$@" >"$work/log" 2>&1 || code=$?
  else
    (cd "$repository" && "${clean[@]}" sh ./castaway-gate --archive "$archive" "$@") >"$work/log" 2>&1 || code=$?
  fi
}
expect() { # CODE WHAT
  [ "$code" -eq "$1" ] || { cat "$work/log" >&2; fail "$2 ends with $code in place of $1"; }
}
page() { grep -qF -- "$1" "$repository/page.md" || { cat "$repository/page.md" >&2; fail "the page of the job lacks: $1"; }; }

began=$SECONDS
gate --scenario passes.yaml --localizer mh_amcl --localizer "program:python3 mine.py" --seeds 2
expect 0 "a gate that is passed"
page "### ✅ passes"
page "2 seeds, 0 failed; 4 of 4 expectations met"
page "| mine | 0 of 2"
grep -q 'tests="6" failures="0" errors="0"' "$repository/gate/junit.xml" || fail "JUnit does not say that all is well"
for file in index.html summary.json seed-1/report.html seed-2/report.html; do [ -s "$repository/gate/$file" ] || fail "$file is missing"; done

gate --scenario fails.yaml --localizer "program:python3 mine.py" --seeds 2
expect 3 "a gate that is not passed"
page "### ❌ fails"
page "* not met: \`mine.recovery.success is 0"
page "castaway run fails.yaml --localizer 'program:python3 mine.py' --seed 1 --out look"
grep -q 'failures="2"' "$repository/gate/junit.xml" || fail "JUnit does not say what failed"
gate --scenario fails.yaml --localizer "program:python3 mine.py" --seeds 1 --fail-on runs
expect 0 "--fail-on runs"

gate --scenario fails.yaml --localizer library:./mine.so --seeds 1
expect 3 "a library's gate"
page "castaway run fails.yaml --localizer library:./mine.so --seed 1 --out look"
gate --scenario passes.yaml --localizer "program:python3 nothing/mine.py" --seeds 1
expect 1 "a localizer that breaks off"
gate --scenario passes.yaml --localizer "program:python3 mine.py" --seeds 1
kept=yes gate --scenario nothing.yaml --seeds 1 --fail-on never
expect 2 "a scenario that is not there"
[ ! -e "$repository/page.md" ] || fail "the page shows the summary of an earlier gate"

# The action's own step, as GitHub runs it.
if [ -z "$root" ] && /usr/bin/python3 -c "import yaml" 2>/dev/null; then
  /usr/bin/python3 -c "import sys, yaml; print(yaml.safe_load(open(sys.argv[1]))['runs']['steps'][0]['run'])" "$source/action.yml" >"$work/step.sh"
  rm -rf "$repository/gate" "$repository/page.md"
  code=0
  (cd "$repository" && env -i PATH=/usr/bin:/bin GITHUB_STEP_SUMMARY=page.md GITHUB_OUTPUT=outputs SCENARIO=fails.yaml SEEDS=1 OUT=gate \
    LOCALIZER=$'program:python3 mine.py\nmh_amcl\n' ARCHIVE="$archive" RELEASE=http://localhost:9/none FAIL_ON=expectations \
    ARGUMENTS="--set 'people.count=1'" GATE="$source/scripts/gate" bash -e -o pipefail "$work/step.sh") >"$work/log" 2>&1 || code=$?
  expect 3 "the action's step"
  grep -qx "exit-code=3" "$repository/outputs" || fail "the action does not say how it ended"
  page "| mh_amcl | 1 of 1"
  page "castaway run fails.yaml --localizer 'program:python3 mine.py' --localizer mh_amcl --set people.count=1 --seed 1 --out look"
fi

if [ -x "$peer" ]; then
  domain=$((RANDOM % 100 + 100))
  "$peer" --domain "$domain" >"$work/node.json" 2>&1 &
  node=$!
  gate --scenario node.yaml --localizer "ros2:$domain" --seeds 1
  wait "$node" || { cat "$work/node.json" >&2; fail "the node ended with an error"; }
  expect 0 "a node's gate"
  page "| ros2 | 1 of 1"
fi
echo "gate: all in $((SECONDS - began)) s"
