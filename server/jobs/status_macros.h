#pragma once

#include <utility>

#include "absl/status/status.h"

// What absl of this age lacks. For use inside the server only.

/// Returns the status of `expression` from the function around it unless it is OK.
#define CELT_RETURN_IF_ERROR(expression)                       \
  do {                                                         \
    absl::Status celt_status_of_call = (expression);           \
    if (!celt_status_of_call.ok()) return celt_status_of_call; \
  } while (false)

#define CELT_JOIN_INNER(a, b) a##b
#define CELT_JOIN(a, b) CELT_JOIN_INNER(a, b)

/// `declaration` = the value of the StatusOr `expression`, or returns its status.
#define CELT_ASSIGN_OR_RETURN(declaration, expression) \
  CELT_ASSIGN_OR_RETURN_AS(CELT_JOIN(celt_value_of_call_, __LINE__), declaration, expression)

// A declaration and a name can't stand in parentheses.
// NOLINTBEGIN(bugprone-macro-parentheses)
#define CELT_ASSIGN_OR_RETURN_AS(result, declaration, expression) \
  auto result = (expression);                                     \
  if (!result.ok()) return std::move(result).status();            \
  declaration = *std::move(result)
// NOLINTEND(bugprone-macro-parentheses)
