/// Names that are known at a place of a xacro file.
#pragma once

#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include <tinyxml.h>

#include "sim/xacro/parameters.hpp"
#include "sim/xacro/value.hpp"

namespace castaway::sim::xacro {

/// A property. Its text is evaluated when it is first asked for.
struct Property {
  std::string text;
  std::optional<Value> value;  ///< Nothing: not yet evaluated.
  bool evaluating = false;     ///< To find those that are defined by themselves.
};

/// A block: the children of an element.
struct Block {
  std::unique_ptr<const TiXmlElement> owned;  ///< Of macros' blocks; else the file owns it.
  const TiXmlElement* holder = nullptr;       ///< Whose children it is.
  bool expanded = false;  ///< False: a property's block, expanded where it is put in.
  std::string file;       ///< Where it stands.
};

/// A macro.
struct Macro {
  std::string name;
  std::vector<Parameter> parameters;
  const TiXmlElement* body = nullptr;  ///< The `<xacro:macro>` element.
  std::string file;                    ///< Where it stands.
};

/// A scope. What it does not hold is looked up in its parent, which must outlive it.
struct Scope {
  explicit Scope(Scope* enclosing) : parent(enclosing) {}

  Scope* parent;
  std::map<std::string, Property> properties;
  std::map<std::string, Block> blocks;
  std::map<std::string, Macro> macros;
  std::map<std::string, std::unique_ptr<Scope>> namespaces;
};

/// A scope and a name in it.
struct Place {
  Scope* scope = nullptr;
  std::string name;
};

/// Follows the namespaces of a dotted name: "a.b" is b in the namespace a. A name whose namespace
/// is not known is left as it is.
Place resolve(Scope& scope, const std::string& dotted);

/// The scope that holds a property of a dotted name; its `scope` is null if there is none.
Place find_property(Scope& scope, const std::string& dotted);
/// Null if there is none.
const Block* find_block(Scope& scope, const std::string& name);
/// Null if there is none.
const Macro* find_macro(Scope& scope, const std::string& name);
/// The names of all macros that can be seen.
std::vector<std::string> macro_names(const Scope& scope);

}  // namespace castaway::sim::xacro
