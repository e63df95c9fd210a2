# Run at build time: fills in build_info.cpp.in, which changes only when what it says has changed.
# -D SOURCE= project folder, OUTPUT= file to write, COMPILER=, FLAGS=
file(GLOB_RECURSE sources LIST_DIRECTORIES false ${SOURCE}/pfv/* ${SOURCE}/meshing/* ${SOURCE}/reference/*)
list(FILTER sources INCLUDE REGEX "\\.(cpp|hpp|c|h|in|csv|py|txt)$")
list(SORT sources)
set(digests "${COMPILER} ${FLAGS}")
foreach(source IN LISTS sources)
  file(SHA256 ${source} digest)
  string(APPEND digests " ${digest}")
endforeach()
string(SHA256 ANSWER_SOURCES "${digests}")
string(SUBSTRING ${ANSWER_SOURCES} 0 16 ANSWER_SOURCES)

execute_process(COMMAND git -C ${SOURCE} describe --always --dirty --abbrev=12
                OUTPUT_VARIABLE COMMIT OUTPUT_STRIP_TRAILING_WHITESPACE ERROR_QUIET)
if(NOT COMMIT)
  set(COMMIT unknown)
endif()
configure_file(${CMAKE_CURRENT_LIST_DIR}/build_info.cpp.in ${OUTPUT} @ONLY)
