#include "tests/e2e/daemon.h"

#include "grpcpp/grpcpp.h"
#include "gtest/gtest.h"

namespace celt {
namespace {

/// The address in a line that celtd says when it can be called.
std::string AddressIn(const std::string& line, const std::string& start) {
  EXPECT_TRUE(line.starts_with(start)) << line;
  return line.starts_with(start) ? line.substr(start.size()) : "";
}

}  // namespace

Daemon::Daemon(const std::string& data_dir, int workers, const std::string& listen,
               const std::vector<std::string>& more)
    : process_(CELTD_PROGRAM, With({"--listen", listen, "--http", "127.0.0.1:0", "--data-dir",
                                    data_dir, "--workers", std::to_string(workers)},
                                   more)),
      address_(AddressIn(process_.ReadLine(), "listening on ")),
      http_(AddressIn(process_.ReadLine(), "http on ")) {}

std::unique_ptr<v1::Celt::Stub> Daemon::Connect() const {
  grpc::ChannelArguments arguments;
  arguments.SetInt(GRPC_ARG_ENABLE_HTTP_PROXY, 0);
  arguments.SetInt(GRPC_ARG_USE_LOCAL_SUBCHANNEL_POOL, 1);
  return v1::Celt::NewStub(
      grpc::CreateCustomChannel(address_, grpc::InsecureChannelCredentials(), arguments));
}

std::unique_ptr<Process> Celt::Start(const std::vector<std::string>& arguments) const {
  return std::make_unique<Process>(
      CELT_PROGRAM, arguments,
      std::map<std::string, std::string>{{"XDG_STATE_HOME", state_.path()}, {"CELT_SERVER", ""}});
}

Ended Celt::Run(const std::vector<std::string>& arguments) const {
  return Start(arguments)->Wait();
}

std::vector<std::string> With(std::vector<std::string> arguments,
                              const std::vector<std::string>& more) {
  arguments.insert(arguments.end(), more.begin(), more.end());
  return arguments;
}

}  // namespace celt
