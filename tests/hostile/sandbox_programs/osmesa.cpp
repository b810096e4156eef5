// Draws a 1024x1024 frame with a shader on OSMesa and prints the middle pixel.
#define GL_GLEXT_PROTOTYPES
#include <GL/osmesa.h>

#include <GL/glext.h>
#include <cstdio>
#include <vector>

template <class Function> Function load(const char* name) {
  return reinterpret_cast<Function>(OSMesaGetProcAddress(name));
}

int main() {
  const int attributes[] = {OSMESA_FORMAT,
                            OSMESA_RGBA,
                            OSMESA_DEPTH_BITS,
                            24,
                            OSMESA_PROFILE,
                            OSMESA_CORE_PROFILE,
                            OSMESA_CONTEXT_MAJOR_VERSION,
                            4,
                            OSMESA_CONTEXT_MINOR_VERSION,
                            1,
                            0};
  const OSMesaContext context = OSMesaCreateContextAttribs(attributes, nullptr);
  std::vector<unsigned char> pixels(1024 * 1024 * 4);
  if (!context || !OSMesaMakeCurrent(context, pixels.data(), GL_UNSIGNED_BYTE, 1024, 1024))
    return 1;

  const auto createShader = load<PFNGLCREATESHADERPROC>("glCreateShader");
  const auto shaderSource = load<PFNGLSHADERSOURCEPROC>("glShaderSource");
  const auto compileShader = load<PFNGLCOMPILESHADERPROC>("glCompileShader");
  const auto createProgram = load<PFNGLCREATEPROGRAMPROC>("glCreateProgram");
  const auto attachShader = load<PFNGLATTACHSHADERPROC>("glAttachShader");
  const auto linkProgram = load<PFNGLLINKPROGRAMPROC>("glLinkProgram");
  const auto useProgram = load<PFNGLUSEPROGRAMPROC>("glUseProgram");
  const auto genVertexArrays = load<PFNGLGENVERTEXARRAYSPROC>("glGenVertexArrays");
  const auto bindVertexArray = load<PFNGLBINDVERTEXARRAYPROC>("glBindVertexArray");
  const auto drawArrays = load<void (*)(GLenum, GLint, GLsizei)>("glDrawArrays");
  const auto finish = load<void (*)()>("glFinish");

  const char* vertex = "#version 410 core\n"
                       "void main() { vec2 p = vec2(gl_VertexID & 1, gl_VertexID >> 1) * 4.0 - 1.0;"
                       " gl_Position = vec4(p, 0.0, 1.0); }";
  const char* fragment = "#version 410 core\nout vec4 oColor;\n"
                         "void main() { oColor = vec4(1.0, 0.5, 0.25, 1.0); }";
  const GLuint program = createProgram();
  for (const auto& [kind, text] :
       {std::pair{GL_VERTEX_SHADER, vertex}, {GL_FRAGMENT_SHADER, fragment}}) {
    const GLuint shader = createShader(kind);
    shaderSource(shader, 1, &text, nullptr);
    compileShader(shader);
    attachShader(program, shader);
  }
  linkProgram(program);
  useProgram(program);
  GLuint array = 0;
  genVertexArrays(1, &array);
  bindVertexArray(array);
  drawArrays(GL_TRIANGLES, 0, 3);
  finish();
  const unsigned char* middle = &pixels[(512 * 1024 + 512) * 4];
  std::printf("%d %d %d %d\n", middle[0], middle[1], middle[2], middle[3]);
  OSMesaDestroyContext(context);
}
