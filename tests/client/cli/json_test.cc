#include "client/cli/json.h"

#include "gtest/gtest.h"
#include "tests/client/fake_service.h"

namespace celt::cli {
namespace {

TEST(Json, RecordIsOneLineOfTheStandardMapping) {
  v1::Record record;
  record.set_sequence(1);
  record.mutable_lyapunov()->set_iterates(40);
  record.mutable_lyapunov()->add_exponents_per_iterate(0.1);
  record.mutable_lyapunov()->set_mean_return_time(0);
  EXPECT_EQ(ToJson(record),
            R"({"sequence":"1","lyapunov":{"iterates":"40","exponentsPerIterate":[0.1],)"
            R"("meanReturnTime":0}})");
}

TEST(Json, ResultIsWhatIsInItsOneof) {
  v1::Result result;
  result.mutable_lyapunov()->set_orbits(8);
  EXPECT_EQ(ResultJson(result), R"({"result":{"orbits":8}})");
}

TEST(Json, MapsComeInTheOrderOfTheirKeys) {
  v1::System system;
  for (const char* name : {"mass", "delta", "energy", "a", "z", "gravity"}) {
    (*system.mutable_parameters())[name] = 1;
  }
  EXPECT_EQ(ToJson(system),
            R"({"parameters":{"a":1,"delta":1,"energy":1,"gravity":1,"mass":1,"z":1}})");
}

TEST(Json, AnalysisIsTheMemberOfTheOneof) {
  v1::JobSpec spec;
  EXPECT_EQ(AnalysisField(spec), "");
  spec.mutable_lyapunov();
  EXPECT_EQ(AnalysisField(spec), "lyapunov");
  EXPECT_EQ(AnalysisField(RecordMessage(1).record()), "lyapunov");
  EXPECT_EQ(AnalysisField(ResultMessage().result()), "lyapunov");
}

}  // namespace
}  // namespace celt::cli
