#include "tools/scenario/yaml/settings.hpp"

#include <algorithm>

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace castaway::testbed {
namespace {

std::string text_of(const YamlNode& value) {
  std::string text = emit_yaml(value);
  text.erase(text.find_last_not_of('\n') + 1);
  return text == "~" ? "" : text;
}

}  // namespace

bool Settings::check(const Setting& about) {
  const auto found = map_->find(about.key);
  if (found) found->require_in(about.range, about.unit);
  return found.has_value();
}

bool Settings::describe(const Setting& about, const YamlNode& value) {
  texts_->push_back(
      {prefix_ + about.key, text_of(value), range_text(about.range), about.unit, about.what});
  return false;
}

bool Settings::choose(const Setting& about, std::size_t& index,
                      const std::vector<std::string>& allowed) {
  if (texts_ != nullptr) {
    texts_->push_back({prefix_ + about.key, allowed[index],
                       fmt::format("{}", fmt::join(allowed, ", ")), about.unit, about.what});
    return false;
  }
  if (!map_) return false;
  const bool given = map_->has(about.key);
  if (!given && !fills_) return false;
  const std::string name = map_->choice(about.key, allowed[index], allowed);
  index =
      static_cast<std::size_t>(std::find(allowed.begin(), allowed.end(), name) - allowed.begin());
  return given;
}

bool Settings::choice(const Setting& about, std::string& value,
                      const std::vector<std::string>& names) {
  const auto present = std::find(names.begin(), names.end(), value);
  auto index = static_cast<std::size_t>(present - names.begin());
  const bool given = choose(about, index, names);
  value = names[index];
  return given;
}

void Settings::form(const Setting& about, const std::string& value) {
  if (texts_ != nullptr) describe(about, yaml_scalar(value));
}

Settings Settings::group(const std::string& key) {
  if (texts_ != nullptr) return {*texts_, prefix_ + key + "."};
  if (!map_ || (!fills_ && !map_->has(key))) return {};
  return {map_->child(key), fills_};
}

bool Settings::has(const std::string& key) { return texts_ != nullptr || (map_ && map_->has(key)); }

void Settings::fail(const std::string& message) const {
  if (map_) map_->fail(message);
  throw std::runtime_error(message);
}

}  // namespace castaway::testbed
