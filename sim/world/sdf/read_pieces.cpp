#include "sim/world/sdf/read_pieces.hpp"

#include <algorithm>
#include <filesystem>
#include <iostream>
#include <memory>
#include <sstream>
#include <stdexcept>
#include <vector>

#include <fmt/format.h>

#include "sim/world/sdf/scenery.hpp"

namespace castaway::sim {
namespace {

void copy_values(const sdf::Element& from, sdf::Element& to) {
  to.SetName(from.GetName());
  to.SetRequired(from.GetRequired());
  to.SetCopyChildren(from.GetCopyChildren());
  to.SetReferenceSDF(from.ReferenceSDF());
  for (const sdf::ParamPtr& a : from.GetAttributes()) {
    to.AddAttribute(a->GetKey(), a->GetTypeName(), a->GetDefaultAsString(), a->GetRequired());
  }
  const sdf::ParamPtr value = from.GetValue();
  if (!value) return;
  to.AddValue(value->GetTypeName(), value->GetDefaultAsString(), value->GetRequired());
}

sdf::ElementPtr copy_needed(const sdf::Element& description) {
  auto copy = std::make_shared<sdf::Element>();
  copy_values(description, *copy);
  for (unsigned i = 0; i < description.GetElementDescriptionCount(); ++i) {
    const sdf::ElementPtr child = description.GetElementDescription(i);
    if (!is_unneeded(child->GetName())) copy->AddElementDescription(copy_needed(*child));
  }
  return copy;
}

namespace fs = std::filesystem;

constexpr std::size_t kAtATime = 50;
constexpr std::size_t kMostPieces = 10'000;  // libsdformat takes 1 to 2 ms for each.
constexpr std::size_t kMostLinked = 500;     // Takes about 1.5 GB in libsdformat.

/// Suppresses std::cerr, to which libsdformat prints what it also returns as errors.
class Silence {
 public:
  Silence() : cerr_(std::cerr.rdbuf(nowhere_.rdbuf())) {}
  ~Silence() { std::cerr.rdbuf(cerr_); }
  Silence(const Silence&) = delete;
  Silence& operator=(const Silence&) = delete;

 private:
  std::ostringstream nowhere_;
  std::streambuf* cerr_;
};

std::string one_line(std::string text) {
  std::replace(text.begin(), text.end(), '\n', ' ');
  if (text.size() > 400) text = text.substr(0, 400) + "...";
  return text;
}

sdf::ParserConfig quiet_config(const ResourceFinder& finder, const fs::path& folder) {
  sdf::Console::Instance()->SetQuiet(true);
  sdf::ParserConfig config;
  config.SetWarningsPolicy(sdf::EnforcementPolicy::LOG);
  config.SetUnrecognizedElementsPolicy(sdf::EnforcementPolicy::LOG);
  config.SetDeprecatedElementsPolicy(sdf::EnforcementPolicy::LOG);
  config.SetFindCallback([&finder, folder](const std::string& uri) {
    return finder.model_file(finder.find(uri, folder)).string();
  });
  return config;
}

void throw_first(const sdf::Errors& errors) {
  if (!errors.empty()) throw std::runtime_error(one_line(errors.front().Message()));
}

/// Masses are not needed, and wrong ones would be errors.
void remove_masses(const sdf::ElementPtr& parent) {
  std::vector<sdf::ElementPtr> masses;
  for (sdf::ElementPtr e = parent->GetFirstElement(); e; e = e->GetNextElement()) {
    if (e->GetName() == "inertial") {
      masses.push_back(e);
    } else {
      remove_masses(e);
    }
  }
  for (const sdf::ElementPtr& mass : masses) parent->RemoveChild(mass);
}

class Reader {
 public:
  Reader(const WorldPieces& world, const std::string& path, const ResourceFinder& finder,
         const PiecePolicy& policy, SdfBodies& bodies)
      : world_(world),
        path_(path),
        policy_(policy),
        bodies_(bodies),
        config_(quiet_config(finder, fs::absolute(path).parent_path())) {}

  void read(std::size_t begin, std::size_t end) {
    if (begin == end) return;
    const std::unique_ptr<sdf::Root> root = load(begin, end);
    if (root) {
      bodies_.add(*root->WorldByIndex(0));
    } else if (end - begin > 1) {
      const std::size_t middle = begin + (end - begin) / 2;
      read(begin, middle);
      read(middle, end);
    }
  }

 private:
  /// Reads the pieces [begin, end); nullptr if one cannot be read.
  std::unique_ptr<sdf::Root> load(std::size_t begin, std::size_t end) {
    const std::string& name = world_.pieces[begin].name;
    try {
      return parse(sdf_text(world_, begin, end));
    } catch (const std::exception& error) {
      if (end - begin > 1) return nullptr;
      if (policy_.strict) {
        throw std::runtime_error(fmt::format("{}: {}: {}", path_, name, error.what()));
      }
      policy_.notes->leave_out(name, error);
      return nullptr;
    }
  }

  /// Reads a world. libsdformat throws types that are no std::exception; here they become one.
  std::unique_ptr<sdf::Root> parse(const std::string& text) const {
    try {
      return parse_unguarded(text);
    } catch (const std::exception&) {
      throw;
    } catch (const sdf::Exception& error) {
      throw std::runtime_error(one_line("libsdformat fails on it: " + error.GetErrorStr()));
    } catch (...) {
      throw std::runtime_error("libsdformat fails on it");
    }
  }

  std::unique_ptr<sdf::Root> parse_unguarded(const std::string& text) const {
    const sdf::SDFPtr tree = empty_sdf();
    sdf::Errors errors;
    const bool read = sdf::readString(text, config_, tree, errors);
    throw_first(errors);
    if (!read) throw std::runtime_error("it is not SDF");
    remove_masses(tree->Root());
    auto root = std::make_unique<sdf::Root>();
    throw_first(root->Load(tree, config_));
    return root;
  }

  const WorldPieces& world_;
  const std::string& path_;
  const PiecePolicy& policy_;
  SdfBodies& bodies_;
  sdf::ParserConfig config_;
  Silence silence_;
};

}  // namespace

sdf::SDFPtr empty_sdf() {
  static const sdf::ElementPtr elements = [] {
    auto all = std::make_shared<sdf::SDF>();
    sdf::init(all);
    return copy_needed(*all->Root());
  }();
  auto tree = std::make_shared<sdf::SDF>();
  tree->Root(elements->Clone());
  return tree;
}

void read_pieces(const WorldPieces& world, const std::string& path, const ResourceFinder& finder,
                 const PiecePolicy& policy, SdfBodies& bodies) {
  const std::size_t count = world.pieces.size();
  if (world.linked && count > kMostLinked) {
    throw std::runtime_error(
        fmt::format("{}: {} models that are placed relative to each other: at most {} are read; "
                    "give them poses in the world's frame",
                    path, count, kMostLinked));
  }
  if (count > kMostPieces) {
    throw std::runtime_error(
        fmt::format("{}: {} models: at most {} are read; join those that stand still, as links of "
                    "one static model",
                    path, count, kMostPieces));
  }
  const std::size_t step = world.linked ? kMostLinked : kAtATime;
  Reader reader(world, path, finder, policy, bodies);
  for (std::size_t begin = 0; begin < count; begin += step) {
    reader.read(begin, std::min(begin + step, count));
  }
}

}  // namespace castaway::sim
