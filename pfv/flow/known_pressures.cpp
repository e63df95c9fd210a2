#include "pfv/flow/known_pressures.hpp"

#include "pfv/flow/containing_pore.hpp"
#include "pfv/problem/error.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>

#include <utility>

namespace pfv {
namespace {

constexpr double round_off = 1e-9; // of the largest pressure of all
constexpr int first_point = 6;

struct LargestPressure {
  double operator()(const SlipWall&) const { return 0; }
  double operator()(const Pressure& pressure) const { return std::abs(pressure.value); }
  double operator()(const Flux&) const { return 0; }
  double operator()(const Periodic&) const { return 0; }
  double operator()(const PressureProfile& profile) const {
    double largest = 0;
    for (const auto& point : profile.points)
      largest = std::max(largest, std::abs(point.pressure));
    return largest;
  }
};

double largest_of(const FaceConditions& faces, std::span<const PressurePoint> points, const Vec3& rise) {
  double largest = rise.cwiseAbs().maxCoeff();
  for (const FaceCondition& face : faces)
    largest = std::max(largest, std::visit(LargestPressure{}, face));
  for (const PressurePoint& point : points)
    largest = std::max(largest, std::abs(point.value));
  return largest;
}

struct MeanPressure {
  std::optional<double> operator()(const SlipWall&) const { return std::nullopt; }
  std::optional<double> operator()(const Pressure& pressure) const { return pressure.value; }
  std::optional<double> operator()(const Flux&) const { return std::nullopt; }
  std::optional<double> operator()(const Periodic&) const { return std::nullopt; }
  std::optional<double> operator()(const PressureProfile& profile) const {
    double sum = 0;
    for (const auto& point : profile.points)
      sum += point.pressure;
    return sum / static_cast<double>(profile.points.size());
  }
};

class Collector {
public:
  Collector(const FaceConditions& faces, double tolerance, PoreGroups& groups, std::size_t pores)
      : faces_(faces), tolerance_(tolerance), groups_(groups) {
    known_.source.assign(pores, KnownPressures::no_source);
    known_.value.assign(pores, 0);
  }

  /// `value` as at the first pore of the group.
  void set(int pore, int source, double value) {
    const int first = groups_.find(pore);
    int& known = known_.source[first];
    if (known == source && source < first_point)
      return;
    if (known >= 0 && known != source &&
        (pumps(known) || pumps(source) || std::abs(known_.value[first] - value) > tolerance_)) {
      std::string one = name(known, known_.value[first]), other = name(source, value);
      if (source < known)
        std::swap(one, other);
      throw SolveError(fmt::format("{} and {} meet in one pore: they must have the same pressure", one, other));
    }
    if (known >= 0)
      return;
    known = source;
    known_.value[first] = value;
  }

  KnownPressures spread() && {
    for (std::size_t i = 0; i < known_.source.size(); ++i) {
      const int first = groups_.find(static_cast<int>(i));
      known_.source[i] = known_.source[first];
      known_.value[i] = known_.value[first];
    }
    return std::move(known_);
  }

private:
  bool pumps(int source) const { return source < first_point && std::holds_alternative<Flux>(faces_[source]); }

  std::string name(int source, double pressure) const {
    if (source >= first_point)
      return fmt::format("pressure point {} ({} Pa)", source - first_point, pressure);
    if (pumps(source))
      return fmt::format("{} (flux {} m^3/s)", face_names[source], std::get<Flux>(faces_[source]).value);
    return fmt::format("{} ({} Pa)", face_names[source], pressure);
  }

  const FaceConditions& faces_;
  double tolerance_; // Pa
  PoreGroups& groups_;
  KnownPressures known_;
};

double mean_of(const FaceConditions& faces, std::span<const PressurePoint> points) {
  double sum = 0;
  int count = 0;
  for (const FaceCondition& face : faces)
    if (const auto pressure = std::visit(MeanPressure{}, face)) {
      sum += *pressure;
      ++count;
    }
  for (const PressurePoint& point : points) {
    sum += point.value;
    ++count;
  }
  return count > 0 ? sum / count : 0;
}

} // namespace

std::optional<double> pressure_at(const FaceCondition& condition, const Vec3& centre) {
  if (const auto* pressure = std::get_if<Pressure>(&condition))
    return pressure->value;
  if (const auto* profile = std::get_if<PressureProfile>(&condition))
    return profile->at(centre[index(profile->along)]);
  if (std::holds_alternative<Flux>(condition))
    return 0.0;
  return std::nullopt;
}

KnownPressures known_pressures(const PoreNetwork& network, const FaceConditions& faces,
                               std::span<const PressurePoint> points, const Vec3& rise, PoreGroups& groups) {
  Collector collector(faces, round_off * largest_of(faces, points, rise), groups, network.pores.size());
  for (const auto& part : network.wall_parts)
    if (const auto value = pressure_at(faces[index(part.face)], network.pores.centre[part.pore]))
      collector.set(part.pore, index(part.face), *value);
  for (std::size_t n = 0; n < points.size(); ++n) {
    const auto [pore, shift] = containing_pore(network, points[n].position);
    collector.set(pore, first_point + static_cast<int>(n),
                  points[n].value + along(rise, shift) + along(rise, groups.offset(pore)));
  }
  KnownPressures known = std::move(collector).spread();
  known.mean = mean_of(faces, points);
  return known;
}

} // namespace pfv
