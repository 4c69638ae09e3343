# Targets for whoever changes the code: `tidy` (clang-tidy), `cppcheck`, `reference` (Doxygen).
# Each appears only where its tool is installed.

set(analysed core/src console calibrate verify simulate)
# clang-tidy takes some seconds a file: as parts of about the same work, which ctest runs side by side.
set(tidy_parts core/src verify/studies "calibrate/(src|exports)" calibrate/program console
  "simulate|verify/(src|main|conformance)" engines/half_step)
find_program(RUN_CLANG_TIDY run-clang-tidy)
if(RUN_CLANG_TIDY AND CMAKE_EXPORT_COMPILE_COMMANDS)
  # g++'s compile commands serve as well: clang only has to pass over the warnings that it does not know.
  # The path-sensitive checks get a quarter of their usual nodes a function: they took two thirds of all the time.
  set(tidy ${RUN_CLANG_TIDY} -quiet -p ${PROJECT_BINARY_DIR} -extra-arg=-Wno-unknown-warning-option
    -extra-arg=-Xclang -extra-arg=-analyzer-config -extra-arg=-Xclang -extra-arg=max-nodes=50000)
  list(JOIN tidy_parts "|" all_parts)
  add_custom_target(tidy COMMAND ${tidy} "^${PROJECT_SOURCE_DIR}/(${all_parts})" USES_TERMINAL VERBATIM)
endif()

find_program(CPPCHECK cppcheck)
if(CPPCHECK)
  add_custom_target(cppcheck COMMAND ${CPPCHECK} --std=c++20 --language=c++ --quiet --error-exitcode=1
    -j 2 --enable=warning,performance,portability --inline-suppr
    --suppressions-list=${PROJECT_SOURCE_DIR}/cmake/cppcheck.txt
    -I core/include -I console/include -I verify/include -I ${PROJECT_BINARY_DIR}/core/include ${analysed}
    WORKING_DIRECTORY ${PROJECT_SOURCE_DIR} USES_TERMINAL VERBATIM)
endif()

find_program(DOXYGEN doxygen)
if(DOXYGEN)
  add_custom_target(reference COMMAND ${CMAKE_COMMAND} -E env RICOCHET_VERSION=${PROJECT_VERSION}
    RICOCHET_REFERENCE=${PROJECT_BINARY_DIR}/reference ${DOXYGEN} docs/Doxyfile
    WORKING_DIRECTORY ${PROJECT_SOURCE_DIR} VERBATIM)
endif()
