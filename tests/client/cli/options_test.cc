#include <sstream>
#include <string>
#include <vector>

#include "client/cli/json.h"
#include "gtest/gtest.h"
#include "tests/client/fake_service.h"
#include "tests/client/run_celt.h"

namespace celt {
namespace {

using Arguments = std::vector<std::string>;

/// The specification that `celt lyapunov <options>` submits, as JSON.
std::string Submitted(Arguments options) {
  FakeService service;
  service.scripts = {{{ResultMessage()}, {}}};
  options.insert(options.begin(), "lyapunov");
  const Outcome outcome = RunCelt(options, {.server = service.address()});
  EXPECT_EQ(outcome.code, 0) << outcome.err;
  return cli::ToJson(service.submitted());
}

/// The message with which `celt lyapunov <options>` refuses, before it calls any service.
std::string Refused(Arguments options) {
  options.insert(options.begin(), "lyapunov");
  const Outcome outcome = RunCelt(options, {.server = "127.0.0.1:1"});
  EXPECT_EQ(outcome.code, 2) << outcome.err;
  EXPECT_EQ(outcome.out, "");
  return outcome.err;
}

TEST(Options, WhatIsNotGivenIsNotSent) { EXPECT_EQ(Submitted({}), R"({"lyapunov":{}})"); }

TEST(Options, SpectrumTakesItsOwn) {
  EXPECT_EQ(Submitted({"--iterates", "1e6", "--orbits", "4", "--transient", "0", "--seed", "7",
                       "--start", "-1,0.5,-0.25"}),
            R"({"lyapunov":{"iterates":"1000000","orbits":4,"transient":"0","seed":"7",)"
            R"("start":{"l":-1,"lOverG":0.5,"hOverG":-0.25}}})");
}

TEST(Options, StoneParametersGoByName) {
  EXPECT_EQ(
      Submitted({"--energy=750", "--delta", "-0.485", "--inertia", "2,6,7", "--mass", "1",
                 "--gravity", "100", "--radii", "9,4", "--height", "1", "--section-angle", "3"}),
      R"({"system":{"parameters":{"delta":-0.485,"energy":750,"gravity":100,"height":1,)"
      R"("inertia_1":2,"inertia_2":6,"inertia_3":7,"mass":1,"radius_1":9,"radius_2":4,)"
      R"("section_angle":3}},"lyapunov":{}})");
}

TEST(Options, OtherSystemsTakeSetAndPlainPoints) {
  EXPECT_EQ(
      Submitted({"--system", "lorenz", "--set", "rho=28", "--set", "sigma=10", "--start", "1,2,3"}),
      R"({"system":{"name":"lorenz","parameters":{"rho":28,"sigma":10}},)"
      R"("lyapunov":{"start":{"x":[1,2,3]}}})");
}

TEST(Options, NumericsAndFrame) {
  EXPECT_EQ(Submitted({"--tolerance", "1e-12", "--engine", "arkode", "--frame", "paper"}),
            R"({"numerics":{"tolerance":1e-12,"engine":"ENGINE_ARKODE"},"frame":"FRAME_PAPER",)"
            R"("lyapunov":{}})");
}

TEST(Options, StoneTakesSetAsWell) {
  EXPECT_EQ(Submitted({"--system", "celtic-stone", "--set", "energy=750"}),
            R"({"system":{"name":"celtic-stone","parameters":{"energy":750}},"lyapunov":{}})");
}

TEST(Options, StoneOptionWithAnotherSystemIsNamed) {
  for (const char* option :
       {"--energy", "--delta", "--mass", "--gravity", "--height", "--section-angle"}) {
    EXPECT_EQ(Refused({"--system", "henon3d", option, "1"}),
              std::string("celt: ") + option +
                  ": belongs to the celtic-stone; the parameters of henon3d are given by --set "
                  "name=value\n");
  }
  EXPECT_NE(Refused({"--inertia", "2,6,7", "--system", "lorenz"}).find("--inertia: "),
            std::string::npos);
  EXPECT_NE(Refused({"--radii", "9,4", "--system", "lorenz"}).find("--radii: "), std::string::npos);
  EXPECT_NE(Refused({"--frame", "paper", "--system", "lorenz"}).find("--frame: "),
            std::string::npos);
}

TEST(Options, ParameterGivenTwiceIsRefused) {
  EXPECT_EQ(Refused({"--energy", "752", "--set", "energy=753"}),
            "celt: --energy: the parameter energy is given by --set as well\n");
  EXPECT_EQ(Refused({"--set", "energy=752", "--set", "energy=753"}),
            "celt: --set: 'energy=753' comes twice\n");
}

TEST(Options, BadValuesNameOptionValueAndWhatIsAllowed) {
  const std::vector<std::pair<Arguments, std::string>> cases = {
      {{"--energy", "nan"}, "--energy: 'nan' is no finite number"},
      {{"--energy", ""}, "--energy: '' is no finite number"},
      {{"--energy", "--delta"}, "--energy: '--delta' is no finite number"},
      {{"--tolerance", "inf"}, "--tolerance: 'inf' is no finite number"},
      {{"--iterates", "1e3x"},
       "--iterates: '1e3x' is no whole number from 0 to 9223372036854775807"},
      {{"--iterates", "-1"}, "--iterates: '-1' is no whole number from 0 to 9223372036854775807"},
      {{"--orbits", "1e10"}, "--orbits: '1e10' is no whole number from 0 to 2147483647"},
      {{"--orbits", "1.5"}, "--orbits: '1.5' is no whole number from 0 to 2147483647"},
      {{"--seed", "-1"}, "--seed: '-1' is no whole number from 0 to 18446744073709551615"},
      {{"--inertia", "2,6"}, "--inertia: '2,6' should be 3 numbers: I1,I2,I3"},
      {{"--start", "1,2"}, "--start: 2 numbers where 3 are due: l,L/G,H/G"},
      {{"--start", "1,2,x"}, "--start: '1,2,x' holds 'x' is no finite number"},
      {{"--engine", "euler"}, "--engine: 'euler' is none of cvode, arkode, fast"},
      {{"--frame", "lab"}, "--frame: 'lab' is none of body, paper"},
      {{"--set", "energy"}, "--set: 'energy' is not name=number"},
      {{"--set", "energy=nan"}, "--set: 'energy=nan' holds 'nan' is no finite number"},
      {{"--output", "xml"}, "--output: 'xml' is none of table, json, csv"},
      {{"--server", "here"}, "--server: 'here' is not HOST:PORT"},
      {{"--threads", "0"}, "--threads: '0' is no whole number from 1 to 1024"},
      {{"--reconnect", "-1"}, "--reconnect: '-1' is no number of seconds, 0 or more"},
  };
  for (const auto& [options, message] : cases) {
    EXPECT_EQ(Refused(options), "celt: " + message + "\n");
  }
}

TEST(Options, UnknownWordsAreNamedWithWhereToLook) {
  const auto message = [](const Arguments& arguments) {
    const Outcome outcome = RunCelt(arguments);
    EXPECT_EQ(outcome.code, 2);
    return outcome.err;
  };
  EXPECT_EQ(message({"lyapunov", "--iterats", "100"}),
            "celt: --iterats: no such option; see 'celt lyapunov --help'\n");
  EXPECT_EQ(message({"lyapunov", "here"}),
            "celt: here: not expected here; see 'celt lyapunov --help'\n");
  EXPECT_EQ(message({"liapunov"}), "celt: liapunov: no such command; see 'celt --help'\n");
  EXPECT_EQ(message({"jobs", "stop", "x"}),
            "celt: stop: no such command; see 'celt jobs --help'\n");
  EXPECT_EQ(message({"--frobnicate"}), "celt: --frobnicate: no such option; see 'celt --help'\n");
  EXPECT_EQ(message({}), "celt: A subcommand is required; see 'celt --help'\n");
  EXPECT_EQ(message({"jobs"}), "celt: A subcommand is required; see 'celt jobs --help'\n");
  EXPECT_EQ(message({"jobs", "get"}), "celt: ID is required; see 'celt jobs get --help'\n");
  EXPECT_EQ(message({"lyapunov", "--energy"}),
            "celt: --energy: needs a value; see 'celt lyapunov --help'\n");
  EXPECT_EQ(message({"lyapunov", "--energy", "1", "--energy", "2"}),
            "celt: --energy: is given more than once; see 'celt lyapunov --help'\n");
}

std::vector<std::string> Lines(const std::string& text) {
  std::vector<std::string> lines;
  std::istringstream stream(text);
  for (std::string line; std::getline(stream, line);) lines.push_back(line);
  return lines;
}

TEST(Options, HelpOfEveryCommandFitsTheTerminalAndHasAnExample) {
  const std::vector<Arguments> commands = {{},
                                           {"lyapunov"},
                                           {"fixed-point"},
                                           {"continue"},
                                           {"separatrix"},
                                           {"jobs"},
                                           {"jobs", "list"},
                                           {"jobs", "get"},
                                           {"jobs", "watch"},
                                           {"jobs", "results"},
                                           {"jobs", "cancel"},
                                           {"jobs", "delete"},
                                           {"server"},
                                           {"server", "info"}};
  for (Arguments arguments : commands) {
    arguments.emplace_back("--help");
    const Outcome outcome = RunCelt(arguments);
    EXPECT_EQ(outcome.code, 0);
    EXPECT_EQ(outcome.err, "");
    for (const std::string& line : Lines(outcome.out)) EXPECT_LE(line.size(), 100U) << line;
    EXPECT_NE(outcome.out.find("Example:\n  celt "), std::string::npos) << outcome.out;
  }
}

TEST(Options, VersionIsPrinted) {
  const Outcome outcome = RunCelt({"--version"});
  EXPECT_EQ(outcome.code, 0);
  EXPECT_EQ(outcome.out.rfind("celt ", 0), 0U) << outcome.out;
}

}  // namespace
}  // namespace celt
