#pragma once

#include <cstdint>
#include <functional>
#include <span>
#include <vector>

#include "Eigen/Core"
#include "absl/functional/function_ref.h"
#include "absl/status/status.h"
#include "absl/status/statusor.h"

namespace celt {

/// The largest dimension of a map; points and Jacobians live on the stack.
inline constexpr int kMaxDimension = 8;

/// A point of the map's domain, in the map's own coordinates (its header says which and in what
/// units).
using Point = Eigen::Matrix<double, Eigen::Dynamic, 1, Eigen::ColMajor, kMaxDimension, 1>;

/// A square matrix acting on tangent vectors at a point.
using SquareMatrix = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::ColMajor,
                                   kMaxDimension, kMaxDimension>;

enum class Direction { kForward, kBackward };
enum class Derivative { kNone, kJacobian };

/// One application of a map to a point.
struct Image {
  Point point;
  /// Time the underlying flow took, positive in both directions; exactly 1 for a map that is no
  /// section of a flow.
  double time = 1;
  /// DF at the preimage, D(row i of image, column j of preimage); 0×0 when it was not asked for.
  SquareMatrix jacobian;
  /// Largest relative drift on the way of what the underlying flow conserves: an integrator's
  /// error. 0 where there is no such thing.
  double drift = 0;
};

/// What to ask of each orbit in Map::Advance.
struct Advance {
  std::int64_t iterates = 1;
  Direction direction = Direction::kForward;
  Derivative derivative = Derivative::kNone;
};

/// Called after each iterate of each orbit, with the orbit's index among the starts; false ends
/// that orbit (with an OK status). Calls for one orbit come in its own order; how different orbits
/// interleave is unspecified.
using Visit = absl::FunctionRef<bool(int orbit, const Image& image)>;

/// A symmetry S of a map F: S∘F = F∘S, or, one that reverses time, S∘F = F⁻¹∘S. It takes cycles to
/// cycles, with the same multipliers or, reversing time, with their reciprocals.
struct Symmetry {
  std::function<Point(const Point&)> apply;
  bool reverses_time = false;
};

/// A map with a Jacobian: all that an analysis may know of a dynamical system.
///
/// Section maps of flows, flows sampled in time and maps given by a formula are all of this kind,
/// so that every analysis is written once. Implementations are immutable and safe to use from many
/// threads at once. The image of a point depends on that point and the map's parameters alone, to
/// the last bit: not on neighbours, threads or order.
class Map {
 public:
  virtual ~Map() = default;
  Map() = default;
  Map(const Map&) = delete;
  Map& operator=(const Map&) = delete;

  virtual int dimension() const = 0;

  /// Whether a point lies in the domain, without computing its image: INVALID_ARGUMENT names the
  /// coordinate, its value and the allowed range. The base class asks for a finite point of the
  /// right dimension.
  virtual absl::Status CheckPoint(const Point& x) const;

  /// Applies the map, or its inverse, once. INVALID_ARGUMENT: `x` lies outside the domain (the
  /// message names the coordinate, its value and the allowed range). OUT_OF_RANGE: the orbit left
  /// the domain on the way (the message says when and in what state). UNIMPLEMENTED: the map has no
  /// inverse.
  virtual absl::StatusOr<Image> Apply(const Point& x, Direction direction,
                                      Derivative derivative) const = 0;

  /// Advances independent orbits, each from its own start, and tells `visit` every iterate. Returns
  /// one status per orbit, as of Apply; an orbit that fails does not disturb the others. The base
  /// class goes orbit by orbit; a map with a faster way to advance many at once overrides this.
  virtual std::vector<absl::Status> AdvanceAll(std::span<const Point> starts,
                                               const Advance& advance, Visit visit) const;

  /// a − b as a tangent vector: coordinates that are angles are reduced to (−π, π]. The default is
  /// a − b.
  virtual Point Difference(const Point& a, const Point& b) const { return a - b; }

  /// The symmetries that are known, all elements of their group but the identity. Default: none.
  virtual std::vector<Symmetry> Symmetries() const { return {}; }
};

}  // namespace celt
