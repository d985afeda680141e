#pragma once

#include "core/map/map.h"

namespace celt {

/// The flow of an autonomous ordinary differential equation ẋ = f(x) of few dimensions: what an
/// integrator has to know of it. Implementations are immutable and safe to use from many threads.
class Flow {
 public:
  virtual ~Flow() = default;
  Flow() = default;
  Flow(const Flow&) = delete;
  Flow& operator=(const Flow&) = delete;

  /// n, at most kMaxDimension.
  virtual int dimension() const = 0;
  /// f(x), n entries. May be asked outside the domain: any value will do there, NaN included.
  virtual Point Field(const Point& x) const = 0;
  /// ∂f/∂x, n×n, exact: row i is component i of f.
  virtual SquareMatrix FieldJacobian(const Point& x) const = 0;
  /// False where the field is not defined; an orbit that comes there is lost.
  virtual bool InDomain(const Point& x) const {
    static_cast<void>(x);
    return true;
  }
};

}  // namespace celt
