// Specifications that are wrong, over gRPC: each is answered with INVALID_ARGUMENT that names the
// field, in the message and in its details, and nothing is kept.

#include <memory>
#include <string>
#include <vector>

#include "gmock/gmock.h"
#include "gtest/gtest.h"
#include "host/host_testing.h"
#include "server/api/error_details.pb.h"

namespace celt::host {
namespace {

using ::testing::HasSubstr;

struct Bad {
  const char* spec;
  const char* field;
};

const std::vector<Bad>& BadSpecs() {
  static const auto& bad = *new std::vector<Bad>{
      // What the job is about.
      {"", "analysis"},
      {"system { name: 'henon3d' }", "analysis"},
      {"system { name: 'top' } lyapunov {}", "system"},
      {"system { name: 'Lorenz' } lyapunov {}", "system"},
      {"system { name: '\\000' } lyapunov {}", "system"},
      {"system { parameters { key: 'energie' value: 1 } } lyapunov {}", "energie"},
      {"system { parameters { key: '' value: 1 } } lyapunov {}", "system.parameters"},
      {"system { parameters { key: 'energy' value: nan } } lyapunov {}", "energy"},
      {"system { parameters { key: 'energy' value: inf } } lyapunov {}", "energy"},
      {"system { parameters { key: 'energy' value: -inf } } lyapunov {}", "energy"},
      {"system { parameters { key: 'energy' value: 50 } } lyapunov {}", "energy"},
      {"system { parameters { key: 'mass' value: 0 } } lyapunov {}", "mass"},
      {"system { parameters { key: 'mass' value: -1 } } lyapunov {}", "mass"},
      {"system { parameters { key: 'mass' value: nan } } lyapunov {}", "mass"},
      {"system { parameters { key: 'gravity' value: -9.8 } } lyapunov {}", "gravity"},
      {"system { parameters { key: 'gravity' value: nan } } lyapunov {}", "gravity"},
      {"system { parameters { key: 'height' value: 0 } } lyapunov {}", "height"},
      {"system { parameters { key: 'height' value: inf } } lyapunov {}", "height"},
      {"system { parameters { key: 'radius_1' value: -9 } } lyapunov {}", "radius_1"},
      {"system { parameters { key: 'radius_2' value: 0 } } lyapunov {}", "radius_2"},
      {"system { parameters { key: 'inertia_1' value: 0 } } lyapunov {}", "inertia_1"},
      {"system { parameters { key: 'inertia_2' value: -6 } } lyapunov {}", "inertia_2"},
      {"system { parameters { key: 'inertia_3' value: 9 } } lyapunov {}", "inertia_3"},
      {"system { parameters { key: 'delta' value: nan } } lyapunov {}", "delta"},
      {"system { parameters { key: 'section_angle' value: nan } } lyapunov {}", "section_angle"},
      {"system { name: 'henon3d' parameters { key: 'c' value: 1 } } lyapunov {}", "c"},
      {"system { name: 'henon3d' parameters { key: 'b' value: nan } } lyapunov {}", "b"},
      {"system { name: 'henon3d' parameters { key: 'm2' value: inf } } lyapunov {}", "m2"},
      {"system { name: 'lorenz' parameters { key: 'energy' value: 1 } } lyapunov {}", "energy"},
      {"system { name: 'lorenz' parameters { key: 'sigma' value: nan } } lyapunov {}", "sigma"},
      // How it is computed.
      {"numerics { tolerance: 0 } lyapunov {}", "tolerance"},
      {"numerics { tolerance: 1 } lyapunov {}", "tolerance"},
      {"numerics { tolerance: -1e-9 } lyapunov {}", "tolerance"},
      {"numerics { tolerance: nan } lyapunov {}", "tolerance"},
      {"numerics { tolerance: 1e-30 } lyapunov {}", "tolerance"},
      {"numerics { engine: 99 } lyapunov {}", "engine"},
      {"frame: 99 lyapunov {}", "frame"},
      {"frame: FRAME_PAPER system { name: 'henon3d' } lyapunov {}", "frame"},
      // Points.
      {"lyapunov { start { l: 1 } }", "l_over_g"},
      {"lyapunov { start { l: 1 l_over_g: 0.1 } }", "h_over_g"},
      {"lyapunov { start { l: nan l_over_g: -0.6 h_over_g: -0.3 } }", "l"},
      {"lyapunov { start { l: 2 l_over_g: 1 h_over_g: -0.3 } }", "l_over_g"},
      {"lyapunov { start { l: 2 l_over_g: -0.6 h_over_g: -1.5 } }", "h_over_g"},
      {"lyapunov { start { l: 2 l_over_g: 0.6 h_over_g: -0.8 } }", "start"},
      {"lyapunov { start { x: [1, 2, 3] } }", "x"},
      {"lyapunov { start { l: 2 l_over_g: -0.6 h_over_g: -0.3 x: 1 } }", "x"},
      {"system { name: 'henon3d' } lyapunov { start { x: [1, 2] } }", "point"},
      {"system { name: 'henon3d' } lyapunov { start { x: [1, 2, 3, 4] } }", "point"},
      {"system { name: 'henon3d' } lyapunov { start { x: [1, 2, nan] } }", "z"},
      {"system { name: 'henon3d' } lyapunov { start { x: [1, 2, inf] } }", "z"},
      {"system { name: 'henon3d' } lyapunov { start { x: [1,2,3,4,5,6,7,8,9,10,11,12] } }", "x"},
      {"system { name: 'henon3d' } lyapunov { start { l: 1 l_over_g: 0 h_over_g: 0 } }", "l"},
      {"system { name: 'lorenz' } section { start { x: [1] } }", "start"},
      // Spectra.
      {"lyapunov { iterates: 0 }", "iterates"},
      {"lyapunov { iterates: -1 }", "iterates"},
      {"lyapunov { iterates: 9223372036854775807 }", "iterates"},
      {"lyapunov { iterates: 7 orbits: 8 }", "iterates"},
      {"lyapunov { orbits: 0 }", "orbits"},
      {"lyapunov { orbits: -3 }", "orbits"},
      {"lyapunov { orbits: 4097 }", "orbits"},
      {"lyapunov { transient: -1 }", "transient"},
      {"lyapunov { transient: 9223372036854775807 }", "transient"},
      // Sections.
      {"section { iterates: 0 }", "iterates"},
      {"section { iterates: -5 }", "iterates"},
      {"section { iterates: 9223372036854775807 }", "iterates"},
      {"section { transient: -1 }", "transient"},
      {"section { transient: 9223372036854775807 }", "transient"},
      {"section { direction: 9 }", "direction"},
      {"section { start { l: 2 l_over_g: 2 h_over_g: 0 } }", "start"},
      // Orbits of the flow.
      {"orbit { time: 0 }", "time"},
      {"orbit { time: -1 }", "time"},
      {"orbit { time: nan }", "time"},
      {"orbit { time: inf }", "time"},
      {"orbit { step: 0 }", "step"},
      {"orbit { step: -0.1 }", "step"},
      {"orbit { step: nan }", "step"},
      {"orbit { turns: 0 }", "turns"},
      {"orbit { turns: nan }", "turns"},
      {"orbit { direction: 9 }", "direction"},
      {"orbit { state: [1, 2] }", "state"},
      {"orbit { state: [0, 0, nan, 0, 0, 1] }", "state"},
      {"orbit { state: [0, 0, 1, 0, 0, 1] start { l: 1 l_over_g: 0 h_over_g: 0 } }", "state"},
      {"system { name: 'henon3d' } orbit {}", "system"},
      // Cycles.
      {"fixed_point { period: 0 }", "period"},
      {"fixed_point { period: 257 }", "period"},
      {"fixed_point { search: -1 }", "search"},
      {"fixed_point { search: 9223372036854775807 }", "search"},
      {"fixed_point { search: 5 near { l: 2 l_over_g: -0.6 h_over_g: -0.3 } }", "near"},
      {"fixed_point { near { l: 2 } }", "near"},
      {"fixed_point { newton_tolerance: 0 }", "newton_tolerance"},
      {"fixed_point { newton_tolerance: nan }", "newton_tolerance"},
      {"fixed_point { newton_iterations: 0 }", "newton_iterations"},
      {"fixed_point { lower { l: 0 l_over_g: 0 h_over_g: 0 } }", "lower"},
      // Branches.
      {"continuation {}", "to"},
      {"continuation { parameter: 'energie' from: 1 to: 2 }", "parameter"},
      {"continuation { parameter: ' ' from: 752 to: 751 }", "parameter"},
      {"continuation { parameter: 'energy' from: 752 }", "to"},
      {"continuation { parameter: 'energy' from: nan to: 750 }", "from"},
      {"continuation { parameter: 'energy' from: 752 to: inf }", "to"},
      {"continuation { parameter: 'energy' from: 752 to: 752 }", "to"},
      {"continuation { parameter: 'energy' from: 752 to: 751 period: 0 }", "period"},
      {"continuation { parameter: 'energy' from: 752 to: 751 longest_step: 0 }", "longest_step"},
      {"continuation { parameter: 'energy' from: 752 to: 751 longest_step: nan }", "longest_step"},
      {"continuation { parameter: 'energy' from: 752 to: 751 most_points: 0 }", "most_points"},
      {"continuation { parameter: 'energy' from: 752 to: 751 doublings: -1 }", "doublings"},
      // Manifolds and separatrices.
      {"manifold { period: 0 }", "period"},
      {"manifold { length: 0 }", "length"},
      {"manifold { length: nan }", "length"},
      {"manifold { spacing: -1 }", "spacing"},
      {"manifold { turning: 0 }", "turning"},
      {"manifold { most_points: 0 }", "most_points"},
      {"manifold { near { l_over_g: 1 } }", "near"},
      {"separatrix {}", "from"},
      {"separatrix { parameter: 'energy' from: 751 }", "to"},
      {"separatrix { parameter: 'energy' from: 751 to: 752 width: 0 }", "width"},
      {"separatrix { parameter: 'energy' from: 751 to: 752 question: 9 }", "question"},
      {"separatrix { parameter: 'energy' from: 751 to: 752 side: 2 }", "side"},
      {"separatrix { parameter: 'energy' from: 751 to: 752 most_iterates: 0 }", "most_iterates"},
      // Pseudo-hyperbolicity, and the paper.
      {"hyperbolicity { iterates: 0 }", "iterates"},
      {"hyperbolicity { transient: -1 }", "transient"},
      {"hyperbolicity { scout: -1 }", "scout"},
      {"system { name: 'lorenz' } reproduce {}", "system"},
      // Sweeps.
      {"sweep {}", "axes"},
      {"sweep { lyapunov {} }", "axes"},
      {"sweep { axes { parameter: 'energy' from: 1 to: 2 nodes: 3 } }", "analysis"},
      {"sweep { axes { parameter: 'energie' from: 1 to: 2 nodes: 3 } lyapunov {} }", "axes[0]"},
      {"sweep { axes { parameter: 'energy' to: 752 nodes: 3 } lyapunov {} }", "axes[0].from"},
      {"sweep { axes { parameter: 'energy' from: 752 nodes: 3 } lyapunov {} }", "axes[0].to"},
      {"sweep { axes { parameter: 'energy' from: 752 to: 753 } lyapunov {} }", "axes[0].nodes"},
      {"sweep { axes { parameter: 'energy' from: 752 to: 753 nodes: 1 } lyapunov {} }",
       "axes[0].nodes"},
      {"sweep { axes { parameter: 'energy' from: 752 to: 752 nodes: 3 } lyapunov {} }",
       "axes[0].to"},
      {"sweep { axes { parameter: 'energy' from: nan to: 752 nodes: 3 } lyapunov {} }", "axes[0]"},
      {"sweep { axes { parameter: 'energy' from: 752 to: 753 nodes: 20000000 } lyapunov {} }",
       "axes[0].nodes"},
      {"sweep { axes { parameter: 'energy' from: 752 to: 753 nodes: 5000 } "
       "axes { parameter: 'delta' from: 0.1 to: 0.2 nodes: 5000 } lyapunov {} }",
       "axes"},
      {"sweep { axes { parameter: 'energy' from: 752 to: 753 nodes: 3 } "
       "axes { parameter: 'energy' from: 752 to: 753 nodes: 3 } lyapunov {} }",
       "axes[1].parameter"},
      {"sweep { axes { parameter: 'energy' from: 752 to: 753 nodes: 3 } "
       "lyapunov { iterates: 0 } }",
       "iterates"},
      {"sweep { follow: true axes { parameter: 'energy' from: 752 to: 753 nodes: 3 } "
       "fixed_point {} }",
       "follow"},
  };
  return bad;
}

TEST(BadSpecs, AreRefusedByTheirField) {
  const auto host = StartHost();
  const auto stub = v1::Celt::NewStub(host->InProcessChannel());
  ASSERT_GE(BadSpecs().size(), 100U);
  for (const Bad& bad : BadSpecs()) {
    SCOPED_TRACE(bad.spec);
    const grpc::Status status = TrySubmit(*stub, bad.spec);
    EXPECT_EQ(status.error_code(), grpc::StatusCode::INVALID_ARGUMENT) << status.error_message();
    EXPECT_THAT(status.error_message(), HasSubstr(bad.field));
    google::rpc::Status details;
    google::rpc::BadRequest request;
    EXPECT_TRUE(details.ParseFromString(status.error_details()));
    EXPECT_EQ(details.details_size(), 1) << status.error_message();
    if (details.details().empty()) continue;
    EXPECT_TRUE(details.details(0).UnpackTo(&request));
    EXPECT_THAT(request.field_violations(0).field(), HasSubstr(bad.field));
  }
  grpc::ClientContext context;
  v1::ListJobsResponse jobs;
  ASSERT_TRUE(stub->ListJobs(&context, {}, &jobs).ok());
  EXPECT_EQ(jobs.jobs_size(), 0);
}

}  // namespace
}  // namespace celt::host
