#include "studies/runner/build_paths.hpp"

namespace studies {

const char* const source_of_studies = STUDIES_FOLDER;
const char* const pfv_program = PFV_PROGRAM;

} // namespace studies
