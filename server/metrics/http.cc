#include "server/metrics/http.h"

#include <thread>
#include <utility>

#include "absl/status/status.h"
#include "absl/strings/numbers.h"
#include "absl/strings/str_cat.h"
#include "httplib.h"

namespace celt::metrics {
namespace {

constexpr int kThreads = 4;
constexpr std::size_t kLargestBody = 1024;
constexpr int kSeconds = 5;
constexpr int kServiceUnavailable = 503;

void Configure(httplib::Server& server, const Pages& pages) {
  // httplib's own options would let two servers share the port.
  server.set_socket_options([](socket_t socket) {
    const int yes = 1;
    setsockopt(socket, SOL_SOCKET, SO_REUSEADDR, &yes, sizeof yes);
  });
  server.new_task_queue = [] { return new httplib::ThreadPool(kThreads); };
  server.set_payload_max_length(kLargestBody);
  server.set_read_timeout(kSeconds);
  server.set_write_timeout(kSeconds);
  server.set_keep_alive_timeout(kSeconds);
  server.Get("/metrics", [pages](const httplib::Request&, httplib::Response& response) {
    response.set_content(pages.metrics(), "text/plain; version=0.0.4");
  });
  server.Get("/livez", [](const httplib::Request&, httplib::Response& response) {
    response.set_content("alive\n", "text/plain");
  });
  server.Get("/readyz", [pages](const httplib::Request&, httplib::Response& response) {
    const bool ready = pages.ready();
    if (!ready) response.status = kServiceUnavailable;
    response.set_content(ready ? "ready\n" : "draining\n", "text/plain");
  });
}

}  // namespace

struct HttpServer::Impl {
  httplib::Server server;
  std::thread thread;
};

HttpServer::HttpServer() : impl_(std::make_unique<Impl>()) {}

HttpServer::~HttpServer() {
  if (!impl_->thread.joinable()) return;
  impl_->server.stop();
  impl_->thread.join();
}

absl::StatusOr<std::unique_ptr<HttpServer>> HttpServer::Start(const std::string& listen,
                                                              const Pages& pages) {
  std::unique_ptr<HttpServer> made(new HttpServer);
  httplib::Server& server = made->impl_->server;
  Configure(server, pages);
  const std::size_t colon = listen.rfind(':');
  const std::string host = listen.substr(0, colon);
  int port = 0;
  if (colon == std::string::npos || !absl::SimpleAtoi(listen.substr(colon + 1), &port)) {
    return absl::InvalidArgumentError(absl::StrCat("http: '", listen, "' is not HOST:PORT"));
  }
  if (port == 0) {
    port = server.bind_to_any_port(host);
  } else if (!server.bind_to_port(host, port)) {
    port = -1;
  }
  if (port < 0) {
    return absl::FailedPreconditionError(
        absl::StrCat("http: can't listen on ", listen,
                     ": the port is in use, or the address is not one of this machine"));
  }
  made->address_ = absl::StrCat(host, ":", port);
  made->impl_->thread = std::thread([&server] { server.listen_after_bind(); });
  // stop() does nothing before that.
  while (!server.is_running()) std::this_thread::yield();
  return made;
}

}  // namespace celt::metrics
