#pragma once

namespace studies {

// Absolute paths of this build. Their source file is the only one that a copy of the project compiles anew for them.

extern const char* const source_of_studies; // this folder of the sources
extern const char* const pfv_program;       // the executable pfv

} // namespace studies
