/// Which part of a map's free space a run is about.
#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include <Eigen/Core>

#include "sim/map/grid.hpp"

namespace castaway::sim {

/// A part of the free space, and why it was chosen.
struct FreeChoice {
  enum class Reason : std::uint8_t {
    kOnly,      ///< There is no other of a tenth of its area.
    kStart,     ///< The start lies in it.
    kEnclosed,  ///< The largest that does not touch the grid's edge.
    kLargest,   ///< The largest; it touches the edge, but nothing sizeable is enclosed.
  };

  Grid grid;  ///< Free cells of other parts are unknown; as given if the largest part was chosen.
  Reason reason = Reason::kOnly;
  double area = 0.0;        ///< [m^2] Where a disc's middle can be, of the part chosen...
  double other_area = 0.0;  ///< ...and of the largest other part.
  bool at_edge = false;     ///< The part chosen touches the grid's edge.
};

/// Chooses among the parts in which a disc of `radius` [m] can move about: the one that `start`
/// [m] lies in or, nearer than `radius`, beside; else the largest that does not touch the grid's
/// edge. One at the edge is taken all the same if it is ten times as large as any enclosed one, and
/// either holds less than half of the edge's cells, or none of 10 m^2 is enclosed, not even for a
/// robot of twice the radius, to which gaps in walls are closed. Linear in the cells.
FreeChoice choose_free(const Grid& grid, double radius,
                       const std::optional<Eigen::Vector2d>& start);

/// The choice in words, for a warning; nothing where there was none to make.
std::optional<std::string> describe(const FreeChoice& choice);

}  // namespace castaway::sim
