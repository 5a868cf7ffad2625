/// A picture of the map with its caption.
#pragma once

#include "sim/render/renderer.hpp"
#include "tools/pictures/map_caption.hpp"
#include "tools/pictures/picture_scenes.hpp"

namespace castaway::testbed {

/// Clock and legend of a scan; the scale is still to be set.
MapCaption caption_of(const ScanRecord& record);

/// `map_scene` in the upper part of a picture of the renderer's size, beneath it clock, legend and
/// scale bar. `world.map` must be there.
sim::Image map_picture(sim::Renderer& renderer, const PictureWorld& world,
                       const sim::SceneItem& map_item, const ScanRecord& record);

}  // namespace castaway::testbed
