/// Scopes of names in a xacro file.
#pragma once

#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include <tinyxml.h>

#include "xacro/parameters.hpp"
#include "xacro/value.hpp"

namespace castaway::xacro {

/// A property. Its text is evaluated on first use.
struct Property {
  std::string text;
  std::optional<Value> value;  ///< Nothing before evaluation.
  bool evaluating = false;     ///< Detects properties that depend on themselves.
};

/// A block: the children of an element.
struct Block {
  /// Of a macro's block; other blocks are owned by the file.
  std::unique_ptr<const TiXmlElement> owned;
  const TiXmlElement* holder = nullptr;  ///< The block is its children.
  bool expanded = false;  ///< False: a property's block, expanded where it is inserted.
  std::string file;       ///< Where the block is defined.
};

/// A macro.
struct Macro {
  std::string name;
  std::vector<Parameter> parameters;
  const TiXmlElement* body = nullptr;  ///< The `<xacro:macro>` element.
  std::string file;                    ///< Where the macro is defined.
};

/// A scope. Names that it lacks are looked up in its parent, which must outlive it.
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

/// Follows the namespaces of a dotted name: "a.b" is b in namespace a. A name with an unknown
/// namespace is not changed.
Place resolve(Scope& scope, const std::string& dotted);

/// The scope that contains a property with a dotted name; its `scope` is nullptr if there is none.
Place find_property(Scope& scope, const std::string& dotted);
/// nullptr if there is none.
const Block* find_block(Scope& scope, const std::string& name);
/// nullptr if there is none.
const Macro* find_macro(Scope& scope, const std::string& name);
/// Names of all visible macros.
std::vector<std::string> macro_names(const Scope& scope);

}  // namespace castaway::xacro
