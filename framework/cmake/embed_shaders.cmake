# cmake -DSHADERS=a.glsl;b.glsl -DOUTPUT=file.cpp -P embed_shaders.cmake
# Writes a C++ file that holds the framework's own shaders as strings, named gg/<file>.
set(entries "")
foreach(shader ${SHADERS})
  get_filename_component(name ${shader} NAME)
  file(READ ${shader} text)
  string(APPEND entries "    {\"gg/${name}\", R\"glsl(${text})glsl\"},\n")
endforeach()
file(WRITE ${OUTPUT} "#include \"builtin_shaders.hpp\"

namespace gg::detail {

const std::map<std::string, std::string, std::less<>>& builtinShaders() {
  static const std::map<std::string, std::string, std::less<>> shaders = {
${entries}  };
  return shaders;
}

} // namespace gg::detail
")
