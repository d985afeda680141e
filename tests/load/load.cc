#include "tests/load/load.h"

#include <algorithm>
#include <fstream>
#include <memory>
#include <mutex>
#include <thread>
#include <vector>

#include "google/protobuf/text_format.h"
#include "grpcpp/grpcpp.h"
#include "tests/e2e/daemon.h"

namespace celt::load {
namespace {

using Clock = std::chrono::steady_clock;
using Stub = v1::Celt::Stub;

/// Some milliseconds of one core.
constexpr const char* kSmall = "system { name: 'henon3d' } lyapunov { iterates: 20000 orbits: 2 }";
/// Several megabytes of stream.
constexpr const char* kLarge = "system { name: 'henon3d' } section { iterates: 100000 }";
/// Units of about a second, for hours.
constexpr const char* kSweep =
    "sweep { axes { parameter: 'energy' from: 749 to: 755 nodes: 1000000 } "
    "lyapunov { iterates: 20000 orbits: 8 } }";

double MillisecondsSince(Clock::time_point began) {
  return std::chrono::duration<double, std::milli>(Clock::now() - began).count();
}

double Median(std::vector<double> values) {
  if (values.empty()) return 0;
  std::nth_element(values.begin(), values.begin() + std::ssize(values) / 2, values.end());
  return values[values.size() / 2];
}

double PeakMegabytes(pid_t pid) {
  std::ifstream status("/proc/" + std::to_string(pid) + "/status");
  constexpr double kKilobytes = 1024;
  for (std::string word; status >> word;) {
    double value = 0;
    if (word == "VmHWM:" && status >> value) return value / kKilobytes;
  }
  return 0;
}

class Load {
 public:
  explicit Load(const Options& options) : options_(options), daemon_(data_.path()) {}

  Report Run() {
    const auto stub = daemon_.Connect();
    expected_ = AnswerOf(*stub, Submit(*stub, kSmall));
    report_.alone_ms = TimeSmallJobs(*stub);
    const std::string sweep = Submit(*stub, kSweep);
    report_.beside_ms = TimeSmallJobs(*stub);
    const std::string large = Submit(*stub, kLarge);
    AnswerOf(*stub, large);
    {
      std::vector<std::unique_ptr<Stalled>> stalled;
      for (int i = 0; i < options_.stalled; ++i) {
        stalled.push_back(std::make_unique<Stalled>(daemon_, large));
      }
      Crowd(sweep);
    }
    report_.peak_megabytes = PeakMegabytes(daemon_.process().pid());
    return report_;
  }

 private:
  /// Opens a stream, reads a message, and then nothing until its end.
  struct Stalled {
    Stalled(const Daemon& daemon, const std::string& id) : stub(daemon.Connect()) {
      v1::StreamResultsRequest request;
      request.set_id(id);
      reader = stub->StreamResults(&context, request);
      v1::StreamResultsResponse message;
      reader->Read(&message);
    }
    ~Stalled() {
      context.TryCancel();
      static_cast<void>(reader->Finish());
    }
    std::unique_ptr<Stub> stub;
    grpc::ClientContext context;
    std::unique_ptr<grpc::ClientReader<v1::StreamResultsResponse>> reader;
  };

  void Fail(const std::string& why) {
    const std::lock_guard lock(mutex_);
    ++report_.errors;
    if (report_.first_error.empty()) report_.first_error = why;
  }

  std::string Submit(Stub& stub, const char* spec) {
    v1::SubmitJobRequest request;
    google::protobuf::TextFormat::ParseFromString(spec, request.mutable_spec());
    request.set_fresh(true);
    grpc::ClientContext context;
    v1::Job job;
    const grpc::Status status = stub.SubmitJob(&context, request, &job);
    if (!status.ok()) Fail(status.error_message());
    return job.id();
  }

  std::string AnswerOf(Stub& stub, const std::string& id) {
    grpc::ClientContext context;
    v1::StreamResultsRequest request;
    request.set_id(id);
    const auto reader = stub.StreamResults(&context, request);
    std::string bytes;
    for (v1::StreamResultsResponse message; reader->Read(&message);) {
      bytes += message.SerializeAsString();
    }
    const grpc::Status status = reader->Finish();
    if (!status.ok()) Fail(status.error_message());
    return bytes;
  }

  void AskASmallJob(Stub& stub) {
    const bool same = AnswerOf(stub, Submit(stub, kSmall)) == expected_;
    const std::lock_guard lock(mutex_);
    ++report_.jobs;
    if (!same) ++report_.lost_records;
  }

  double TimeSmallJobs(Stub& stub) {
    std::vector<double> times;
    for (int i = 0; i < options_.timed; ++i) {
      const auto began = Clock::now();
      AskASmallJob(stub);
      times.push_back(MillisecondsSince(began));
    }
    return Median(times);
  }

  void DropStreams(const std::string& id) {
    const auto stub = daemon_.Connect();
    v1::StreamResultsRequest request;
    request.set_id(id);
    for (int i = 0; i < options_.dropped; ++i) {
      grpc::ClientContext context;
      const auto reader = stub->StreamResults(&context, request);
      context.TryCancel();
      const auto code = reader->Finish().error_code();
      if (code != grpc::StatusCode::CANCELLED) Fail("a dropped stream ended otherwise");
    }
  }

  void Crowd(const std::string& sweep) {
    const auto began = Clock::now();
    {
      std::vector<std::jthread> clients;
      clients.emplace_back([&] { DropStreams(sweep); });
      for (int i = 0; i < options_.clients; ++i) {
        clients.emplace_back([&] {
          const auto stub = daemon_.Connect();
          for (int job = 0; job < options_.jobs_each; ++job) AskASmallJob(*stub);
        });
      }
    }
    report_.seconds = MillisecondsSince(began) / 1000;
  }

  const Options options_;
  TemporaryDirectory data_;
  Daemon daemon_;
  std::string expected_;
  std::mutex mutex_;
  Report report_;
};

}  // namespace

Report Run(const Options& options) { return Load(options).Run(); }

std::string Text(const Report& report) {
  const auto line = [](const char* name, double value, const char* unit) {
    return std::string(name) + ": " + std::to_string(value) + unit + "\n";
  };
  return line("small jobs answered", report.jobs, "") + line("errors", report.errors, "") +
         line("streams with other bytes", report.lost_records, "") +
         line("seconds of the crowd", report.seconds, " s") +
         line("peak resident memory of the server", report.peak_megabytes, " MB") +
         line("median answer, idle server", report.alone_ms, " ms") +
         line("median answer beside a sweep", report.beside_ms, " ms") +
         (report.first_error.empty() ? "" : "first error: " + report.first_error + "\n");
}

}  // namespace celt::load
