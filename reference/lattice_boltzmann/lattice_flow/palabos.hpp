#pragma once

/// The part of Palabos that lattices need. palabos3D.hh also includes its multi-grid headers, which are not valid C++
/// any more, and palabos3D.h a function that is defined once in every file that includes it.
#include <core/globalDefs.h>

#include <parallelism/headers3D.h>

#include <latticeBoltzmann/headers3D.h>

#include <atomicBlock/headers3D.h>
#include <basicDynamics/headers3D.h>
#include <coProcessors/headers3D.h>
#include <core/headers3D.h>
#include <dataProcessors/headers3D.h>
#include <multiBlock/headers3D.h>

#include <atomicBlock/headers3D.hh>
#include <basicDynamics/headers3D.hh>
#include <coProcessors/headers3D.hh>
#include <core/headers3D.hh>
#include <dataProcessors/headers3D.hh>
#include <latticeBoltzmann/headers3D.hh>
#include <multiBlock/headers3D.hh>
#include <parallelism/headers3D.hh>
