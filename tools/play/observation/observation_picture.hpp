/// Observations as one image.
#pragma once

#include <vector>

#include "sim/scene/image.hpp"
#include "tools/play/observation/observation_scene.hpp"

namespace castaway::testbed {

/// Size of a panel.
struct PanelSize {
  int width = 1200;  ///< [px]
  int height = 600;  ///< [px]
};

/// Images of one width, one above the other, with white lines of `gap` px between them.
sim::Image stack_images(const std::vector<sim::Image>& images, int gap);

/// Draws each observation in a panel of its own, the first at the top. Throws std::runtime_error
/// if EGL is not available.
sim::Image observation_picture(const std::vector<Observation>& observations, double reach,
                               const PanelSize& size);

}  // namespace castaway::testbed
