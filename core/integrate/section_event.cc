#include "core/integrate/section_event.h"

#include <cmath>

namespace celt {
namespace {

using Eigen::Vector3d;

/// S, proportional to sin g.
double Sine(const StoneState& y) { return y[1] * y[3] - y[0] * y[4]; }

/// C, proportional to cos g.
double Cosine(const StoneState& y) {
  const Vector3d momentum = y.head<3>();
  const double G = momentum.norm();
  return y[2] * momentum.dot(y.tail<3>()) / G - G * y[5];
}

StoneState SineGradient(const StoneState& y) {
  StoneState gradient;
  gradient << -y[4], y[3], 0, y[1], -y[0], 0;
  return gradient;
}

StoneState CosineGradient(const StoneState& y) {
  const Vector3d momentum = y.head<3>();
  const Vector3d gamma = y.tail<3>();
  const double G = momentum.norm();
  const double p = y[2] / G;
  const double q = momentum.dot(gamma) / G;
  // C = L H/G − G γ₃, and dG = (M/G)·dM.
  StoneState gradient;
  gradient << p * gamma - (p * q + y[5]) / G * momentum + q * Vector3d::UnitZ(),
      p * momentum - G * Vector3d::UnitZ();
  return gradient;
}

}  // namespace

SectionEvent::SectionEvent(double angle, Crossings crossings)
    : cos_(std::cos(angle)),
      sin_(std::sin(angle)),
      sense_(crossings == Crossings::kIncreasing ? 1 : -1) {}

double SectionEvent::Value(const StoneState& state) const {
  return sense_ * (Sine(state) * cos_ - Cosine(state) * sin_);
}

double SectionEvent::Side(const StoneState& state) const {
  return Sine(state) * sin_ + Cosine(state) * cos_;
}

StoneState SectionEvent::Gradient(const StoneState& state) const {
  return sense_ * (SineGradient(state) * cos_ - CosineGradient(state) * sin_);
}

}  // namespace celt
