# Run at build time: fills in build_info.cpp.in, which changes only when what it says has changed.
# -D SOURCE= project folder, OUTPUT= file to write, COMPILER=, FLAGS=
function(add_digest name) # of the files that follow
  list(FILTER ARGN INCLUDE REGEX "\\.(cpp|hpp|c|h|in|csv|py|txt)$")
  if(NOT ARGN)
    return()
  endif()
  list(SORT ARGN)
  set(digests)
  foreach(source IN LISTS ARGN)
    file(SHA256 ${source} digest)
    string(APPEND digests " ${digest}")
  endforeach()
  string(SHA256 digest "${digests}")
  string(SUBSTRING ${digest} 0 16 digest)
  set(SOURCES "${SOURCES}{\"${name}\", \"${digest}\"}, " PARENT_SCOPE)
endfunction()

set(SOURCES)
foreach(part pfv meshing reference)
  file(GLOB_RECURSE all LIST_DIRECTORIES false ${SOURCE}/${part}/*)
  add_digest(${part} ${all})
  file(GLOB directly LIST_DIRECTORIES false ${SOURCE}/${part}/*)
  list(FILTER directly EXCLUDE REGEX "/(find_method|methods)\\.cpp$") # one more method changes no answer of the others
  add_digest("${part}/*" ${directly})
  file(GLOB folders LIST_DIRECTORIES true RELATIVE ${SOURCE} ${SOURCE}/${part} ${SOURCE}/${part}/*)
  foreach(folder IN LISTS folders)
    if(IS_DIRECTORY ${SOURCE}/${folder})
      file(GLOB_RECURSE all LIST_DIRECTORIES false ${SOURCE}/${folder}/*)
      add_digest(${folder} ${all})
    endif()
  endforeach()
endforeach()
# What times the steps of scenes; all else in this folder tells of answers and does not make them.
file(GLOB_RECURSE all LIST_DIRECTORIES false ${SOURCE}/studies/effect_cost/*)
add_digest(studies/effect_cost ${all})

execute_process(COMMAND git -C ${SOURCE} describe --always --dirty --abbrev=12
                OUTPUT_VARIABLE COMMIT OUTPUT_STRIP_TRAILING_WHITESPACE ERROR_QUIET)
if(NOT COMMIT)
  set(COMMIT unknown)
endif()
configure_file(${CMAKE_CURRENT_LIST_DIR}/build_info.cpp.in ${OUTPUT} @ONLY)
