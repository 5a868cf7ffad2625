#include "tools/build/scene/person_model.hpp"

#include <cmath>

#include <nlohmann/json.hpp>

#include "sim/people/bodies/person_visuals.hpp"
#include "sim/scene/primitives.hpp"
#include "tools/build/scene/merged_mesh.hpp"

namespace castaway::testbed {
namespace {

using PersonJson = nlohmann::ordered_json;
using Items = std::vector<sim::SceneItem>;

constexpr double kNearRoundness = 0.75;  // Roundness: a crowd is drawn many times a second.
constexpr double kFarRoundness = 0.4;
constexpr int kClothes = 18;  // Combinations of coat and trousers.

/// Items of `person_visuals`, by their order there.
enum Part { kShoe = 0, kShin = 1, kThigh = 3, kCoat = 8, kHead = 12, kEnd = 14 };

/// A person with both feet below the middle.
Items items_of(int number, double roundness = 1.0) {
  return sim::person_visuals({}, {}, number, roundness);
}

Items slice(const Items& items, Part begin, Part end) {
  return {items.begin() + begin, items.begin() + end};
}

PersonJson color_json(const Eigen::Vector3f& color) { return {color.x(), color.y(), color.z()}; }

/// A mesh of the items, whose colours are relative to `white`.
PersonJson part_json(Items items, const Eigen::Vector3f& white = Eigen::Vector3f::Ones()) {
  for (sim::SceneItem& item : items) item.color = item.color.cwiseQuotient(white);
  return mesh_json(merge_items(items));
}

/// A cylinder that stands on z = 0.
PersonJson thigh_json(double roundness) {
  sim::SceneItem thigh;
  thigh.mesh = sim::cylinder_mesh(static_cast<float>(sim::PersonBody{}.leg_radius), 1.0F,
                                  static_cast<int>(std::lround(16.0 * roundness)));
  thigh.T_map_mesh.translation().z() = 0.5F;
  return part_json({thigh});
}

PersonJson parts_json(double roundness) {
  const Items items = items_of(0, roundness);
  return {{"shoe", part_json(slice(items, kShoe, kShin))},
          {"shin", part_json(slice(items, kShin, kThigh), items[kShin].color)},
          {"thigh", thigh_json(roundness)},
          {"coat", part_json(slice(items, kCoat, kHead), items[kCoat].color)},
          {"head", part_json(slice(items, kHead, kEnd))}};
}

PersonJson body_json(const sim::PersonBody& body) { return {body.height, body.leg_radius}; }

}  // namespace

PersonJson person_json(const std::vector<sim::PersonBody>& bodies) {
  PersonJson json = {{"near", parts_json(kNearRoundness)},
                     {"far", parts_json(kFarRoundness)},
                     {"clothes", PersonJson::array()},
                     {"bodies", PersonJson::array()},
                     {"body", body_json({})},
                     {"torso_bottom", sim::kTorsoBottom},
                     {"head_height", sim::kHeadHeight},
                     {"hip", sim::kHipHeight},
                     {"hip_side", sim::kHipSide},
                     {"foot_side", sim::kFootSpread}};
  for (int number = 0; number < kClothes; ++number) {
    const Items dressed = items_of(number);
    json["clothes"].push_back({color_json(dressed[kCoat].color), color_json(dressed[kShin].color)});
  }
  for (const sim::PersonBody& body : bodies) json["bodies"].push_back(body_json(body));
  return json;
}

}  // namespace castaway::testbed
