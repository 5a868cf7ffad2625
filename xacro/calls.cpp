#include <algorithm>
#include <filesystem>
#include <span>
#include <stdexcept>
#include <utility>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "xacro/expander.hpp"
#include "xacro/files/xml_text.hpp"

namespace castaway::xacro {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t kMaxCallDepth = 100;
constexpr int kMaxCalls = 20000;
constexpr std::size_t kMaxIncludeDepth = 40;

std::string names_of(const std::vector<std::string>& names) {
  if (names.empty()) return "none is defined";
  const std::size_t shown = std::min<std::size_t>(names.size(), 12);
  return fmt::format("known: {}{}", fmt::join(std::span(names).first(shown), ", "),
                     shown < names.size() ? ", ..." : "");
}

}  // namespace

/// Calls a macro from the element `from`. Its scope lies within the caller's, or within its
/// namespace.
void Expander::call(const Element& from, const std::string& name, Scope& scope, TiXmlNode& to) {
  const Place place = resolve(scope, name);
  const Macro* macro = find_macro(*place.scope, place.name);
  if (macro == nullptr) {
    throw std::invalid_argument(
        fmt::format("unknown macro '{}'; {}", name, names_of(macro_names(scope))));
  }
  if (calling_.size() >= kMaxCallDepth || ++calls_ > kMaxCalls) {
    throw std::invalid_argument(
        fmt::format("the macro '{}' is called without end ({} calls, {} of them nested)", name,
                    calls_, calling_.size()));
  }
  Scope local(place.scope);
  bind_values(from, *macro, scope, local);
  bind_blocks(from, *macro, scope, local);
  calling_.push_back(name);
  const std::string here = std::exchange(file_, macro->file);
  expand_children(*macro->body, local, to);
  file_ = here;
  calling_.pop_back();
}

void Expander::bind_values(const Element& from, const Macro& macro, Scope& caller, Scope& local) {
  const bool by_call = from.ValueStr() == "xacro:call";
  for (auto* a = from.FirstAttribute(); a != nullptr; a = a->Next()) {
    const std::string name = a->Name();
    if (by_call && name == "macro") continue;
    const bool known = std::any_of(
        macro.parameters.begin(), macro.parameters.end(),
        [&](const Parameter& p) { return p.kind == Parameter::Kind::kValue && p.name == name; });
    if (!known) {
      throw std::invalid_argument(
          fmt::format("the macro '{}' has no parameter '{}'", macro.name, name));
    }
    const Value value = evaluate_in(caller, a->ValueStr());
    const auto* text = std::get_if<std::string>(&value.data);
    local.properties[name] = {a->ValueStr(), text != nullptr ? from_literal(*text) : value, false};
  }
  for (const Parameter& parameter : macro.parameters) {
    const bool given = local.properties.contains(parameter.name);
    if (parameter.kind == Parameter::Kind::kValue && !given) {
      bind_default(parameter, macro, caller, local);
    }
  }
}

void Expander::bind_default(const Parameter& parameter, const Macro& macro, Scope& caller,
                            Scope& local) {
  if (parameter.from_outside) {
    if (auto outer = property_in(caller, parameter.name)) {
      local.properties[parameter.name] = {"", *outer, false};
      return;
    }
  }
  if (!parameter.fallback) {
    throw std::invalid_argument(
        fmt::format("the macro '{}' needs {}=\"...\"", macro.name, parameter.name));
  }
  const Value value = evaluate_in(local, *parameter.fallback);
  const auto* text = std::get_if<std::string>(&value.data);
  local.properties[parameter.name] = {"", text != nullptr ? from_literal(*text) : value, false};
}

/// Binds the call's child elements, expanded in the caller's scope, to the macro's block parameters
/// in order.
void Expander::bind_blocks(const Element& from, const Macro& macro, Scope& caller, Scope& local) {
  Element given("blocks");
  expand_children(from, caller, given);
  const Element* next = given.FirstChildElement();
  for (const Parameter& parameter : macro.parameters) {
    if (parameter.kind == Parameter::Kind::kValue) continue;
    if (next == nullptr) {
      throw std::invalid_argument(fmt::format("the macro '{}' needs an element for its block '{}'",
                                              macro.name, parameter.name));
    }
    auto holder = std::make_unique<Element>("block");
    if (parameter.kind == Parameter::Kind::kBlock) {
      holder->InsertEndChild(*next);
    } else {
      *holder = *next;
    }
    Block block;
    block.holder = holder.get();
    block.owned = std::move(holder);
    block.expanded = true;
    local.blocks.insert_or_assign(parameter.name, std::move(block));
    next = next->NextSiblingElement();
  }
  if (next != nullptr) {
    throw std::invalid_argument(
        fmt::format("the macro '{}' has no block for <{}>", macro.name, next->ValueStr()));
  }
}

void Expander::include(const Element& from, Scope& scope, TiXmlNode& to) {
  allow_only(from, {"filename", "ns", "optional"});
  const std::string path = path_of_include(from, scope);
  std::error_code none;
  if (attribute(from, "optional") == "true" && !fs::exists(path, none)) return;
  const bool again = std::find(including_.begin(), including_.end(), path) != including_.end();
  if (again || including_.size() >= kMaxIncludeDepth) {
    throw std::invalid_argument(
        fmt::format("{} is included by itself: remove one of the includes", path));
  }
  const Element& root = load(path);
  Scope* target = &scope;
  const std::string name = text_in(scope, attribute(from, "ns"));
  if (!name.empty()) {
    target = (scope.namespaces[name] = std::make_unique<Scope>(&scope)).get();
  }
  including_.push_back(path);
  const std::string here = std::exchange(file_, path);
  expand_children(root, *target, to);
  file_ = here;
  including_.pop_back();
}

std::string Expander::path_of_include(const Element& from, Scope& scope) {
  must_find_ = true;
  std::string name = text_in(scope, required(from, "filename"));
  must_find_ = false;
  if (name.starts_with("file://")) name = name.substr(7);
  if (name.starts_with("package://")) {
    const std::size_t slash = std::min(name.find('/', 10), name.size());
    must_find_ = true;
    name = package_folder(name.substr(10, slash - 10)) + name.substr(slash);
    must_find_ = false;
  }
  if (name.find('*') != std::string::npos) {
    throw std::invalid_argument(
        fmt::format("'{}': wildcards are not supported; include each file separately", name));
  }
  fs::path path = name;
  if (path.is_relative()) path = fs::path(file_).parent_path() / path;
  path = path.lexically_normal();
  if (!packages_.may_read(path)) throw std::invalid_argument(packages_.refusal(path));
  return path.string();
}

const TiXmlElement& Expander::load(const std::string& path) {
  auto& document = documents_[path];
  if (!document) {
    std::error_code none;
    if (path != file_ && !fs::is_regular_file(path, none)) {
      documents_.erase(path);
      throw std::invalid_argument(fmt::format("the file {} does not exist", path));
    }
    document = parse_xml(path, read_xml_text(path));
  }
  return *document->RootElement();
}

}  // namespace castaway::xacro
