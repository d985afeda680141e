#pragma once

#include <functional>
#include <memory>
#include <string>

#include "absl/status/statusor.h"

namespace celt::metrics {

/// What the HTTP port answers with. Called from several threads.
struct Pages {
  std::function<std::string()> metrics;
  /// Whether jobs are taken. A process that is alive may not be ready: it drains.
  std::function<bool()> ready;
};

/// GET /metrics for Prometheus, /livez (200 as long as the process answers) and /readyz (200, or
/// 503 while it takes no jobs). Nothing else is there; bodies are not read.
class HttpServer {
 public:
  /// `listen` is "host:port", port 0 for a free one. FAILED_PRECONDITION: nothing can listen there.
  static absl::StatusOr<std::unique_ptr<HttpServer>> Start(const std::string& listen,
                                                           const Pages& pages);
  ~HttpServer();
  HttpServer(const HttpServer&) = delete;
  HttpServer& operator=(const HttpServer&) = delete;

  /// With the port that it got.
  const std::string& address() const { return address_; }

 private:
  HttpServer();
  struct Impl;
  std::unique_ptr<Impl> impl_;
  std::string address_;
};

}  // namespace celt::metrics
