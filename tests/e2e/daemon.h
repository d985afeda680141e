#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "celt/v1/celt.grpc.pb.h"
#include "tests/e2e/process.h"
#include "tests/e2e/temporary_directory.h"

namespace celt {

/// A celtd on a free port of this machine, ready to be called.
class Daemon {
 public:
  /// `listen` other than a free port, to come back at the same address; `more` arguments.
  explicit Daemon(const std::string& data_dir, int workers = 2,
                  const std::string& listen = "127.0.0.1:0",
                  const std::vector<std::string>& more = {});

  /// "127.0.0.1:PORT".
  const std::string& address() const { return address_; }
  /// The same, for metrics and probes.
  const std::string& http() const { return http_; }
  Process& process() { return process_; }
  /// A stub with a connection of its own.
  std::unique_ptr<v1::Celt::Stub> Connect() const;

 private:
  Process process_;
  std::string address_;
  std::string http_;
};

/// A celt with a state folder of its own and no server in the environment.
class Celt {
 public:
  /// Runs celt to its end.
  Ended Run(const std::vector<std::string>& arguments) const;
  /// Starts celt.
  std::unique_ptr<Process> Start(const std::vector<std::string>& arguments) const;

 private:
  TemporaryDirectory state_;
};

/// The arguments and then more of them.
std::vector<std::string> With(std::vector<std::string> arguments,
                              const std::vector<std::string>& more);

}  // namespace celt
