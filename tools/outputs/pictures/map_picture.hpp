/// An image of the map with its caption.
#pragma once

#include "sim/render/renderer.hpp"
#include "tools/outputs/pictures/map_caption.hpp"
#include "tools/outputs/pictures/picture_scenes.hpp"

namespace castaway::testbed {

/// Clock and legend of a scan; the caller sets the scale.
MapCaption caption_of(const ScanRecord& record);

/// Renders `map_scene` in the upper part of an image of the renderer's size, with the caption
/// below. Precondition: `world.map` is set.
sim::Image map_picture(sim::Renderer& renderer, const PictureWorld& world,
                       const sim::SceneItem& map_item, const ScanRecord& record);

}  // namespace castaway::testbed
