#include "tools/batch/campaign/campaign_cell.hpp"

#include <stdexcept>

#include <fmt/format.h>

#include "tools/base/bytes/sha256.hpp"

namespace castaway::testbed {
namespace {

/// Calls `take(key, value)` for each key of the grid with its value in a combination.
template <typename Take>
void each_value(const CampaignSpec& spec, int combination, Take take) {
  std::size_t below = 1;
  for (const GridKey& key : spec.grid) below *= key.values.size();
  auto rest = static_cast<std::size_t>(combination);
  for (const GridKey& key : spec.grid) {
    below /= key.values.size();
    take(key, key.values[rest / below]);
    rest %= below;
  }
}

/// The value of the drawn key `k` in a cell.
YamlNode drawn_value(const CampaignSpec& spec, const CampaignCell& cell, std::size_t k) {
  const DrawnKey& key = spec.drawn[k];
  if (spec.design.design() != Design::kIndependent) {
    return value_at(key.draw, spec.design.quantile(cell.index % spec.samples(), k));
  }
  const std::string stream = fmt::format("cell/{}/{}", cell.seed, key.path);
  localization::Rng rng = localization::substream(spec.seed, stream);
  return draw_value(key.draw, rng);
}

void set_values(const CampaignSpec& spec, int combination, CampaignCell& cell, YamlNode& scenario) {
  each_value(spec, combination, [&](const GridKey& key, const YamlNode& value) {
    put_value(scenario, key.path, value, key.where);
  });
  cell.values = combination_values(spec, combination);
  for (std::size_t k = 0; k < spec.drawn.size(); ++k) {
    const DrawnKey& key = spec.drawn[k];
    YamlNode value = drawn_value(spec, cell, k);
    cell.values.emplace_back(key.path, value_text(value));
    put_value(scenario, key.path, std::move(value), key.where);
  }
}

std::string describe_values(const CampaignCell& cell) {
  std::string text = fmt::format("seed = {}", cell.seed);
  for (const auto& [key, value] : cell.values) text += fmt::format(", {} = {}", key, value);
  return text;
}

}  // namespace

std::string value_text(const YamlNode& value) {
  std::string text = emit_yaml(value);
  for (char& c : text) c = c == '\n' ? ' ' : c;
  while (!text.empty() && text.back() == ' ') text.pop_back();
  return text;
}

std::vector<std::pair<std::string, std::string>> combination_values(const CampaignSpec& spec,
                                                                    int combination) {
  std::vector<std::pair<std::string, std::string>> values;
  each_value(spec, combination, [&](const GridKey& key, const YamlNode& value) {
    values.emplace_back(key.path, value_text(value));
  });
  return values;
}

std::uint64_t cell_seed(const CampaignSpec& spec, int index) {
  const int offset = spec.design.seed_offset(index % spec.samples());
  return spec.first_seed + static_cast<std::uint64_t>(offset);
}

CampaignCell campaign_cell(const CampaignSpec& spec, int index) {
  CampaignCell cell;
  cell.index = index;
  cell.seed = cell_seed(spec, index);
  YamlNode scenario = spec.scenario;
  try {
    set_values(spec, index / spec.samples(), cell, scenario);
    put_value(scenario, "seed", write_yaml(cell.seed), "");
    put_value(scenario, "name", write_yaml(spec.name), "");
    cell.loaded =
        read_scenario(YamlDocument(std::move(scenario)), spec.base, spec.name, spec.programs);
  } catch (const std::exception& error) {
    throw std::runtime_error(
        fmt::format("{} (cell {}: {})", error.what(), index, describe_values(cell)));
  }
  cell.name = sha256(cell.loaded.effective).substr(0, 16);
  return cell;
}

}  // namespace castaway::testbed
