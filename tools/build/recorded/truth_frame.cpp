#include "tools/build/recorded/truth_frame.hpp"

#include <variant>

namespace castaway::testbed {
namespace {

template <typename DataFrame>
void move_truth_of(DataFrame* frame, const SE2& T_map_truth) {
  if (!frame || !frame->true_pose) return;
  frame->true_pose->T_map_base = T_map_truth * frame->true_pose->T_map_base;
}

}  // namespace

void move_truth(Frames& frames, const SE2& T_map_truth) {
  for (Frame& frame : frames) {
    move_truth_of(std::get_if<OdometryFrame>(&frame.data), T_map_truth);
    move_truth_of(std::get_if<ScanFrame>(&frame.data), T_map_truth);
  }
}

}  // namespace castaway::testbed
