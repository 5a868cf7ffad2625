/// The expander's state and steps. Internal to sim/xacro.
#pragma once

#include <map>
#include <memory>
#include <set>
#include <string>
#include <vector>

#include "xacro/expand.hpp"
#include "xacro/scope.hpp"
#include "xacro/text.hpp"

namespace castaway::xacro {

/// Copies a source tree to an output tree and evaluates it. Source trees are not changed, since
/// macros and blocks point into them.
class Expander {
 public:
  Expander(const PackageFinder& packages, const Options& options);

  Expansion run(const std::string& path);

 private:
  void require_known_arguments() const;
  using Element = TiXmlElement;

  // elements.cpp: walks the tree.
  void expand_children(const TiXmlNode& from, Scope& scope, TiXmlNode& to);
  void expand_element(const Element& from, Scope& scope, TiXmlNode& to);
  void copy(const Element& from, Scope& scope, TiXmlNode& to);
  void dispatch(const Element& from, Scope& scope, TiXmlNode& to);
  void choose(const Element& from, Scope& scope, TiXmlNode& to, bool wanted);
  void insert_block(const Element& from, Scope& scope, TiXmlNode& to);
  void count(const Element& output);
  void count_tree(const TiXmlNode& output);

  // definitions.cpp: properties, arguments, macros, and evaluation of texts.
  void define_property(const Element& from, Scope& scope);
  void define_argument(const Element& from, Scope& scope);
  void define_macro(const Element& from, Scope& scope);
  [[nodiscard]] Value evaluate_in(Scope& scope, const std::string& text);
  [[nodiscard]] std::string text_in(Scope& scope, const std::string& text);
  [[nodiscard]] std::optional<Value> property_in(Scope& scope, const std::string& name);
  [[nodiscard]] std::string package_folder(const std::string& name);
  [[nodiscard]] std::optional<Value> function(const std::string& name, const List& arguments);

  // calls.cpp: calls of macros and includes of files.
  void call(const Element& from, const std::string& name, Scope& scope, TiXmlNode& to);
  void bind_values(const Element& from, const Macro& macro, Scope& caller, Scope& local);
  void bind_default(const Parameter& parameter, const Macro& macro, Scope& caller, Scope& local);
  void bind_blocks(const Element& from, const Macro& macro, Scope& caller, Scope& local);
  void include(const Element& from, Scope& scope, TiXmlNode& to);
  [[nodiscard]] std::string path_of_include(const Element& from, Scope& scope);
  const Element& load(const std::string& path);

  const PackageFinder& packages_;
  const Options& options_;
  std::map<std::string, std::string> arguments_;
  std::set<std::string> known_arguments_;  ///< Defined or read by the files.
  std::map<std::string, std::unique_ptr<TiXmlDocument>> documents_;  ///< By path.
  std::vector<std::string> including_;                               ///< Files, outermost first.
  std::vector<std::string> calling_;                                 ///< Macros, outermost first.
  std::string file_;  ///< File of the current element.
  std::set<std::string> missing_packages_;
  std::vector<std::string> warnings_;
  int depth_ = 0;
  int calls_ = 0;
  int elements_ = 0;       ///< Elements visited or written.
  std::size_t bytes_ = 0;  ///< Size of the texts written.
  /// In the file name of an include, where a missing package is an error.
  bool must_find_ = false;
};

/// Text of a required attribute. @throws std::invalid_argument naming it.
std::string required(const TiXmlElement& element, const char* name);

/// Checks that an element has only these attributes. @throws std::invalid_argument naming another
/// one.
void allow_only(const TiXmlElement& element, const std::vector<std::string>& names);

}  // namespace castaway::xacro
