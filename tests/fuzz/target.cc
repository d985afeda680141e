#include "tests/fuzz/target.h"

#include <cstdlib>
#include <string>

#include "celt/v1/job.pb.h"
#include "server/jobs/page_token.h"
#include "server/plans/factory.h"
#include "server/plans/serialize.h"
#include "server/plans/spec.h"

namespace celt::fuzz {
namespace {

void Require(bool promise) {
  if (!promise) std::abort();
}

void TakeSpecification(std::string_view bytes) {
  v1::JobSpec spec;
  if (!spec.ParseFromArray(bytes.data(), static_cast<int>(bytes.size()))) return;
  const auto resolved = plans::ResolveSpec(spec);
  if (!resolved.ok()) return Require(!resolved.status().message().empty());
  const std::string once = plans::Serialize(*resolved);
  const auto again = plans::ResolveSpec(*resolved);
  Require(again.ok() && plans::Serialize(*again) == once);
  Require(plans::MakePlan(once).ok());
}

void TakePageToken(std::string_view text) {
  const auto token = jobs::DecodePageToken(text);
  if (!token.ok()) return;
  const auto again = jobs::DecodePageToken(jobs::Encode(*token));
  Require(again.ok() && again->before_serial == token->before_serial &&
          again->states == token->states);
}

}  // namespace

void TakeApart(std::string_view input) {
  if (input.empty()) return;
  const std::string_view rest = input.substr(1);
  return input.front() == 't' ? TakePageToken(rest) : TakeSpecification(rest);
}

}  // namespace celt::fuzz
