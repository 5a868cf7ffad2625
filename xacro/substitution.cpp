#include "xacro/substitution.hpp"

#include <cstdlib>
#include <optional>
#include <sstream>
#include <stdexcept>
#include <vector>

#include <fmt/format.h>

namespace castaway::xacro {
namespace {

std::vector<std::string> substitution_words(const std::string& command) {
  std::istringstream stream(command);
  std::vector<std::string> words;
  for (std::string word; stream >> word;) words.push_back(word);
  return words;
}

/// The words from `first` on, joined by blanks.
std::string rest_of(const std::vector<std::string>& words, std::size_t first) {
  std::string text;
  for (std::size_t i = first; i < words.size(); ++i) text += (i > first ? " " : "") + words[i];
  return text;
}

std::string argument(const std::string& name, const SubstitutionContext& context) {
  if (context.on_argument) context.on_argument(name);
  const auto found = context.arguments->find(name);
  if (found != context.arguments->end()) return found->second;
  throw std::invalid_argument(
      fmt::format("the argument '{0}' has no value: give it a default with <xacro:arg>, or "
                  "--arg {0}:=value",
                  name));
}

std::string environment(const std::string& name, const std::optional<std::string>& fallback) {
  const char* value = std::getenv(name.c_str());
  if (value != nullptr) return value;
  if (fallback) return *fallback;
  throw std::invalid_argument(fmt::format("the environment variable {} is not set", name));
}

/// Evaluates a substitution by its name; nothing for other names.
std::optional<std::string> by_name(const std::vector<std::string>& words,
                                   const SubstitutionContext& context) {
  const std::string& name = words[0];
  if (name == "dirname" && words.size() == 1) return context.folder;
  if (name == "optenv" && words.size() > 1) return environment(words[1], rest_of(words, 2));
  if (words.size() != 2) return std::nullopt;
  if (name == "arg") return argument(words[1], context);
  if (name == "find") return context.find(words[1]);
  if (name == "env") return environment(words[1], std::nullopt);
  return std::nullopt;
}

std::string evaluate_command(const std::string& expression, const SubstitutionContext& context) {
  Surroundings surroundings;
  surroundings.property = [&](const std::string& name) -> std::optional<Value> {
    const auto found = context.arguments->find(name);
    if (found == context.arguments->end()) return std::nullopt;
    if (context.on_argument) context.on_argument(name);
    return from_literal(found->second);
  };
  surroundings.function = [&](const std::string& name,
                              const List& arguments) -> std::optional<Value> {
    std::vector<std::string> words{name};
    for (const Value& value : arguments) words.push_back(to_text(value));
    const auto text = by_name(words, context);
    return text ? std::optional<Value>(from_literal(*text)) : std::nullopt;
  };
  return to_text(evaluate(expression, surroundings));
}

}  // namespace

std::string substitute(const std::string& command, const SubstitutionContext& context) {
  const std::vector<std::string> words = substitution_words(command);
  if (!words.empty() && words[0] == "eval") {
    return evaluate_command(command.substr(command.find("eval") + 4), context);
  }
  if (!words.empty()) {
    if (auto text = by_name(words, context)) return *text;
  }
  throw std::invalid_argument(
      fmt::format("$({}) is not supported: use arg, find, env, optenv, dirname or eval", command));
}

}  // namespace castaway::xacro
