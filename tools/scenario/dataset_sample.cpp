#include "tools/scenario/dataset_sample.hpp"

#include <stdexcept>

#include <fmt/format.h>

namespace castaway::testbed {
namespace {

/// YAML of a value on one line.
std::string brief(const YamlNode& value) {
  std::string text = emit_yaml(value);
  for (char& c : text) c = c == '\n' ? ' ' : c;
  while (!text.empty() && text.back() == ' ') text.pop_back();
  return text;
}

/// The drawn values whose keys an error mentions, or else all of them.
std::string suspect_values(const SampledSequence& sequence, const std::string& error) {
  std::string named;
  std::string all;
  for (const auto& [key, value] : sequence.drawn) {
    const std::string text = fmt::format("{} = {}", key, value);
    const std::string last = key.substr(key.find_last_of('.') + 1);
    if (error.find(text) != std::string::npos) return "";
    if (error.find("'" + last + "'") != std::string::npos) {
      named += (named.empty() ? "" : ", ") + text;
    }
    all += (all.empty() ? "" : ", ") + text;
  }
  return named.empty() ? all : named;
}

}  // namespace

std::string sequence_name(int index) { return fmt::format("{:06d}", index); }

std::string sequence_error(const DatasetSpec& spec, const SampledSequence& sequence,
                           const std::string& what) {
  const std::string name = fmt::format("sequence {}:", sequence.index);
  if (what.find(name) != std::string::npos) return what;
  const std::string drawn = suspect_values(sequence, what);
  return fmt::format("{}: {} {}{}", spec.file, name, what,
                     drawn.empty() ? "" : " (drawn: " + drawn + ")");
}

SampledSequence sample_sequence(const DatasetSpec& spec, int index) {
  const std::string stream = fmt::format("sequence/{}", index);
  SampledSequence sequence;
  sequence.index = index;
  sequence.seed = localization::substream(spec.seed, stream)() >> 11U;
  YamlNode scenario = spec.scenario;
  try {
    for (const VariedKey& key : spec.vary) {
      localization::Rng rng = localization::substream(spec.seed, stream + "/" + key.path);
      YamlNode value = draw_value(key.draw, rng);
      const std::string text = brief(value);
      sequence.drawn.emplace_back(key.path, text);
      put_value(scenario, key.path, std::move(value),
                fmt::format("{}: sequence {}: {} = {}", key.where, index, key.path, text));
    }
    put_value(scenario, "seed", write_yaml(sequence.seed), "");
    put_value(scenario, "name", write_yaml(spec.name + "-" + sequence_name(index)), "");
    sequence.loaded =
        read_scenario(YamlDocument(std::move(scenario)), spec.base, spec.name, spec.programs);
  } catch (const std::exception& error) {
    throw std::runtime_error(sequence_error(spec, sequence, error.what()));
  }
  return sequence;
}

}  // namespace castaway::testbed
