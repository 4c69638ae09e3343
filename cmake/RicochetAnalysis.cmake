# Targets for whoever changes the code: `tidy` (clang-tidy), `cppcheck`, `coverage` (preset coverage), `reference` (Doxygen).
# Each appears only where its tool is installed.

set(analysed core/src core/console calibrate verify simulate)
find_program(RUN_CLANG_TIDY run-clang-tidy)
if(RUN_CLANG_TIDY AND CMAKE_EXPORT_COMPILE_COMMANDS)
  list(JOIN analysed "|" analysed_folders)
  add_custom_target(tidy COMMAND ${RUN_CLANG_TIDY} -quiet -p ${PROJECT_BINARY_DIR}
    "^${PROJECT_SOURCE_DIR}/(${analysed_folders})/.*\\.cpp$" USES_TERMINAL VERBATIM)
endif()

find_program(CPPCHECK cppcheck)
if(CPPCHECK)
  add_custom_target(cppcheck COMMAND ${CPPCHECK} --std=c++20 --language=c++ --quiet --error-exitcode=1
    -j 2 --enable=warning,performance,portability --inline-suppr --suppressions-list=${PROJECT_SOURCE_DIR}/cmake/cppcheck.txt
    -I core/include -I core/console/include -I verify/include -I ${PROJECT_BINARY_DIR}/core/include ${analysed}
    WORKING_DIRECTORY ${PROJECT_SOURCE_DIR} USES_TERMINAL VERBATIM)
endif()

find_program(GCOVR gcovr)
if(GCOVR)
  add_custom_target(coverage COMMAND ${GCOVR} --root ${PROJECT_SOURCE_DIR} --filter core/ --exclude-throw-branches
    --print-summary ${PROJECT_BINARY_DIR} USES_TERMINAL VERBATIM)
endif()

find_program(DOXYGEN doxygen)
if(DOXYGEN)
  add_custom_target(reference COMMAND ${CMAKE_COMMAND} -E env RICOCHET_VERSION=${PROJECT_VERSION}
    RICOCHET_REFERENCE=${PROJECT_BINARY_DIR}/reference ${DOXYGEN} docs/Doxyfile
    WORKING_DIRECTORY ${PROJECT_SOURCE_DIR} VERBATIM)
endif()
