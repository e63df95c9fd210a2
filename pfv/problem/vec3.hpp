#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>

namespace pfv {

using Vec3 = Eigen::Vector3d;

} // namespace pfv
