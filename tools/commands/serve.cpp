// castaway serve: a localizer as a program that speaks the protocol of docs/protocol.md.
#include <iostream>
#include <memory>
#include <stdexcept>

#include <fmt/format.h>

#include "tools/base/bytes/utf8.hpp"
#include "tools/base/output/exit_code.hpp"
#include "tools/build/build_localizers.hpp"
#include "tools/build/foreign/message.hpp"
#include "tools/commands/commands.hpp"
#include "tools/scenario/localizers/localizer_specs.hpp"

namespace castaway::testbed {
namespace {

/// Serves one localizer, which is built when the map is known.
class Served {
 public:
  explicit Served(LocalizerSpec spec) : spec_(std::move(spec)) {}

  /// Takes a message. Returns false at the end of the conversation.
  bool take(const Message& message) {
    if (std::holds_alternative<ByeMessage>(message)) return false;
    if (const auto* greeting = std::get_if<Greeting>(&message)) {
      localizer_ = build_localizer(spec_, *greeting);
      fmt::print("{}", ready_text());
    } else if (!localizer_.localizer) {
      throw std::runtime_error("the first message must be 'hello'");
    } else if (const auto* start = std::get_if<StartMessage>(&message)) {
      localizer_.localizer->initialize(start->start);
    } else if (const auto* odometry = std::get_if<Odometry>(&message)) {
      localizer_.localizer->on_odometry(*odometry);
    } else if (const auto* scan = std::get_if<LaserScan>(&message)) {
      localizer_.localizer->on_scan(*scan);
      if (localizer_.news) {
        for (const auto& sentence : localizer_.news())
          fmt::print(stderr, "{}\n", printable(sentence));
      }
      auto estimate = localizer_.localizer->estimate();
      if (estimate && estimate->stamp != scan->stamp) estimate.reset();
      fmt::print("{}", estimate_text(scan->stamp, estimate));
    }
    std::fflush(stdout);
    return true;
  }

 private:
  LocalizerSpec spec_;
  NamedLocalizer localizer_;
};

/// A name, or an element of a scenario's list in YAML: "{ros2: {domain: 3}}".
LocalizerSpec served_spec(const std::string& text) {
  if (!text.starts_with('{')) return parse_localizer(text);
  YamlDocument document = YamlDocument::parse("localizers: [" + text + "]", "serve");
  YamlReader root = document.root();
  auto specs = read_localizers(root, "localizers", {{}, FilePrograms::kAllowed});
  document.reject_unknown_keys();
  if (specs.size() != 1) throw std::invalid_argument(text + ": is not one localizer");
  return std::move(specs.front());
}

int serve(const std::string& text) {
  Served served(served_spec(text));
  MessageReader reader;
  for (std::string line; std::getline(std::cin, line);) {
    if (!served.take(reader.read(line))) break;
  }
  return kDone;
}

}  // namespace

void add_serve_command(Command& app) {
  auto localizer = std::make_shared<std::string>();
  Command command =
      app.add_command("serve", "Be a localizer program: speak the protocol of docs/protocol.md");
  command.add_option("localizer", *localizer, "As of --localizer: mh_amcl, library:./libmine.so")
      .required();
  command.footer(
      "A library of which one does not know whether it crashes runs in a process of its own:\n"
      "  castaway run --localizer \"program:castaway serve library:./libmine.so\"");
  command.action([localizer] { return serve(*localizer); });
}

}  // namespace castaway::testbed
