#include "tools/commands/arguments/localizer_arguments.hpp"

#include <fmt/format.h>

namespace castaway::testbed {

FilePrograms file_programs(bool allow) {
  return allow ? FilePrograms::kAllowed : FilePrograms::kRefused;
}

std::vector<std::string> localizer_override(const std::vector<std::string>& texts) {
  std::string list;
  for (const std::string& text : texts) list += (list.empty() ? "" : ", ") + localizer_yaml(text);
  if (list.empty()) return {};
  return {"localizers=[" + list + "]"};
}

std::vector<LocalizerSpec> LocalizerArguments::specs(
    const std::vector<std::string>& defaults) const {
  return parse_localizers(texts.empty() ? defaults : texts, file_programs(allow_programs));
}

void add_allow_programs(Command& command, bool& allow) {
  command.add_flag("--allow-programs", allow,
                   "Start the programs and load the libraries that files name as localizers");
}

void add_localizer_options(Command& command, LocalizerArguments& arguments,
                           const std::string& defaults) {
  command
      .add_option("--localizer", arguments.texts,
                  fmt::format("NAME, NAME:PRESET, program:COMMAND, library:FILE, or a YAML file "
                              "with a list localizers; repeat for several (default: {})",
                              defaults))
      .repeatable();
  add_allow_programs(command, arguments.allow_programs);
}

}  // namespace castaway::testbed
