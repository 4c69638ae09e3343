# What every target of the project shares: the language level, the warnings and where programs go.
# No -ffast-math anywhere: compensated sums and the exact zero tests of the laws rely on IEEE arithmetic.

set(CMAKE_RUNTIME_OUTPUT_DIRECTORY ${PROJECT_BINARY_DIR}/bin)

function(ricochet_target target)
  target_compile_features(${target} PUBLIC cxx_std_20)
  set_target_properties(${target} PROPERTIES CXX_EXTENSIONS OFF)
  target_compile_options(${target} PRIVATE -Wall -Wextra -Wpedantic -Werror=switch -ffp-contract=off)
  if(CMAKE_CXX_COMPILER_ID STREQUAL GNU AND CMAKE_CXX_COMPILER_VERSION VERSION_LESS 13)
    # g++ 12 warns about every inlined `"text" + std::string` (GCC bug 105651, corrected in 13).
    target_compile_options(${target} PRIVATE -Wno-restrict)
  endif()
endfunction()

# A static library that a shared one may take in: the Python module, an engine's plug-in. Hidden symbols cost such code
# nothing, as none of them can be replaced from outside.
function(ricochet_embeddable target)
  set_target_properties(${target} PROPERTIES
    POSITION_INDEPENDENT_CODE ON CXX_VISIBILITY_PRESET hidden VISIBILITY_INLINES_HIDDEN ON)
endfunction()

# Sources are found by folder: a file is one room, and opening a room should not need a second edit here.
function(ricochet_sources variable)
  file(GLOB_RECURSE found CONFIGURE_DEPENDS ${ARGN})
  set(${variable} ${found} PARENT_SCOPE)
endfunction()
