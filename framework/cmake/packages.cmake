# Finds what the framework needs under the names that Debian, Homebrew and vcpkg give it, and fails
# with the command that installs it.
find_package(PkgConfig QUIET)

# gg_package(RESULT label TARGETS names... HEADER header LIBRARIES names... MODULE pc) sets RESULT to
# one of the imported targets, else to a pkg-config module's, else to one made of header and library.
function(gg_package result label)
  cmake_parse_arguments(ARG "" "HEADER;MODULE" "TARGETS;LIBRARIES" ${ARGN})
  foreach(target ${ARG_TARGETS})
    if(TARGET ${target})
      # Seen from every folder that links the framework, not only from this one.
      get_target_property(alias ${target} ALIASED_TARGET)
      get_target_property(imported ${target} IMPORTED)
      if(imported AND NOT alias)
        set_target_properties(${target} PROPERTIES IMPORTED_GLOBAL TRUE)
      endif()
      set(${result} ${target} PARENT_SCOPE)
      return()
    endif()
  endforeach()
  if(PkgConfig_FOUND AND ARG_MODULE)
    pkg_check_modules(GG_${label} QUIET IMPORTED_TARGET GLOBAL ${ARG_MODULE})
    if(TARGET PkgConfig::GG_${label})
      set(${result} PkgConfig::GG_${label} PARENT_SCOPE)
      return()
    endif()
  endif()
  find_path(GG_${label}_INCLUDE_DIR ${ARG_HEADER})
  if(ARG_LIBRARIES)
    find_library(GG_${label}_LIBRARY NAMES ${ARG_LIBRARIES})
  endif()
  if(GG_${label}_INCLUDE_DIR AND (NOT ARG_LIBRARIES OR GG_${label}_LIBRARY))
    add_library(gg_package_${label} INTERFACE)
    target_include_directories(gg_package_${label} SYSTEM INTERFACE ${GG_${label}_INCLUDE_DIR})
    if(ARG_LIBRARIES)
      target_link_libraries(gg_package_${label} INTERFACE ${GG_${label}_LIBRARY})
    endif()
    set(${result} gg_package_${label} PARENT_SCOPE)
    return()
  endif()
  message(FATAL_ERROR "${label} was not found. Install it:\n"
    "  Debian, Ubuntu:  apt install libglfw3-dev libglm-dev libtinyobjloader-dev nlohmann-json3-dev libfmt-dev libpng-dev\n"
    "  macOS:           brew install glfw glm tinyobjloader nlohmann-json fmt libpng\n"
    "  Windows:         vcpkg install glfw3 glm tinyobjloader nlohmann-json fmt libpng")
endfunction()

find_package(glfw3 CONFIG QUIET)
gg_package(GG_GLFW glfw3 TARGETS glfw glfw3::glfw MODULE glfw3
  HEADER GLFW/glfw3.h LIBRARIES glfw glfw3)
find_package(glm CONFIG QUIET)
gg_package(GG_GLM glm TARGETS glm::glm glm HEADER glm/glm.hpp)
find_package(tinyobjloader CONFIG QUIET)
gg_package(GG_TINYOBJ tinyobjloader TARGETS tinyobjloader::tinyobjloader tinyobjloader
  MODULE tinyobjloader HEADER tiny_obj_loader.h LIBRARIES tinyobjloader)
find_package(nlohmann_json CONFIG QUIET)
gg_package(GG_JSON nlohmann_json TARGETS nlohmann_json::nlohmann_json HEADER nlohmann/json.hpp)
find_package(fmt CONFIG QUIET)
gg_package(GG_FMT fmt TARGETS fmt::fmt MODULE fmt HEADER fmt/core.h LIBRARIES fmt)
find_package(PNG QUIET)
gg_package(GG_PNG png TARGETS PNG::PNG MODULE libpng HEADER png.h LIBRARIES png png16)
