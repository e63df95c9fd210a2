#pragma once

#include "studies/render/scene.hpp"

#include <string>

namespace studies {

/// A picture of 900 pixels either way on a clear ground, or why there is none.
struct Rendering {
  std::string png;
  std::string why_not; // a sentence without a full stop
};

/// Draws a scene by VTK in a process of its own, on a private X server (xvfb-run), as VTK draws on nothing else here.
Rendering render(const RenderScene& scene);

} // namespace studies
