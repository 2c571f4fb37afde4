# SPDX-License-Identifier: GPL-3.0-or-later
# What all our targets share: C++20, warnings as errors, ccache, sanitizers.
set(S2B_VERSION 0.1.0)
option(S2B_WERROR "Warnings of our own code are errors" ON)
set(S2B_SANITIZE "" CACHE STRING "Sanitizers, for example address,undefined or thread")

if(NOT S2B_IN_TREE)
  if(NOT CMAKE_BUILD_TYPE)
    set(CMAKE_BUILD_TYPE Release CACHE STRING "" FORCE)
  endif()
  set(CMAKE_POSITION_INDEPENDENT_CODE ON)
  set(CMAKE_EXPORT_COMPILE_COMMANDS ON)
  find_program(S2B_CCACHE ccache)
  if(S2B_CCACHE)
    set(CMAKE_CXX_COMPILER_LAUNCHER "${S2B_CCACHE}")
  endif()
endif()

# s2b_settings(TARGET): our own code's rules. No -march: Eigen's alignment has to match PCL's and CloudCompare's.
function(s2b_settings target)
  target_compile_features(${target} PRIVATE cxx_std_20)
  set_target_properties(${target} PROPERTIES CXX_EXTENSIONS OFF POSITION_INDEPENDENT_CODE ON)
  target_compile_options(${target} PRIVATE -Wall -Wextra -Wpedantic -Wshadow -Wconversion -Wnon-virtual-dtor -Woverloaded-virtual)
  if(S2B_WERROR)
    target_compile_options(${target} PRIVATE -Werror)
  endif()
  if(S2B_SANITIZE)
    # Sanitizers hide from GCC what std::regex sets: it warns of its own headers.
    target_compile_options(${target} PRIVATE -fsanitize=${S2B_SANITIZE} -fno-omit-frame-pointer -fno-sanitize-recover=all -Wno-maybe-uninitialized)
    target_link_options(${target} PUBLIC -fsanitize=${S2B_SANITIZE})
  endif()
endfunction()
