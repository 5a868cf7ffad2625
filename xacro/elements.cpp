#include <algorithm>
#include <stdexcept>
#include <utility>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "xacro/expander.hpp"
#include "xacro/files/nearest_name.hpp"
#include "xacro/files/xml_text.hpp"

namespace castaway::xacro {
namespace {

constexpr int kMaxDepth = 1000;
constexpr int kMaxElements = 200000;
constexpr std::size_t kMaxBytes = 64U << 20U;
const std::string kPrefix = "xacro:";

/// True if anything in a tree must be expanded.
bool uses_xacro(const TiXmlElement& element) {
  if (element.ValueStr().starts_with(kPrefix)) return true;
  for (auto* a = element.FirstAttribute(); a != nullptr; a = a->Next()) {
    if (std::string(a->Name()) == "xmlns:xacro" || !is_plain(a->ValueStr())) return true;
  }
  for (const TiXmlNode* n = element.FirstChild(); n != nullptr; n = n->NextSibling()) {
    if (n->ToElement() != nullptr && uses_xacro(*n->ToElement())) return true;
    if (n->ToText() != nullptr && n->ValueStr().find("${") != std::string::npos) return true;
  }
  return false;
}

}  // namespace

std::string required(const TiXmlElement& element, const char* name) {
  if (element.Attribute(name) == nullptr) {
    throw std::invalid_argument(fmt::format("needs the attribute '{}'", name));
  }
  return element.Attribute(name);
}

void allow_only(const TiXmlElement& element, const std::vector<std::string>& names) {
  for (auto* a = element.FirstAttribute(); a != nullptr; a = a->Next()) {
    if (std::find(names.begin(), names.end(), a->Name()) != names.end()) continue;
    throw std::invalid_argument(
        fmt::format("unknown attribute '{}'; known: {}", a->Name(), fmt::join(names, ", ")));
  }
}

Expander::Expander(const PackageFinder& packages, const Options& options)
    : packages_(packages), options_(options), arguments_(options.arguments) {}

Expansion Expander::run(const std::string& path) {
  file_ = path;
  const Element& root = load(path);
  if (root.ValueStr() != "robot" && root.ValueStr() != "sdf") {
    throw std::runtime_error(
        fmt::format("{}:{}: not a URDF or xacro file: its root element must be <robot>, not <{}>",
                    path, root.Row(), root.ValueStr()));
  }
  Expansion result;
  result.xml = std::make_unique<TiXmlDocument>();
  if (!uses_xacro(root)) {
    require_known_arguments();
    result.xml->InsertEndChild(root);
    return result;
  }
  including_ = {path};
  Scope globals(nullptr);
  expand_element(root, globals, *result.xml);
  require_known_arguments();
  result.xml->RootElement()->RemoveAttribute("xmlns:xacro");
  result.warnings = std::move(warnings_);
  return result;
}

/// Throws on unknown arguments: a misspelt one would silently keep its default.
void Expander::require_known_arguments() const {
  const std::vector<std::string> known(known_arguments_.begin(), known_arguments_.end());
  for (const auto& [name, value] : options_.arguments) {
    if (known_arguments_.contains(name)) continue;
    throw std::runtime_error(
        known.empty()
            ? fmt::format("{}: takes no argument '{}': it has no <xacro:arg>", file_, name)
            : fmt::format("{}: has no argument '{}'; {}", file_, name, name_hint(name, known)));
  }
}

void Expander::expand_children(const TiXmlNode& from, Scope& scope, TiXmlNode& to) {
  for (const TiXmlNode* node = from.FirstChild(); node != nullptr; node = node->NextSibling()) {
    if (const auto* element = node->ToElement()) {
      expand_element(*element, scope, to);
    } else if (const auto* text = node->ToText()) {
      TiXmlText copied(text_in(scope, text->ValueStr()));
      copied.SetCDATA(text->CDATA());
      bytes_ += copied.ValueStr().size();
      to.InsertEndChild(copied);
    }
  }
}

/// Adds the position of the innermost element that an error comes from.
void Expander::expand_element(const Element& from, Scope& scope, TiXmlNode& to) {
  const std::string file = file_;
  try {
    if (++depth_ > kMaxDepth) {
      throw std::invalid_argument(
          fmt::format("nested deeper than {}: does a macro or an include repeat itself?", depth_));
    }
    count(from);
    const bool xacro = from.ValueStr().starts_with(kPrefix);
    xacro ? dispatch(from, scope, to) : copy(from, scope, to);
    --depth_;
  } catch (const std::invalid_argument& error) {
    throw std::runtime_error(
        fmt::format("{}:{}: <{}>: {}", file, from.Row(), from.ValueStr(), error.what()));
  }
}

/// Counts an element and throws if the output grows too large.
void Expander::count(const Element& output) {
  for (auto* a = output.FirstAttribute(); a != nullptr; a = a->Next()) {
    bytes_ += a->ValueStr().size();
  }
  if (++elements_ <= kMaxElements && bytes_ <= kMaxBytes) return;
  throw std::invalid_argument(
      fmt::format("more than {} elements or {} MiB: does a macro repeat itself?", kMaxElements,
                  kMaxBytes >> 20U));
}

void Expander::count_tree(const TiXmlNode& output) {
  if (output.ToText() != nullptr) bytes_ += output.ValueStr().size();
  if (output.ToElement() != nullptr) count(*output.ToElement());
  for (auto* node = output.FirstChild(); node != nullptr; node = node->NextSibling()) {
    count_tree(*node);
  }
}

void Expander::copy(const Element& from, Scope& scope, TiXmlNode& to) {
  Element shell(from.ValueStr());
  for (auto* a = from.FirstAttribute(); a != nullptr; a = a->Next()) {
    const std::string text = text_in(scope, a->ValueStr());
    bytes_ += text.size();
    shell.SetAttribute(a->NameTStr(), text);
  }
  expand_children(from, scope, *to.InsertEndChild(shell));
}

void Expander::dispatch(const Element& from, Scope& scope, TiXmlNode& to) {
  const std::string name = from.ValueStr().substr(kPrefix.size());
  if (name == "property") return define_property(from, scope);
  if (name == "arg") return define_argument(from, scope);
  if (name == "macro") return define_macro(from, scope);
  if (name == "include") return include(from, scope, to);
  if (name == "if") return choose(from, scope, to, true);
  if (name == "unless") return choose(from, scope, to, false);
  if (name == "insert_block") return insert_block(from, scope, to);
  if (name == "call") return call(from, text_in(scope, required(from, "macro")), scope, to);
  if (name == "element" || name == "attribute") {
    throw std::invalid_argument("is not supported: write the element as it is");
  }
  call(from, name, scope, to);
}

void Expander::choose(const Element& from, Scope& scope, TiXmlNode& to, bool wanted) {
  allow_only(from, {"value"});
  if (condition(evaluate_in(scope, required(from, "value"))) == wanted) {
    expand_children(from, scope, to);
  }
}

void Expander::insert_block(const Element& from, Scope& scope, TiXmlNode& to) {
  allow_only(from, {"name"});
  const std::string name = text_in(scope, required(from, "name"));
  const Block* block = find_block(scope, name);
  if (block == nullptr) {
    throw std::invalid_argument(fmt::format(
        "no block '{0}': give the macro a parameter *{0}, or define a property with content",
        name));
  }
  if (!block->expanded) {
    const std::string here = std::exchange(file_, block->file);
    expand_children(*block->holder, scope, to);
    file_ = here;
    return;
  }
  for (auto* node = block->holder->FirstChild(); node != nullptr; node = node->NextSibling()) {
    count_tree(*node);
    to.InsertEndChild(*node);
  }
}

Expansion expand(const std::string& path, const PackageFinder& packages, const Options& options,
                 const std::string& root) {
  Expansion expansion = Expander(packages, options).run(path);
  const TiXmlElement& found = *expansion.xml->RootElement();
  if (found.ValueStr() == root) return expansion;
  throw std::runtime_error(
      fmt::format("{}:{}: not a URDF or xacro file: its root element must be <{}>, not <{}>", path,
                  found.Row(), root, found.ValueStr()));
}

}  // namespace castaway::xacro
