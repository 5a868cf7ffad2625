#!/bin/sh
# Dead reckoning as a localizer for castaway, with nothing but a shell and awk.
#
#   castaway run --localizer mh_amcl --localizer program:examples/program/dead_reckoning.sh
#
# Every message is one line of JSON; the numbers after "pose":[ are x, y, yaw.
case $(awk -W version 2>&1 </dev/null) in
  mawk*) interactive="-W interactive" ;;  # Or it waits until its buffer is full.
esac
exec awk $interactive -v CONVFMT=%.17g '
function numbers(key, out,    at, text) {
  at = index($0, "\"" key "\":[")
  if (at == 0) return 0
  text = substr($0, at + length(key) + 4)
  return split(substr(text, 1, index(text, "]") - 1), out, ",")
}
/"type":"hello"/ { print "{\"type\":\"ready\"}"; fflush() }
/"type":"initialize"/ { known = numbers("pose", start) == 3; placed = 0 }
/"type":"odometry"/ {
  numbers("pose", odom)
  if (known && !placed) {
    c = cos(odom[3]); s = sin(odom[3])  # T_base_odom
    a = -c * odom[1] - s * odom[2]; b = s * odom[1] - c * odom[2]
    c = cos(start[3]); s = sin(start[3])  # T_map_odom = T_map_base * T_base_odom
    x = start[1] + c * a - s * b; y = start[2] + s * a + c * b; yaw = start[3] - odom[3]
    placed = 1
  }
}
/"type":"scan"/ {
  match($0, /"stamp_ns":-?[0-9]+/)
  stamp = substr($0, RSTART, RLENGTH)
  pose = ""
  if (placed) {
    pose = sprintf(",\"pose\":[%.17g,%.17g,%.17g]", x + cos(yaw) * odom[1] - sin(yaw) * odom[2],
                   y + sin(yaw) * odom[1] + cos(yaw) * odom[2], yaw + odom[3])
  }
  print "{\"type\":\"estimate\"," stamp pose "}"; fflush()
}
/"type":"bye"/ { exit }'
