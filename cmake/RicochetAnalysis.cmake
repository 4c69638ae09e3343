# Targets for whoever changes the code: `tidy` (clang-tidy), `cppcheck`, `reference` (Doxygen).
# Each appears only where its tool is installed.

set(analysed core/src console calibrate verify simulate)
find_program(CLANG_TIDY clang-tidy)
if(CLANG_TIDY AND CMAKE_EXPORT_COMPILE_COMMANDS)
  set(tidy ${PROJECT_SOURCE_DIR}/tests/tidy/run ${PROJECT_BINARY_DIR})
  add_custom_target(tidy COMMAND ${tidy} --all USES_TERMINAL VERBATIM)
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
