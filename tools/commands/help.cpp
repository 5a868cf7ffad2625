// castaway help, castaway version: words for --help and --version.
#include <memory>

#include <fmt/format.h>

#include "tools/base/output/say.hpp"
#include "tools/commands/commands.hpp"

namespace castaway::testbed {

void add_help_commands(Command& app) {
  auto words = std::make_shared<std::vector<std::string>>();
  // `replace_help_words` has put --help in its place; this entry is for lists of commands.
  Command help = app.add_command("help", "Print what a command does, as its --help");
  help.add_option("command", *words, "The command; without one, all are listed");
  help.footer("Example:\n  castaway help run");
  help.action([words] { return kDone; });
  Command version = app.add_command("version", "Print the version, as --version");
  version.footer("Example:\n  castaway version");
  version.action([] {
    print_out("castaway {}\n", CASTAWAY_VERSION);
    return kDone;
  });
}

}  // namespace castaway::testbed
