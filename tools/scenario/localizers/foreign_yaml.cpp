#include "tools/scenario/localizers/foreign_yaml.hpp"

#include <algorithm>
#include <set>
#include <stdexcept>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "tools/base/files/json_text.hpp"
#include "tools/base/output/file_name.hpp"
#include "tools/scenario/localizers/yaml_json.hpp"
#include "tools/scenario/sections/name_yaml.hpp"

namespace castaway::testbed {
namespace {

void fields(Settings settings, ProgramConfig& config) {
  settings.field({"timeout_s", "s", "Wall time for the answer to a scan.", {1e-3, 1e5}},
                 config.timeout_s);
  settings.field({"start_timeout_s", "s", "Wall time until the program is ready.", {1e-3, 1e5}},
                 config.start_timeout_s);
}

/// The name of a program: of its script, if an interpreter runs one.
std::string name_of(const std::vector<std::string>& command) {
  static const std::set<std::string> kScripts = {".py", ".sh", ".jl", ".js", ".lua", ".pl", ".rb"};
  const auto is_script = [](const std::string& word) {
    return kScripts.count(std::filesystem::path(word).extension().string()) > 0;
  };
  const auto script = std::find_if(command.begin(), command.end(), is_script);
  const std::string& file = script == command.end() ? command.front() : *script;
  return std::filesystem::path(file).stem().string();
}

/// "libmine.so" is called "mine".
std::string name_of_library(const std::string& file) {
  const std::string stem = std::filesystem::path(file).stem().string();
  return stem.starts_with("lib") && stem.size() > 3 ? stem.substr(3) : stem;
}

void require_trust(const YamlReader& value, const ForeignRules& rules, const char* what) {
  if (rules.programs == FilePrograms::kAllowed || value.is_from_command_line()) return;
  value.fail(fmt::format("this file {}; add --allow-programs if you trust it", what));
}

std::vector<std::string> read_command(const YamlReader& value) {
  std::vector<std::string> command;
  try {
    command = value.is_list() ? value.as<std::vector<std::string>>()
                              : split_words(value.as<std::string>());
  } catch (const std::invalid_argument& error) {
    value.fail(error.what());
  }
  if (command.empty() || command.front().empty()) {
    value.fail("needs a program, e.g. [python3, mine.py]");
  }
  return command;
}

std::string read_params(YamlReader& body) {
  const auto params = body.find("params");
  if (!params) return "{}";
  if (!params->is_map()) params->fail("must be a map, e.g. {particles: 500}");
  return json_text(yaml_json(params->raw()));
}

void read_name(YamlReader& body, const std::string& fallback, LocalizerSpec& spec) {
  spec.relocalize_at_kidnap = body.get("global_localization_at_kidnap", false);
  spec.name = get_name(body, "name", fallback);
}

}  // namespace

bool is_foreign(const LocalizerSpec& spec) {
  return std::holds_alternative<ProgramConfig>(spec.config) ||
         std::holds_alternative<LibraryConfig>(spec.config);
}

std::optional<LocalizerSpec> read_foreign(YamlReader& item, const ForeignRules& rules) {
  if (!item.is_map()) return std::nullopt;
  LocalizerSpec spec;
  if (const auto program = item.find("program")) {
    require_trust(*program, rules, "starts a program");
    if (item.has("library")) item.fail("a localizer is a program or a library, not both");
    ProgramConfig config;
    config.command = read_command(*program);
    config.params = read_params(item);
    config.folder = rules.folder;
    fields(Settings::reading(item), config);
    read_name(item, name_of(config.command), spec);
    spec.config = std::move(config);
    return spec;
  }
  const auto library = item.find("library");
  if (!library) return std::nullopt;
  require_trust(*library, rules, "loads a library");
  LibraryConfig config{library->as<std::string>(), read_params(item), rules.folder};
  read_name(item, name_of_library(config.library), spec);
  spec.config = std::move(config);
  return spec;
}

std::optional<LocalizerSpec> parse_foreign(const std::string& text) {
  const std::size_t colon = text.find(':');
  const std::string kind = text.substr(0, colon);
  if (kind != "program" && kind != "library") return std::nullopt;
  const std::string rest = colon == std::string::npos ? "" : text.substr(colon + 1);
  if (rest.find_first_not_of(' ') == std::string::npos) {
    throw std::invalid_argument(kind == "program"
                                    ? "program: needs a command, e.g. \"program:python3 mine.py\""
                                    : "library: needs a file, e.g. library:./libmine.so");
  }
  LocalizerSpec spec;
  if (kind == "program") {
    ProgramConfig config;
    config.command = split_words(rest);
    spec.name = file_name_of(name_of(config.command));
    spec.config = std::move(config);
  } else {
    spec.name = file_name_of(name_of_library(rest));
    spec.config = LibraryConfig{rest};
  }
  return spec;
}

std::string foreign_yaml(const LocalizerSpec& spec) {
  if (const auto* program = std::get_if<ProgramConfig>(&spec.config)) {
    return json_text(nlohmann::json{{"name", spec.name}, {"program", program->command}});
  }
  return json_text(nlohmann::json{{"name", spec.name},
                                  {"library", std::get<LibraryConfig>(spec.config).library}});
}

void describe_foreign(std::vector<SettingText>& texts) {
  Settings settings = Settings::describing(texts, "localizers[].");
  settings.form({"program", "", "A program and its arguments: docs/protocol.md."}, "none");
  settings.form({"library", "", "A shared library, instead: castaway/localizer.h."}, "none");
  settings.form({"params", "", "A map that the program or library is told."}, "{}");
  settings.form({"name", "", "Names its files."}, "the file's");
  settings.form({"global_localization_at_kidnap", "",
                 "The localizer is notified of kidnaps and relocalizes globally."},
                "false");
  ProgramConfig config;
  fields(settings, config);
}

std::vector<std::string> split_words(const std::string& command) {
  std::vector<std::string> words;
  bool in_word = false;
  char quote = '\0';
  for (std::size_t i = 0; i < command.size(); ++i) {
    const char c = command[i];
    const bool is_blank = c == ' ' || c == '\t' || c == '\n';
    if (quote == '\0' && is_blank) {
      in_word = false;
      continue;
    }
    if (!in_word) words.emplace_back();
    in_word = true;
    if (c == quote) {
      quote = '\0';
    } else if (quote == '\0' && (c == '\'' || c == '"')) {
      quote = c;
    } else if (c == '\\' && quote != '\'' && i + 1 < command.size()) {
      words.back() += command[++i];
    } else {
      words.back() += c;
    }
  }
  if (quote != '\0') throw std::invalid_argument(command + ": a quote has no end");
  return words;
}

}  // namespace castaway::testbed
