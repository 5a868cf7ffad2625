/// Chooses the part of a map's free space that a run takes place in.
#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include <Eigen/Core>

#include "sim/map/grid.hpp"

namespace castaway::sim {

/// The chosen part of the free space, and the reason.
struct FreeChoice {
  enum class Reason : std::uint8_t {
    kOnly,      ///< No other part has a tenth of its area.
    kStart,     ///< The start lies in it.
    kEnclosed,  ///< It is the largest that does not touch the grid's edge.
    /// It is the largest; it touches the edge, but no part of relevant size is enclosed.
    kLargest,
  };

  Grid grid;  ///< Free cells of other parts are unknown. Unchanged if the largest part was chosen.
  Reason reason = Reason::kOnly;
  double area = 0.0;        ///< [m^2] Of the chosen part, for a disc's centre.
  double other_area = 0.0;  ///< [m^2] Of the largest other part.
  bool at_edge = false;     ///< The chosen part touches the grid's edge.
};

/// Chooses among the parts in which a disc of `radius` [m] can move. With `start` [m], it is the
/// part that contains it or is nearer to it than `radius`; otherwise the largest part that does not
/// touch the grid's edge. A part at the edge is chosen nevertheless if it is ten times as large as
/// any enclosed one and holds less than half of the edge's cells, or if no enclosed part has 10
/// m^2, even for a robot of twice the radius, for which gaps in walls are closed. Linear in the
/// number of cells.
FreeChoice choose_free(const Grid& grid, double radius,
                       const std::optional<Eigen::Vector2d>& start);

/// Describes the choice for a warning; nothing if there was nothing to choose.
std::optional<std::string> describe(const FreeChoice& choice);

}  // namespace castaway::sim
