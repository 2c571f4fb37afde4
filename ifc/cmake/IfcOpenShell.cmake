# SPDX-License-Identifier: GPL-3.0-or-later
# Imported targets s2b_ifcparse and s2b_ifcgeom for IfcOpenShell's C++ library, which brings no CMake files of its own in
# Debian, and the proof that it was compiled against the Boost of this build.
find_path(IFCOPENSHELL_INCLUDE_DIR ifcparse/IfcFile.h)
find_library(IFCOPENSHELL_PARSE_LIBRARY IfcParse)
find_library(IFCOPENSHELL_GEOM_LIBRARY IfcGeom)
find_path(OPENCASCADE_INCLUDE_DIR Standard_Failure.hxx PATH_SUFFIXES opencascade occt)
find_library(OPENCASCADE_KERNEL_LIBRARY TKernel)
foreach(variable IFCOPENSHELL_INCLUDE_DIR IFCOPENSHELL_PARSE_LIBRARY IFCOPENSHELL_GEOM_LIBRARY OPENCASCADE_INCLUDE_DIR
                 OPENCASCADE_KERNEL_LIBRARY)
  if(NOT ${variable})
    message(FATAL_ERROR "IfcOpenShell's C++ library is not complete (${variable} not found); "
                        "run the build inside scripts/env, or install libifcopenshell-dev and OpenCASCADE's headers")
  endif()
endforeach()
find_package(Boost REQUIRED CONFIG)
find_package(Eigen3 REQUIRED NO_MODULE)

add_library(s2b_ifcparse INTERFACE)
target_include_directories(s2b_ifcparse SYSTEM INTERFACE "${IFCOPENSHELL_INCLUDE_DIR}" "${Boost_INCLUDE_DIRS}")
target_compile_definitions(s2b_ifcparse INTERFACE IFC_SHARED_BUILD)
target_link_libraries(s2b_ifcparse INTERFACE "${IFCOPENSHELL_PARSE_LIBRARY}")

add_library(s2b_ifcgeom INTERFACE)
target_include_directories(s2b_ifcgeom SYSTEM INTERFACE "${OPENCASCADE_INCLUDE_DIR}")
target_compile_definitions(s2b_ifcgeom INTERFACE IFOPSH_WITH_OPENCASCADE)
target_link_libraries(s2b_ifcgeom INTERFACE s2b_ifcparse Eigen3::Eigen "${IFCOPENSHELL_GEOM_LIBRARY}"
                                            "${OPENCASCADE_KERNEL_LIBRARY}")

# The answer is kept until the library or the Boost version changes.
file(REAL_PATH "${IFCOPENSHELL_PARSE_LIBRARY}" _s2b_library)
file(SHA256 "${_s2b_library}" _s2b_key)
string(APPEND _s2b_key "-${Boost_VERSION_STRING}-${CMAKE_CXX_COMPILER_VERSION}")
if(NOT "${S2B_IFCOPENSHELL_ABI_KEY}" STREQUAL "${_s2b_key}")
  message(STATUS "Checking IfcOpenShell against Boost ${Boost_VERSION_STRING}")
  unset(S2B_IFCOPENSHELL_ABI_RUN CACHE)
  unset(S2B_IFCOPENSHELL_ABI_COMPILED CACHE)
  try_run(S2B_IFCOPENSHELL_ABI_RUN S2B_IFCOPENSHELL_ABI_COMPILED
    "${CMAKE_CURRENT_BINARY_DIR}/abi_probe" "${CMAKE_CURRENT_LIST_DIR}/abi_probe.cpp"
    CMAKE_FLAGS "-DINCLUDE_DIRECTORIES=${IFCOPENSHELL_INCLUDE_DIR};${Boost_INCLUDE_DIRS}"
    COMPILE_DEFINITIONS -DIFC_SHARED_BUILD -w
    LINK_LIBRARIES "${IFCOPENSHELL_PARSE_LIBRARY}"
    CXX_STANDARD 20 CXX_STANDARD_REQUIRED ON
    COMPILE_OUTPUT_VARIABLE _s2b_compile_output RUN_OUTPUT_VARIABLE _s2b_run_output)
  if(NOT S2B_IFCOPENSHELL_ABI_COMPILED)
    message(FATAL_ERROR "A program with IfcOpenShell does not compile:\n${_s2b_compile_output}")
  endif()
  if(NOT "${S2B_IFCOPENSHELL_ABI_RUN}" STREQUAL "0")
    string(STRIP "${_s2b_run_output}" _s2b_run_output)
    message(FATAL_ERROR "IfcOpenShell (${IFCOPENSHELL_PARSE_LIBRARY}) was compiled against another Boost than the "
                        "${Boost_VERSION_STRING} of this build and would write broken files (it answered "
                        "\"${_s2b_run_output}\"); install a libifcopenshell that fits, as scripts/env does")
  endif()
  set(S2B_IFCOPENSHELL_ABI_KEY "${_s2b_key}" CACHE INTERNAL "Library and Boost that were proved to fit")
endif()
