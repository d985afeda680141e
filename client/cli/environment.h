#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <ostream>
#include <stop_token>
#include <string>

#include "absl/status/statusor.h"
#include "grpcpp/channel.h"

namespace celt::cli {

/// A service in this process, alive as long as the object.
class EmbeddedService {
 public:
  virtual ~EmbeddedService() = default;
  virtual std::shared_ptr<grpc::Channel> channel() = 0;
};

struct EmbeddedOptions {
  std::string data_dir;        ///< empty: jobs live in memory
  std::optional<int> threads;  ///< that compute; one a core when left out
};

using StartEmbedded =
    std::function<absl::StatusOr<std::unique_ptr<EmbeddedService>>(const EmbeddedOptions&)>;

/// All that the command line knows of the world around it.
struct Environment {
  std::ostream* out = nullptr;  ///< data
  std::ostream* err = nullptr;  ///< messages and progress
  bool out_is_terminal = false;
  int progress_width = 0;  ///< columns of the terminal that shows progress; 0: there is none
  std::string server;      ///< of CELT_SERVER; empty for none
  std::string token;       ///< of CELT_TOKEN
  std::string token_file;  ///< of CELT_TOKEN_FILE
  std::string tls_ca;      ///< of CELT_TLS_CA
  std::string state_dir;   ///< where the embedded service keeps its data by default
  StartEmbedded start_embedded;
  std::stop_token interrupt;  ///< a stop is asked for at the first Ctrl-C
};

/// The directory by the XDG rules: $XDG_STATE_HOME/celt, else $HOME/.local/state/celt.
std::string DefaultStateDir();

}  // namespace celt::cli
