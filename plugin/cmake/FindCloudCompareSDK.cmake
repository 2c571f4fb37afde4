# SPDX-License-Identifier: GPL-3.0-or-later
# An installed CloudCompare's libraries with the headers of its source, as imported targets that bear CloudCompare's
# own names, so that a plugin's CMake is the same in tree and out of tree.
#
#   CC_SOURCE_DIR   the source tree of the installed version (cache variable, or from the environment)
#   CC_LIBRARY_DIR  found: where libQCC_DB_LIB.so and its neighbours are
#   CC_EXECUTABLE   found: the CloudCompare program
# Targets: CCCoreLib CC_FBO_LIB QCC_DB_LIB QCC_GL_LIB QCC_IO_LIB CCPluginAPI CCPluginStub
set(CC_SOURCE_DIR "$ENV{CC_SOURCE_DIR}" CACHE PATH "CloudCompare source tree of the installed version")
find_library(CC_DB_LIBRARY QCC_DB_LIB PATH_SUFFIXES cloudcompare)
get_filename_component(library_dir "${CC_DB_LIBRARY}" DIRECTORY)
set(CC_LIBRARY_DIR "${library_dir}" CACHE INTERNAL "Folder of CloudCompare's libraries")
find_program(CC_EXECUTABLE CloudCompare)
find_path(CC_PLUGIN_INCLUDE ccStdPluginInterface.h PATHS "${CC_SOURCE_DIR}/libs/CCPluginStub/include" NO_DEFAULT_PATH)
mark_as_advanced(CC_DB_LIBRARY CC_PLUGIN_INCLUDE)

include(FindPackageHandleStandardArgs)
find_package_handle_standard_args(CloudCompareSDK REQUIRED_VARS CC_DB_LIBRARY CC_PLUGIN_INCLUDE CC_EXECUTABLE
  REASON_FAILURE_MESSAGE "Run CMake through scripts/env, or install cloudcompare and set CC_SOURCE_DIR to its source tree")
if(NOT CloudCompareSDK_FOUND OR TARGET QCC_DB_LIB)
  return()
endif()
find_package(Qt5 REQUIRED COMPONENTS Concurrent Core Gui OpenGL OpenGLExtensions PrintSupport Widgets)
configure_file("${CMAKE_CURRENT_LIST_DIR}/CCCoreLibExport.h" "${CMAKE_BINARY_DIR}/cloudcompare/CCCoreLibExport.h" COPYONLY)

function(s2b_import_cloudcompare name include)
  add_library(${name} SHARED IMPORTED GLOBAL)
  set_target_properties(${name} PROPERTIES
    IMPORTED_LOCATION "${CC_LIBRARY_DIR}/lib${name}.so"
    INTERFACE_INCLUDE_DIRECTORIES "${CC_SOURCE_DIR}/${include}"
    INTERFACE_LINK_LIBRARIES "${ARGN}")
endfunction()
s2b_import_cloudcompare(CCCoreLib libs/qCC_db/extern/CCCoreLib/include Qt5::Concurrent)
s2b_import_cloudcompare(CC_FBO_LIB libs/CCFbo/include Qt5::OpenGL Qt5::OpenGLExtensions)
s2b_import_cloudcompare(QCC_DB_LIB libs/qCC_db/include CCCoreLib CC_FBO_LIB Qt5::Widgets)
s2b_import_cloudcompare(QCC_GL_LIB libs/qCC_glWindow/include QCC_DB_LIB)
s2b_import_cloudcompare(QCC_IO_LIB libs/qCC_io/include QCC_DB_LIB)
s2b_import_cloudcompare(CCPluginAPI libs/CCPluginAPI/include QCC_GL_LIB QCC_IO_LIB)
# The definitions of the installed build: float scalars, CGAL's triangulation, QtConcurrent, and its file formats.
set_property(TARGET CCCoreLib APPEND PROPERTY INTERFACE_INCLUDE_DIRECTORIES "${CMAKE_BINARY_DIR}/cloudcompare")
set_property(TARGET CCCoreLib PROPERTY INTERFACE_COMPILE_DEFINITIONS
  CC_CORE_LIB_USES_FLOAT CC_CORE_LIB_USES_CGAL_LIB CC_CORE_LIB_USES_QT_CONCURRENT)
set_property(TARGET QCC_IO_LIB PROPERTY INTERFACE_COMPILE_DEFINITIONS CC_DXF_SUPPORT CC_SHP_SUPPORT CC_GDAL_SUPPORT)

# CloudCompare's plugin base class is one source file that every plugin compiles.
add_library(CCPluginStub STATIC "${CC_SOURCE_DIR}/libs/CCPluginStub/src/ccDefaultPluginInterface.cpp")
target_include_directories(CCPluginStub SYSTEM PUBLIC "${CC_SOURCE_DIR}/libs/CCPluginStub/include")
target_link_libraries(CCPluginStub PUBLIC QCC_DB_LIB)
set_target_properties(CCPluginStub PROPERTIES POSITION_INDEPENDENT_CODE ON AUTOMOC OFF)
