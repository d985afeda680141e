#include "client/cli/service_options.h"

#include "client/cli/option.h"
#include "client/cli/parse.h"

namespace celt::cli {
namespace {

constexpr char kGroup[] = "Service";
constexpr int kMostThreads = 1024;

void AddAddress(CLI::App& app, std::optional<std::string>& target) {
  app.add_option_function<std::string>(
         "--server",
         [&target](const std::string& text) {
           auto address = ParseAddress(text);
           if (!address.ok()) {
             throw CLI::ValidationError("--server", std::string(address.status().message()));
           }
           target = *std::move(address);
         },
         "a running celtd (default: $CELT_SERVER, else none: compute here)")
      ->group(kGroup)
      ->type_name("HOST:PORT");
}

void AddFile(CLI::App& app, const char* name, std::optional<std::string>& target,
             const char* description) {
  app.add_option(name, target, description)->group(kGroup)->type_name("FILE");
}

}  // namespace

void ServiceOptions::AddTo(CLI::App& app) {
  AddAddress(app, server);
  AddFile(app, "--token-file", token_file,
          "with the server's token (default: $CELT_TOKEN_FILE or $CELT_TOKEN)");
  app.add_flag("--tls", tls, "encrypt, and trust the system's authorities")->group(kGroup);
  AddFile(app, "--tls-ca", tls_ca, "encrypt, and trust these authorities (default: $CELT_TLS_CA)");
  AddFile(app, "--tls-certificate", tls_certificate, "this client's certificate, with --tls-key");
  AddFile(app, "--tls-key", tls_key, "its private key");
  AddNumber(app, "--reconnect", reconnect,
            {kGroup, "SECONDS", "how long to try again when a stream breaks off (default 30)"});
  app.add_option("--data-dir", data_dir,
                 "where jobs are kept when computing here (default: XDG state folder)")
      ->group(kGroup)
      ->type_name("DIR");
  AddInteger(app, "--threads", threads,
             {kGroup, "N", "threads when computing here (default: one a core)"},
             {.lowest = 1, .highest = kMostThreads});
  AddChoice(app, "--output", {"table", "json", "csv"}, output,
            {"Output", "table|json|csv", "default: table on a terminal, else json"});
}

OutputFormat ServiceOptions::Format(const Environment& environment) const {
  if (output) return static_cast<OutputFormat>(*output);
  return environment.out_is_terminal ? OutputFormat::kTable : OutputFormat::kJson;
}

std::string ServiceOptions::Server(const Environment& environment) const {
  return server.value_or(environment.server);
}

}  // namespace celt::cli
