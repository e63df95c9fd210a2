#include "reference/openfoam/snappy_files.hpp"

#include "reference/openfoam/case_files.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <limits>
#include <string>
#include <string_view>

namespace reference::openfoam {

namespace {

// Double braces: these are fmt strings.
constexpr std::string_view block_mesh = R"(
scale 1;
vertices (({x0} {y0} {z0}) ({x1} {y0} {z0}) ({x1} {y1} {z0}) ({x0} {y1} {z0})
          ({x0} {y0} {z1}) ({x1} {y0} {z1}) ({x1} {y1} {z1}) ({x0} {y1} {z1}));
blocks (hex (0 1 2 3 4 5 6 7) ({nx} {ny} {nz}) simpleGrading (1 1 1));
edges ();
boundary (
  x_min {{ type patch; faces ((0 4 7 3)); }} x_max {{ type patch; faces ((1 2 6 5)); }}
  y_min {{ type patch; faces ((0 1 5 4)); }} y_max {{ type patch; faces ((3 7 6 2)); }}
  z_min {{ type patch; faces ((0 3 2 1)); }} z_max {{ type patch; faces ((4 5 6 7)); }}
);
mergePatchPairs ();
)";

// Cells near the spheres are not refined: the error of the permeability is that of the cells across the throats.
constexpr std::string_view snappy = R"(
castellatedMesh true; snap true; addLayers false;
geometry {{
{geometry}}}
castellatedMeshControls {{
  maxLocalCells 100000000; maxGlobalCells 100000000; minRefinementCells 0; nCellsBetweenLevels 2; maxLoadUnbalance 0.1;
  features (); resolveFeatureAngle 30; refinementRegions {{}}
  refinementSurfaces {{
{surfaces}  }}
  locationInMesh ({x} {y} {z}); allowFreeStandingZoneFaces true;
}}
snapControls {{
  nSmoothPatch 3; tolerance 2; nSolveIter 100; nRelaxIter 5; nFeatureSnapIter 10;
  implicitFeatureSnap false; explicitFeatureSnap false; multiRegionFeatureSnap false;
}}
addLayersControls {{
  relativeSizes true; layers {{}} expansionRatio 1; finalLayerThickness 0.3; minThickness 0.1; nGrow 0; featureAngle 30;
  nRelaxIter 3; nSmoothSurfaceNormals 1; nSmoothNormals 3; nSmoothThickness 10; maxFaceThicknessRatio 0.5;
  maxThicknessToMedialRatio 0.3; minMedianAxisAngle 90; nBufferCellsNoExtrude 0; nLayerIter 50;
}}
meshQualityControls {{
  maxNonOrtho 65; maxBoundarySkewness 20; maxInternalSkewness 4; maxConcave 80; minVol 1e-18; minTetQuality 1e-15;
  minArea -1; minTwist 0.02; minDeterminant 0.001; minFaceWeight 0.05; minVolRatio 0.01; minTriangleTwist -1;
  nSmoothScale 4; errorReduction 0.75; relaxed {{ maxNonOrtho 75; }}
}}
mergeTolerance 1e-6;
)";

std::string text_of(const pfv::Vec3& point) {
  return fmt::format("({} {} {})", point.x(), point.y(), point.z());
}

} // namespace

void write_block_mesh(const std::filesystem::path& folder, const pfv::Box& box, double cell) {
  const auto cells = [&](int axis) { return std::max(2L, std::lround(box.size()[axis] / cell)); };
  using fmt::arg;
  write_foam_file(folder / "system" / "blockMeshDict", "dictionary",
                  fmt::format(block_mesh, arg("x0", box.lower.x()), arg("y0", box.lower.y()), arg("z0", box.lower.z()),
                              arg("x1", box.upper.x()), arg("y1", box.upper.y()), arg("z1", box.upper.z()),
                              arg("nx", cells(0)), arg("ny", cells(1)), arg("nz", cells(2))));
}

void write_snappy(const std::filesystem::path& folder, const pfv::Packing& packing,
                  const std::vector<meshing::Bridge>& bridges, const pfv::Vec3& inside) {
  std::string geometry, surfaces;
  const auto add = [&](const std::string& name, const std::string& shape) {
    geometry += fmt::format("  {} {{ type {} }}\n", name, shape);
    surfaces += fmt::format("    {} {{ level (0 0); patchInfo {{ type wall; }} }}\n", name);
  };
  for (std::size_t k = 0; k < packing.spheres.size(); ++k)
    add(fmt::format("sphere_{}", k), fmt::format("searchableSphere; centre {}; radius {};",
                                                 text_of(packing.spheres[k].centre), packing.spheres[k].radius));
  for (const auto& [name, from, to, radius] : bridges)
    add(name, fmt::format("searchableCylinder; point1 {}; point2 {}; radius {};", text_of(from), text_of(to), radius));
  write_foam_file(folder / "system" / "snappyHexMeshDict", "dictionary",
                  fmt::format(snappy, fmt::arg("geometry", geometry), fmt::arg("surfaces", surfaces),
                              fmt::arg("x", inside.x()), fmt::arg("y", inside.y()), fmt::arg("z", inside.z())));
}

pfv::Vec3 point_in_void(const pfv::Packing& packing) {
  constexpr int steps = 37;
  pfv::Vec3 best = packing.box.lower;
  double largest = -std::numeric_limits<double>::infinity();
  for (int i = 0; i < steps; ++i)
    for (int j = 0; j < steps; ++j)
      for (int k = 0; k < steps; ++k) {
        const pfv::Vec3 share = pfv::Vec3(i + 0.5012, j + 0.5023, k + 0.5034) / steps;
        const pfv::Vec3 point = packing.box.lower + share.cwiseProduct(packing.box.size());
        double distance = std::numeric_limits<double>::infinity();
        for (const auto& [centre, radius] : packing.spheres)
          distance = std::min(distance, (point - centre).norm() - radius);
        if (distance > largest) {
          largest = distance;
          best = point;
        }
      }
  return best;
}

} // namespace reference::openfoam
