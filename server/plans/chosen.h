#pragma once

#include <string>

#include "google/protobuf/message.h"

namespace celt::plans {

/// The analysis that was picked, and its field's name.
struct Chosen {
  std::string name;
  const google::protobuf::Message* analysis = nullptr;  ///< nullptr: none
};

/// Of a JobSpec or a SweepSpec, which must outlive the answer.
Chosen AnalysisOf(const google::protobuf::Message& message);

/// A count of an analysis, by its field's name; 0 for one that it doesn't have.
double Count(const google::protobuf::Message& analysis, const std::string& name);

/// Iterates of the section map that a resolved analysis asks for, transients counted; 0 when it
/// asks for something else.
double Iterates(const google::protobuf::Message& analysis);

}  // namespace celt::plans
