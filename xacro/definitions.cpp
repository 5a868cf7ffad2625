#include <filesystem>
#include <stdexcept>

#include <fmt/format.h>

#include "xacro/expander.hpp"
#include "xacro/files/xml_text.hpp"
#include "xacro/substitution.hpp"

namespace castaway::xacro {
namespace {

/// The scope that the attribute `scope` of a property refers to.
Scope& scope_of(const TiXmlElement& from, Scope& here) {
  const std::string which = attribute(from, "scope");
  if (which.empty() || which == "local") return here;
  Scope* scope = &here;
  if (which == "parent") return here.parent != nullptr ? *here.parent : here;
  if (which != "global") {
    throw std::invalid_argument(fmt::format("scope='{}': use local, parent or global", which));
  }
  while (scope->parent != nullptr) scope = scope->parent;
  return *scope;
}

void require_name(const std::string& name) {
  if (!name.empty() && name.find_first_of(" \t\n${}()") == std::string::npos) return;
  throw std::invalid_argument(fmt::format("'{}' is not a valid name", name));
}

}  // namespace

void Expander::define_property(const Element& from, Scope& scope) {
  allow_only(from, {"name", "value", "default", "scope", "lazy_eval", "remove"});
  const std::string name = text_in(scope, required(from, "name"));
  require_name(name);
  Scope& target = scope_of(from, scope);
  const char* value = from.Attribute("value");
  const char* fallback = from.Attribute("default");
  if (fallback != nullptr && value == nullptr) {
    if (find_property(target, name).scope != nullptr) return;
    value = fallback;
  }
  if (attribute(from, "remove") == "true") {
    target.properties.erase(name);
    target.blocks.erase(name);
  } else if (value == nullptr) {
    Block block;
    block.holder = &from;
    block.file = file_;
    target.blocks.insert_or_assign(name, std::move(block));
  } else if (&target != &scope || attribute(from, "lazy_eval") == "false") {
    const Value now = evaluate_in(scope, value);
    const auto* text = std::get_if<std::string>(&now.data);
    target.properties[name] = {value, text != nullptr ? from_literal(*text) : now, false};
  } else {
    target.properties[name] = {value, std::nullopt, false};
  }
}

void Expander::define_argument(const Element& from, Scope& scope) {
  allow_only(from, {"name", "default"});
  const std::string name = required(from, "name");
  require_name(name);
  known_arguments_.insert(name);
  const char* fallback = from.Attribute("default");
  if (fallback != nullptr && !arguments_.contains(name)) {
    arguments_[name] = text_in(scope, fallback);
  }
}

void Expander::define_macro(const Element& from, Scope& scope) {
  allow_only(from, {"name", "params"});
  std::string name = required(from, "name");
  if (name.starts_with("xacro:")) name = name.substr(6);
  // A name with an expression can never be called.
  if (name.find("${") == std::string::npos) require_name(name);
  if (name.find('.') != std::string::npos) {
    throw std::invalid_argument(
        fmt::format("'{}': the name of a macro must not contain a dot", name));
  }
  scope.macros[name] = {name, parse_parameters(attribute(from, "params")), &from, file_};
}

Value Expander::evaluate_in(Scope& scope, const std::string& text) {
  if (is_plain(text)) return {text};
  TextContext context;
  context.surroundings.property = [&](const std::string& name) { return property_in(scope, name); };
  context.surroundings.function = [&](const std::string& name, const List& arguments) {
    return function(name, arguments);
  };
  context.substitute = [&](const std::string& command) {
    return substitute(
        command, {&arguments_, [this](const std::string& name) { return package_folder(name); },
                  std::filesystem::path(file_).parent_path().string(),
                  [this](const std::string& name) { known_arguments_.insert(name); }});
  };
  return evaluate_text(text, context);
}

std::string Expander::text_in(Scope& scope, const std::string& text) {
  return is_plain(text) ? text : to_text(evaluate_in(scope, text));
}

/// Evaluates a property's text once, in the scope that contains it.
std::optional<Value> Expander::property_in(Scope& scope, const std::string& name) {
  const Place place = find_property(scope, name);
  if (place.scope == nullptr) return std::nullopt;
  Property& property = place.scope->properties.at(place.name);
  if (property.value) return property.value;
  if (property.evaluating) {
    throw std::invalid_argument(fmt::format("the property '{}' depends on itself", name));
  }
  property.evaluating = true;
  Value value = evaluate_in(*place.scope, property.text);
  property.evaluating = false;
  if (const auto* text = std::get_if<std::string>(&value.data)) value = from_literal(*text);
  property.value = value;
  return value;
}

std::string Expander::package_folder(const std::string& name) {
  if (const auto folder = packages_.find(name)) return folder->string();
  const std::string what = fmt::format(
      "the package '{}' is not found: name the folder above it with --search-path or in "
      "CASTAWAY_PACKAGE_PATH",
      name);
  if (must_find_) throw std::invalid_argument(what);
  if (missing_packages_.insert(name).second) warnings_.push_back(what);
  return "$(find " + name + ")";
}

namespace {

/// Reads a YAML file whose path is relative to that of `file`.
Value load_yaml(std::filesystem::path path, const std::string& file, const PackageFinder& packages,
                const Options& options) {
  if (!options.read_yaml) {
    throw std::invalid_argument("xacro.load_yaml is not supported here: write the values out");
  }
  if (path.is_relative()) path = std::filesystem::path(file).parent_path() / path;
  if (!packages.may_read(path)) throw std::invalid_argument(packages.refusal(path));
  try {
    return check_size(options.read_yaml(path.lexically_normal().string()));
  } catch (const std::runtime_error& error) {
    throw std::invalid_argument(fmt::format("load_yaml: {}", error.what()));
  }
}

}  // namespace

std::optional<Value> Expander::function(const std::string& name, const List& arguments) {
  const std::string first = arguments.empty() ? "" : to_text(arguments[0]);
  if (name == "error" || name == "fatal") {
    throw std::invalid_argument("the file says: " + first);
  }
  if (name == "warning" || name == "message") {
    warnings_.push_back(fmt::format("{} says: {}", file_, first));
    return Value{std::string()};
  }
  if (name == "load_yaml") return load_yaml(first, file_, packages_, options_);
  return std::nullopt;
}

}  // namespace castaway::xacro
