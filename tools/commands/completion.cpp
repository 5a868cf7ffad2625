// castaway completion: a shell script that completes commands, options and names. castaway man: the
// manual page. Both are generated from the command line's own description.
#include <memory>

#include <fmt/chrono.h>
#include <fmt/format.h>
#include <fmt/ranges.h>

#include "tools/commands/commands.hpp"
#include "tools/scenario/files/data_paths.hpp"

namespace castaway::testbed {
namespace {

/// Subcommands and long options of a command.
std::vector<std::string> words_of(const Command& command) {
  std::vector<std::string> words;
  for (const Command& sub : command.commands()) words.push_back(sub.name());
  for (const OptionText& option : command.options()) {
    for (const std::string& name : option.long_names) words.push_back("--" + name);
  }
  return words;
}

/// Cases of the shell script for a command and its subcommands, by path ("bench kidnaps").
std::string cases(const Command& command, const std::string& path) {
  std::string text =
      fmt::format("    \"{}\") words=\"{}\" ;;\n", path, fmt::join(words_of(command), " "));
  for (const Command& sub : command.commands()) {
    text += cases(sub, path.empty() ? sub.name() : path + " " + sub.name());
  }
  return text;
}

/// Works in bash, and in zsh with bashcompinit.
std::string bash_script(const Command& app) {
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

std::string script(const Command& app, const std::string& shell) {
  if (shell == "zsh") return "autoload -U +X bashcompinit && bashcompinit\n" + bash_script(app);
  return bash_script(app);
}

/// Escapes text for roff: no line begins with a control character, backslashes and dashes are
/// literal.
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

std::string option_text(const OptionText& option) {
  const std::string value = option.value.empty() ? "" : " " + option.value;
  return fmt::format(".TP\n.B {}{}\n{}\n", roff(option.name), roff(value), roff(option.what));
}

std::string section(const Command& command, const std::string& path) {
  std::string text = fmt::format(".SS castaway {}\n{}\n", roff(path), roff(command.what()));
  for (const OptionText& option : command.options()) text += option_text(option);
  if (!command.footer().empty()) {
    text += fmt::format(".PP\n.nf\n{}\n.fi\n", roff(command.footer()));
  }
  for (const Command& sub : command.commands()) text += section(sub, path + " " + sub.name());
  return text;
}

std::string manual(const Command& app) {
  std::string text = fmt::format(
      ".TH CASTAWAY 1 \"\" \"castaway {}\" \"User Commands\"\n.SH NAME\ncastaway \\- kidnap a "
      "simulated robot "
      "and measure how a localizer finds it again\n.SH SYNOPSIS\n.B castaway\n.I "
      "command\n[options]\n.SH "
      "DESCRIPTION\n{}\n.SH COMMANDS\n",
      CASTAWAY_VERSION, roff(app.what()));
  for (const Command& command : app.commands()) text += section(command, command.name());
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

void add_completion_command(Command& app) {
  auto shell = std::make_shared<std::string>();
  Command completion =
      app.add_command("completion", "Print a script that completes commands in a shell");
  completion.add_option("shell", *shell, "bash or zsh").required().one_of({"bash", "zsh"});
  completion.footer("Example, for ~/.bashrc:\n  eval \"$(castaway completion bash)\"");
  completion.action([app, shell] {
    fmt::print("{}", script(app, *shell));
    return kDone;
  });
  Command man = app.add_command("man", "Print the manual page");
  man.footer("Example:\n  castaway man | man -l -");
  man.action([app] {
    fmt::print("{}", manual(app));
    return kDone;
  });
}

}  // namespace castaway::testbed
