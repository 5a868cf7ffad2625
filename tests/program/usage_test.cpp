// Errors of the command line, and help for writing one.
#include "tests/program/program.hpp"

namespace castaway::test {
namespace {

/// Expects a rejection with one line that contains all of `parts`.
void expect_refused(const fs::path& folder, const std::string& arguments,
                    const std::vector<std::string>& parts) {
  const Outcome outcome = castaway(folder, arguments);
  EXPECT_EQ(outcome.exit_code, 2) << arguments;
  EXPECT_EQ(std::count(outcome.err.begin(), outcome.err.end(), '\n'), 1) << outcome.err;
  for (const std::string& part : parts) expect_contains(outcome.err, part);
}

TEST(Usage, NamesTheNearestCommand) {
  const fs::path folder = fresh_folder();
  expect_refused(folder, "rnu", {"no command 'rnu'", "did you mean 'run'?"});
  expect_refused(folder, "bench kidnap", {"castaway bench: no command 'kidnap'", "'kidnaps'"});
  expect_refused(folder, "", {"give a command: run, experiment"});
  expect_refused(folder, "bench", {"castaway bench: give a command: calibration, kidnaps"});
}

TEST(Usage, NamesTheOptionThatIsAmiss) {
  const fs::path folder = fresh_folder();
  expect_refused(folder, "run --seed abc", {"castaway run: ", "--seed", "abc"});
  expect_refused(folder, "run --seed -1", {"castaway run: ", "--seed"});
  expect_refused(folder, "run --duration -5", {"--duration", "not -5"});
  expect_refused(folder, "run --duration nan", {"--duration"});
  expect_refused(folder, "run --sed 3", {"no option '--sed'", "did you mean '--seed'?"});
  expect_refused(folder, "run lab/kidnap extra", {"'extra' is one word too many"});
  expect_refused(folder, "run --set a=1 b=2", {"b=2: ", "every key=value takes a --set"});
  expect_refused(folder, "run --set drive.by=amlc", {"drive.by", "did you mean 'amcl'?"});
  expect_refused(folder, "run --localizer mh_amlc", {"did you mean 'mh_amcl'?"});
  expect_refused(folder, "replay", {"castaway replay: log is required"});
}

TEST(Usage, FindsScenariosByWorldAndName) {
  const fs::path folder = fresh_folder();
  const std::string fast = " --duration 2 --set outputs.snapshots=false";
  EXPECT_EQ(castaway(folder, "run office/kidnap --out a" + fast).exit_code, 0);
  expect_refused(folder, "run lab/kidnp",
                 {"lab/kidnp: no such scenario; did you mean 'lab/kidnap'?"});
  expect_refused(folder, "run nowhere.yaml", {"nowhere.yaml: no such file in the current folder"});
  fs::create_directories(folder / "office");
  expect_refused(folder, "run office", {"office: is a folder; give a scenario's file"});
  EXPECT_EQ(castaway(folder, "check-world --scenario lab/moved --no-picture").exit_code, 0);
}

TEST(Usage, TakesLocalizersOnTheCommandLine) {
  const fs::path folder = fresh_folder();
  const Outcome outcome = castaway(folder,
                                   "run --duration 2 --set outputs.snapshots=false --out a "
                                   "--localizer mh_amcl:paper --localizer amcl:amcl-prob");
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_TRUE(fs::exists(folder / "a/mh_amcl-paper.tum"));
  EXPECT_TRUE(fs::exists(folder / "a/amcl-prob.tum"));
  EXPECT_FALSE(fs::exists(folder / "a/amcl.tum"));
}

TEST(Usage, ListsWhatComesAlong) {
  const fs::path folder = fresh_folder();
  expect_contains(castaway(folder, "worlds").out, "\noffice ");
  expect_contains(castaway(folder, "robots").out, "\nmule ");
  expect_contains(castaway(folder, "scenarios").out, "\noffice/look-alikes ");
  expect_contains(castaway(folder, "scenarios --json").out, "\"name\": \"lab/kidnap\"");
}

TEST(Usage, DescribesWhatComesAlong) {
  const fs::path folder = fresh_folder();
  const std::string all = castaway(folder, "list").out;
  expect_contains(all, "worlds:\n");
  expect_contains(all, "  office     An office floor of 40 x 30 m");
  expect_contains(all, "\nrobots:\n");
  expect_contains(all, "A four-wheeled skid steer\n");
  expect_contains(all, "SICK LMS111-10100\n");
  expect_contains(all, "  lab/kidnap ");
  const std::string robots = castaway(folder, "list robots").out;
  EXPECT_EQ(std::count(robots.begin(), robots.end(), '\n'), 5) << robots;
  expect_contains(castaway(folder, "list worlds --json").out, "\"description\": \"A robotics ");
  expect_refused(folder, "list rooms", {"rooms", "worlds"});
}

TEST(Usage, TakesHelpAndVersionAsCommands) {
  const fs::path folder = fresh_folder();
  EXPECT_EQ(castaway(folder, "version").out, castaway(folder, "--version").out);
  EXPECT_EQ(castaway(folder, "version").exit_code, 0);
  EXPECT_EQ(castaway(folder, "help").out, castaway(folder, "--help").out);
  const Outcome help = castaway(folder, "help bench kidnaps");
  EXPECT_EQ(help.exit_code, 0);
  EXPECT_EQ(help.out, castaway(folder, "bench kidnaps --help").out);
  expect_contains(help.out, "--obstacles");
  expect_refused(folder, "help rnu", {"no command 'rnu'", "did you mean 'run'?"});
}

TEST(Usage, NamesTheNearestOptionBeforeWhatIsMissing) {
  const fs::path folder = fresh_folder();
  for (const char* command : {"", "run ", "replay ", "bench ", "bench kidnaps "}) {
    expect_refused(folder, std::string(command) + "--hlep",
                   {"no option '--hlep'; did you mean '--help'?"});
  }
  expect_refused(folder, "--vresion", {"did you mean '--version'?"});
  expect_refused(folder, "run --set lidar.range_mxa=3", {"did you mean 'range_max'?"});
}

TEST(Usage, RefusesOptionsThatWouldBeIgnored) {
  const fs::path folder = fresh_folder();
  expect_refused(folder, "run -j 4", {"-j, --jobs", "--seeds"});
  expect_refused(folder, "run --world lab --search-path .", {"--search-path", "SDF --world"});
  expect_refused(folder, "run --search-path .", {"--search-path", "--robot"});
  expect_refused(folder, "run --world '' --duration 1", {"--world"});
}

// The box lies in a folder that only --search-path names.
TEST(Usage, SearchesTheModelsOfAnSdfWorld) {
  const fs::path folder = fresh_folder();
  const fs::path model = folder / "far/crate";
  fs::create_directories(model);
  std::ofstream(model / "model.config") << "<model><sdf version='1.6'>model.sdf</sdf></model>";
  std::ofstream(model / "model.sdf")
      << "<sdf version='1.6'><model name='crate'><static>1</static><link name='l'><collision "
         "name='c'><pose>0 0 0.5 0 0 0</pose><geometry><box><size>1 1 1</size></box></geometry>"
         "</collision></link></model></sdf>";
  std::ofstream(folder / "hall.sdf")
      << "<sdf version='1.6'><world name='hall'><include><uri>model://crate</uri><pose>3 0 0 0 0 "
         "0</pose></include><include><uri>model://crate</uri><name>other</name><pose>-3 0 0 0 0 0"
         "</pose></include></world></sdf>";
  const std::string run =
      "run --duration 1 --strict --set events=[] --set outputs.snapshots=false --world hall.sdf";
  EXPECT_EQ(castaway(folder, run + " --out without").exit_code, 2);
  const Outcome outcome = castaway(folder, run + " --search-path far --out found");
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
}

/// Completions that bash offers at the end of a line.
std::string offered(const fs::path& folder, const std::string& words) {
  std::ofstream(folder / "try.sh") << "source completion.sh\nCOMP_WORDS=(" << words
                                   << ")\nCOMP_CWORD=$((${#COMP_WORDS[@]} - 1))\n_castaway\n"
                                      "echo \"${COMPREPLY[@]}\"\n";
  const std::string command = "cd '" + folder.string() + "' && bash try.sh >offered.txt 2>&1";
  EXPECT_EQ(std::system(command.c_str()), 0);
  return text_of(folder / "offered.txt");
}

TEST(Usage, CompletesInBash) {
  const fs::path folder = fresh_folder();
  std::ofstream(folder / "completion.sh") << castaway(folder, "completion bash").out;
  EXPECT_EQ(offered(folder, "castaway ru"), "run\n");
  EXPECT_EQ(offered(folder, "castaway bench kid"), "kidnaps\n");
  EXPECT_EQ(offered(folder, "castaway run --dur"), "--duration\n");
  EXPECT_EQ(offered(folder, "castaway run --world off"), "office\n");
  EXPECT_EQ(offered(folder, "castaway run office/look"), "office/look-alikes\n");
  EXPECT_EQ(offered(folder, "castaway bench kidnaps --obst"), "--obstacles\n");
}

TEST(Usage, HasAManualPage) {
  const fs::path folder = fresh_folder();
  const std::string page = castaway(folder, "man").out;
  expect_contains(page, ".TH CASTAWAY 1");
  expect_contains(page, ".SS castaway bench kidnaps");
  expect_contains(page, ".B \\-\\-seeds");
  if (std::system("groff --version >/dev/null 2>&1") != 0) GTEST_SKIP() << "no groff";
  std::ofstream(folder / "castaway.1") << page;
  const std::string check =
      "cd '" + folder.string() + "' && groff -man -Tascii -ww castaway.1 >page.txt 2>warnings.txt";
  EXPECT_EQ(std::system(check.c_str()), 0);
  EXPECT_EQ(text_of(folder / "warnings.txt"), "");
}

// Colours are printed to terminals only.
TEST(Usage, PrintsNoColoursIntoAPipe) {
  const fs::path folder = fresh_folder();
  EXPECT_EQ(castaway(folder, "run nowhere.yaml").err.find('\x1b'), std::string::npos);
}

// A name in a file must not reach the terminal as a command.
TEST(Usage, NamesFromOutsideArePrintedWithoutControlCharacters) {
  const fs::path folder = fresh_folder();
  std::ofstream(folder / "a.sdf")
      << "<sdf version='1.6'><world name='a\x1b[31mb'><model name='m'><static>true</static><link "
         "name='l'><collision name='c'><geometry><box><size>3 3 3</size></box></geometry>"
         "</collision></link></model></world></sdf>";
  std::ofstream(folder / "a.urdf") << "<robot name='a&#27;[31mb'><link name='base_link'/></robot>";
  for (const char* command : {"check-world a.sdf --no-picture", "check-robot a.urdf"}) {
    const Outcome outcome = castaway(folder, command);
    EXPECT_NE(outcome.out + outcome.err, "") << command;
    EXPECT_EQ((outcome.out + outcome.err).find('\x1b'), std::string::npos) << command;
  }
}

}  // namespace
}  // namespace castaway::test
