#include "client/cli/figure_data.h"

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>

#include "gtest/gtest.h"
#include "tests/client/fake_service.h"

namespace celt::cli {
namespace {

std::string ReadFile(const std::filesystem::path& path) {
  std::ostringstream text;
  text << std::ifstream(path).rdbuf();
  return text.str();
}

class FigureDataTest : public testing::Test {
 protected:
  FigureDataTest() {
    service.scripts = {{{RecordMessage(1), RecordMessage(2), ResultMessage()}, {}}};
    std::string pattern = (std::filesystem::temp_directory_path() / "celt-XXXXXX").string();
    root = mkdtemp(pattern.data());
    folder = root / "new" / "figures";
  }
  ~FigureDataTest() override { std::filesystem::remove_all(root); }

  FigureData Data() { return {client, terminal, stop.get_token(), folder}; }

  FakeService service;
  client::Client client{client::OpenChannel(service.address())};
  std::ostringstream out;
  std::ostringstream err;
  Terminal terminal{out, err, 0};
  std::stop_source stop;
  std::filesystem::path root;
  std::filesystem::path folder;
};

v1::JobSpec Spectrum() {
  v1::JobSpec spec;
  spec.mutable_lyapunov();
  return spec;
}

TEST_F(FigureDataTest, WritesTheRecordsOfAJobUnderTheirColumns) {
  FigureData data = Data();
  ASSERT_TRUE(data.Open().ok());
  const auto result = data.Records("history", Spectrum());
  ASSERT_TRUE(result.ok()) << result.status();
  EXPECT_TRUE(result->has_lyapunov());
  const std::string text = ReadFile(folder / "history.csv");
  EXPECT_TRUE(text.starts_with("iterates,exponent_per_iterate_1,")) << text;
  EXPECT_EQ(std::count(text.begin(), text.end(), '\n'), 3) << text;
}

TEST_F(FigureDataTest, PlotsByGnuplotInTheFolder) {
  FigureData data = Data();
  ASSERT_TRUE(data.Open().ok());
  ASSERT_TRUE(data.Write("line.csv", "1,2\n2,3\n").ok());
  const absl::Status status = data.Plot("line",
                                        "set datafile separator ','\nset terminal pngcairo\nset "
                                        "output 'line.png'\nplot 'line.csv'\n");
  EXPECT_TRUE(status.ok()) << status;
  EXPECT_TRUE(ReadFile(folder / "line.png").starts_with("\x89PNG"));
}

TEST_F(FigureDataTest, SaysWhichScriptGnuplotFailedOn) {
  FigureData data = Data();
  ASSERT_TRUE(data.Open().ok());
  const absl::Status status = data.Plot("bad", "exit status 3\n");
  EXPECT_EQ(status.code(), absl::StatusCode::kFailedPrecondition);
  EXPECT_NE(status.message().find("new/figures/bad.gp"), std::string::npos) << status;
}

TEST_F(FigureDataTest, SaysWhyTheFolderCanNotBeMade) {
  folder = "/proc/none/figures";
  const absl::Status status = Data().Open();
  EXPECT_EQ(status.code(), absl::StatusCode::kFailedPrecondition);
  EXPECT_NE(status.message().find("--figures: /proc/none/figures"), std::string::npos) << status;
}

TEST_F(FigureDataTest, EndsAtAnInterrupt) {
  FigureData data = Data();
  ASSERT_TRUE(data.Open().ok());
  stop.request_stop();
  EXPECT_TRUE(absl::IsCancelled(data.Records("history", Spectrum()).status()));
}

}  // namespace
}  // namespace celt::cli
