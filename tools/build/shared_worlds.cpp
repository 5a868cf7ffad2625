#include "tools/build/shared_worlds.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace castaway::testbed {
namespace {

std::string world_text(const WorldChoice& choice, const std::filesystem::path& base,
                       const SurveyOptions& options) {
  std::string text = fmt::format(
      "{} {} {} {} {} {} {} {} {}", choice.file, choice.search_paths,
      choice.differences.has_value(), base.string(), options.lidar_height, options.wall_height,
      options.robot_radius, options.strict, choice.levels ? static_cast<int>(*choice.levels) : -1);
  if (options.inside) text += fmt::format(" {} {}", options.inside->x(), options.inside->y());
  return text;
}

}  // namespace

std::shared_ptr<const LoadedWorld> SharedWorlds::get(const WorldChoice& choice,
                                                     const std::filesystem::path& base,
                                                     const SurveyOptions& options) {
  const std::string key = world_text(choice, base, options);
  const bool plain = !choice.differences || choice.differences->empty();
  if (auto world = plain ? worlds_.find(key) : nullptr) return world;
  auto built = std::make_shared<LoadedWorld>(build_world(choice, base, options));
  if (plain && !built->difference) {
    built->spaces = std::make_shared<sim::Spaces>();
    worlds_.keep(key, built);
  }
  return built;
}

}  // namespace castaway::testbed
