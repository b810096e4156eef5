# Makes the OpenGL loader: sets GG_LOADER_DIR to a folder with include/glad/gl.h and src/gl.c, and with
# include/glad/placed.h, by which every call in a student's files says where it stands.
# A loader that was made before and lies in framework/glad is used as it is, so that a machine
# without the generator can build.
if(EXISTS ${CMAKE_CURRENT_SOURCE_DIR}/glad/src/gl.c)
  set(GG_LOADER_DIR ${CMAKE_CURRENT_SOURCE_DIR}/glad)
  return()
endif()

set(GG_LOADER_DIR ${CMAKE_CURRENT_BINARY_DIR}/glad)
set(loader_options --api gl:core=4.1
  --extensions GL_KHR_debug,GL_ARB_direct_state_access,GL_ARB_clip_control --reproducible)
set(language c --debug) # calls can be watched
if(EXISTS ${GG_LOADER_DIR}/made_with)
  file(READ ${GG_LOADER_DIR}/made_with made_with)
  if(made_with STREQUAL "${loader_options} ${language}")
    return()
  endif()
endif()

# Debian's package belongs to Debian's own Python, which need not be the first one on the path.
if(EXISTS /usr/bin/glad AND EXISTS /usr/bin/python3)
  set(generator /usr/bin/python3 /usr/bin/glad)
else()
  find_program(GG_GLAD_PROGRAM glad)
  if(NOT GG_GLAD_PROGRAM)
    message(FATAL_ERROR "The OpenGL loader's generator was not found. Install it:\n"
      "  Debian, Ubuntu:  apt install python3-glad\n"
      "  elsewhere:       pip install glad2")
  endif()
  set(generator ${GG_GLAD_PROGRAM})
endif()
execute_process(COMMAND ${generator} ${loader_options} --out-path ${GG_LOADER_DIR} ${language}
  RESULT_VARIABLE failed OUTPUT_VARIABLE log ERROR_VARIABLE log)
if(failed OR NOT EXISTS ${GG_LOADER_DIR}/src/gl.c)
  message(FATAL_ERROR "The OpenGL loader could not be generated:\n${log}")
endif()
# "#define glClear glad_debug_glClear" becomes one that first notes file and line.
file(STRINGS ${GG_LOADER_DIR}/include/glad/gl.h functions REGEX "^#define gl[A-Z][A-Za-z0-9]* glad_debug_")
set(placed "// Include <gg/call_place.hpp> first.\n#pragma once\n")
foreach(function ${functions})
  string(REGEX REPLACE "^#define (gl[A-Za-z0-9]+) .*" "\\1" name ${function})
  string(APPEND placed "#undef ${name}\n#define ${name} GG_PLACED(glad_debug_${name})\n")
endforeach()
file(WRITE ${GG_LOADER_DIR}/include/glad/placed.h "${placed}")
file(WRITE ${GG_LOADER_DIR}/made_with "${loader_options} ${language}")
