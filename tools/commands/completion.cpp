// castaway completion: a script by which a shell completes commands, options and names. castaway
// man: the manual page. Both are made from the command line's own description.
#include <memory>

#include <fmt/chrono.h>
#include <fmt/format.h>
#include <fmt/ranges.h>

#include "tools/commands/commands.hpp"
#include "tools/scenario/files/data_paths.hpp"

namespace castaway::testbed {
namespace {

std::vector<const CLI::App*> commands_of(const CLI::App& app) {
  return app.get_subcommands([](const CLI::App*) { return true; });
}

/// Subcommands and long options of a command.
std::vector<std::string> words_of(const CLI::App& command) {
  std::vector<std::string> words;
  for (const CLI::App* sub : commands_of(command)) words.push_back(sub->get_name());
  for (const CLI::Option* option : command.get_options()) {
    for (const std::string& name : option->get_lnames()) words.push_back("--" + name);
  }
  return words;
}

/// A case for each command, by its path ("bench kidnaps").
std::string cases(const CLI::App& command, const std::string& path) {
  std::string text =
      fmt::format("    \"{}\") words=\"{}\" ;;\n", path, fmt::join(words_of(command), " "));
  for (const CLI::App* sub : commands_of(command)) {
    text += cases(*sub, path.empty() ? sub->get_name() : path + " " + sub->get_name());
  }
  return text;
}

/// Works in bash, and in zsh with bashcompinit.
std::string bash_script(const CLI::App& app) {
  return fmt::format(R"sh(# Completion of castaway for bash: eval "$(castaway completion bash)"
_castaway() {{
  local current="${{COMP_WORDS[COMP_CWORD]}}" previous="${{COMP_WORDS[COMP_CWORD-1]}}" words="" path="" word i
  for ((i = 1; i < COMP_CWORD; ++i)); do
    word="${{COMP_WORDS[i]}}"
    case "$path $word" in
      " "[a-z]*) path="$word" ;;
      "bench "[a-z]*) path="bench $word" ;;
    esac
  done
  case "$path" in
{}  esac
  case "$previous" in
    --world) words="{}" ;;
    --robot) words="{}" ;;
    --localizer) words="mh_amcl mh_amcl:paper mh_amcl:published amcl amcl:amcl-recovery amcl:amcl-global amcl:amcl-prob" ;;
  esac
  [[ "$path" == run && "$current" != -* && "$previous" != -* ]] && words="$words {}"
  COMPREPLY=($(compgen -W "$words" -- "$current"))
}}
complete -o default -F _castaway castaway
)sh",
                     cases(app, ""), fmt::join(world_names(), " "), fmt::join(robot_names(), " "),
                     fmt::join(scenario_names(), " "));
}

std::string script(const CLI::App& app, const std::string& shell) {
  if (shell == "zsh") return "autoload -U +X bashcompinit && bashcompinit\n" + bash_script(app);
  return bash_script(app);
}

/// Text for roff: no line begins with a control character, backslashes and dashes are literal.
std::string roff(const std::string& text) {
  std::string escaped;
  bool line_begins = true;
  for (const char c : text) {
    if (line_begins && (c == '.' || c == '\'')) escaped += "\\&";
    if (c == '\\') {
      escaped += "\\e";
    } else if (c == '-') {
      escaped += "\\-";
    } else {
      escaped += c;
    }
    line_begins = c == '\n';
  }
  return escaped;
}

std::string option_text(const CLI::Option& option) {
  const std::string name = option.get_positional() ? option.get_name(true) : option.get_name();
  const std::string value = option.get_type_name().empty() || option.get_items_expected_max() == 0
                                ? ""
                                : " " + option.get_type_name();
  return fmt::format(".TP\n.B {}{}\n{}\n", roff(name), roff(value), roff(option.get_description()));
}

std::string section(const CLI::App& command, const std::string& path) {
  std::string text =
      fmt::format(".SS castaway {}\n{}\n", roff(path), roff(command.get_description()));
  for (const CLI::Option* option : command.get_options()) text += option_text(*option);
  if (!command.get_footer().empty())
    text += fmt::format(".PP\n.nf\n{}\n.fi\n", roff(command.get_footer()));
  for (const CLI::App* sub : commands_of(command))
    text += section(*sub, path + " " + sub->get_name());
  return text;
}

std::string manual(const CLI::App& app) {
  std::string text = fmt::format(
      ".TH CASTAWAY 1 \"\" \"castaway {}\" \"User Commands\"\n.SH NAME\ncastaway \\- kidnap a "
      "simulated robot "
      "and measure how a localizer finds it again\n.SH SYNOPSIS\n.B castaway\n.I "
      "command\n[options]\n.SH "
      "DESCRIPTION\n{}\n.SH COMMANDS\n",
      CASTAWAY_VERSION, roff(app.get_description()));
  for (const CLI::App* command : commands_of(app)) text += section(*command, command->get_name());
  text +=
      ".SH EXIT STATUS\n.TP\n.B 0\nDone.\n.TP\n.B 1\nThe run failed or is void.\n.TP\n.B 2\nBad "
      "usage or "
      "input.\n.TP\n.B 3\nAn expectation was not met.\n.TP\n.B 130, 143\nInterrupted by Ctrl\\-C "
      "or "
      "SIGTERM.\n.SH ENVIRONMENT\n.TP\n.B CASTAWAY_DATA\nThe folder that holds worlds, robots and "
      "lidars, instead of the program's own.\n.TP\n.B NO_COLOR\nNo colours on a terminal.\n";
  return text;
}

}  // namespace

void add_completion_command(CLI::App& app, std::function<int()>& chosen) {
  auto shell = std::make_shared<std::string>();
  CLI::App* completion =
      app.add_subcommand("completion", "Print a script that completes commands in a shell");
  completion->add_option("shell", *shell, "bash or zsh")
      ->required()
      ->check(CLI::IsMember({"bash", "zsh"}));
  completion->footer("Example, for ~/.bashrc:\n  eval \"$(castaway completion bash)\"");
  completion->callback([&app, &chosen, shell] {
    chosen = [&app, shell] {
      fmt::print("{}", script(app, *shell));
      return kDone;
    };
  });
  CLI::App* man = app.add_subcommand("man", "Print the manual page");
  man->footer("Example:\n  castaway man | man -l -");
  man->callback([&app, &chosen] {
    chosen = [&app] {
      fmt::print("{}", manual(app));
      return kDone;
    };
  });
}

}  // namespace castaway::testbed
