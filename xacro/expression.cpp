#include "xacro/expression.hpp"

#include <stdexcept>

#include <fmt/format.h>

#include "xacro/functions.hpp"
#include "xacro/operators.hpp"
#include "xacro/syntax.hpp"

namespace castaway::xacro {
namespace {

using Kind = Syntax::Kind;

/// "a.b.c" if the tree consists of names joined by dots; empty otherwise.
std::string dotted_name(const Syntax& tree) {
  if (tree.kind == Kind::kName) return tree.text;
  if (tree.kind != Kind::kAttribute) return "";
  const std::string before = dotted_name(tree.children[0]);
  return before.empty() ? "" : before + "." + tree.text;
}

/// The name without its Python module.
std::string without_module(const std::string& name) {
  for (const char* module : {"math.", "xacro.", "python."}) {
    if (name.starts_with(module)) return name.substr(std::string(module).size());
  }
  return name;
}

/// Evaluates a syntax tree.
class Evaluator {
 public:
  explicit Evaluator(const Surroundings& surroundings) : surroundings_(surroundings) {}

  Value value(const Syntax& tree) const {
    switch (tree.kind) {
      case Kind::kLiteral:
        return tree.literal;
      case Kind::kUnary:
        return unary(tree.text, child(tree, 0));
      case Kind::kBinary:
        return binary(tree.text, child(tree, 0), child(tree, 1));
      case Kind::kIndex:
        return index(child(tree, 0), child(tree, 1));
      case Kind::kList:
        return check_size({list(tree, 0)});
      case Kind::kDict:
        return dictionary(tree);
      case Kind::kCall:
        return call(tree);
      case Kind::kName:
      case Kind::kAttribute:
        return look_up(tree);
      case Kind::kKeyword:
        throw std::invalid_argument(fmt::format("'{}=' is not supported here", tree.text));
      default:
        return logical(tree);
    }
  }

 private:
  [[nodiscard]] Value child(const Syntax& tree, std::size_t i) const {
    return value(tree.children[i]);
  }

  /// Operators that do not evaluate all of their operands.
  [[nodiscard]] Value logical(const Syntax& tree) const {
    if (tree.kind == Kind::kNot) return {!truth(child(tree, 0))};
    if (tree.kind == Kind::kTernary) return child(tree, truth(child(tree, 1)) ? 0 : 2);
    const Value left = child(tree, 0);
    const bool decided = truth(left) == (tree.kind == Kind::kOr);
    return decided ? left : child(tree, 1);
  }

  [[nodiscard]] List list(const Syntax& tree, std::size_t first) const {
    List items;
    for (std::size_t i = first; i < tree.children.size(); ++i) items.push_back(child(tree, i));
    return items;
  }

  [[nodiscard]] Value dictionary(const Syntax& tree) const {
    Dict dict;
    for (std::size_t i = 0; i + 1 < tree.children.size(); i += 2) {
      dict.push_back({to_text(child(tree, i)), child(tree, i + 1)});
    }
    return check_size({dict});
  }

  [[nodiscard]] Value look_up(const Syntax& tree) const {
    const std::string name = dotted_name(tree);
    if (!name.empty()) {
      if (auto found = surroundings_.property(name)) return *found;
      if (auto found = constant(without_module(name))) return *found;
    }
    if (tree.kind == Kind::kName) {
      throw std::invalid_argument(fmt::format(
          "'{}' is not defined: define it with <xacro:property> or check its spelling", name));
    }
    const Value self = child(tree, 0);
    if (const auto* dict = std::get_if<Dict>(&self.data)) {
      if (const Value* entry = find_key(*dict, tree.text)) return *entry;
    }
    throw std::invalid_argument(fmt::format("{} has no '{}'", type_name(self), tree.text));
  }

  [[nodiscard]] Value call(const Syntax& tree) const {
    const Syntax& callee = tree.children[0];
    const std::string name = without_module(dotted_name(callee));
    if (name == "dict") return dictionary_of_keywords(tree);
    const List arguments = list(tree, 1);
    if (!name.empty()) {
      if (auto result = surroundings_.function(name, arguments)) return *result;
      if (auto result = call_function(name, arguments)) return *result;
    }
    if (callee.kind == Kind::kAttribute) {
      return call_method(child(callee, 0), callee.text, arguments);
    }
    throw std::invalid_argument(fmt::format("the function '{}' is not supported", name));
  }

  [[nodiscard]] Value dictionary_of_keywords(const Syntax& tree) const {
    Dict dict;
    for (std::size_t i = 1; i < tree.children.size(); ++i) {
      const Syntax& argument = tree.children[i];
      if (argument.kind != Kind::kKeyword) throw std::invalid_argument("dict() needs name=value");
      dict.push_back({argument.text, child(argument, 0)});
    }
    return check_size({dict});
  }

  const Surroundings& surroundings_;
};

}  // namespace

Value evaluate(const std::string& expression, const Surroundings& surroundings) {
  return Evaluator(surroundings).value(parse_expression(expression));
}

}  // namespace castaway::xacro
