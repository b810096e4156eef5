// What changes images otherwise than by drawing: copies, mipmap generations, image stores, uploads,
// deletions. Only the recorder wants to know, so that without it these functions have no hooks.

#include "capture/channel_writer.hpp"
#include "capture/gl_hooks.hpp"
#include "capture/recorder/recorder.hpp"

namespace ggrade::capture {
namespace {

constexpr GLint kNoLayer = -1;

/// Lives until the GL call has returned.
struct Ended {
  Ended() = default;
  ~Ended() { recorder::ended(); }
  Ended(const Ended&) = delete;
  Ended& operator=(const Ended&) = delete;
};

Ended copyingToBound(GLenum target, GLint level, GLint layer) {
  recorder::copyToBound(target, level, layer);
  return {};
}
Ended copyingTo(GLuint texture, GLint level, GLint layer) {
  recorder::copyTo(texture, level, layer);
  return {};
}

constexpr auto copyBound = [](GLenum target, GLint level, auto...) {
  return copyingToBound(target, level, kNoLayer);
};
constexpr auto copyBoundLayer = [](GLenum target, GLint level, GLint, GLint, GLint z, auto...) {
  return copyingToBound(target, level, z);
};
constexpr auto copyNamed = [](GLuint texture, GLint level, auto...) {
  return copyingTo(texture, level, kNoLayer);
};
constexpr auto copyNamedLayer = [](GLuint texture, GLint level, GLint, GLint, GLint z, auto...) {
  return copyingTo(texture, level, z);
};
constexpr auto copyImage = [](GLuint from, GLenum fromTarget, GLint fromLevel, GLint, GLint,
                              GLint fromZ, GLuint to, GLenum toTarget, GLint toLevel, GLint, GLint,
                              GLint toZ, auto...) {
  recorder::copyImage({from, fromTarget, fromLevel, fromZ}, {to, toTarget, toLevel, toZ});
  return Ended();
};
constexpr auto mipmap = [](GLenum target) {
  recorder::mipmapOfBound(target);
  return Ended();
};
constexpr auto mipmapNamed = [](GLuint texture) {
  recorder::mipmapOf(texture);
  return Ended();
};
constexpr auto dispatch = [](auto...) {
  recorder::dispatch();
  return Ended();
};

constexpr auto upload = [](GLenum target, GLint level, auto...) {
  recorder::uploadedToBound(target, level);
};
constexpr auto uploadNamed = [](GLuint texture, GLint level, auto...) {
  recorder::uploaded(texture, level);
};
// Storage is given once, before anything can be drawn: level 0 stands for all.
constexpr auto store = [](GLenum target, auto...) { recorder::uploadedToBound(target, 0); };
constexpr auto storeNamed = [](GLuint texture, auto...) { recorder::uploaded(texture, 0); };
constexpr auto renderbuffer = [](auto...) { recorder::boundRenderbufferChanged(); };
constexpr auto renderbufferNamed = [](GLuint name, auto...) {
  recorder::renderbufferChanged(name);
};
constexpr auto invalidate = [](auto...) { recorder::invalidated(); };
constexpr auto deleteTextures = [](GLsizei count, const GLuint* names) {
  recorder::texturesDeleted(count, names);
};
constexpr auto deleteRenderbuffers = [](GLsizei count, const GLuint* names) {
  recorder::renderbuffersDeleted(count, names);
};
constexpr auto endPrimitive = [] { recorder::end(); };
constexpr auto changeProgram = [](GLuint program, auto...) { recorder::programChanged(program); };

decltype(&glCreateShaderProgramv) nextCreateShaderProgram;
GLuint APIENTRY hookCreateShaderProgram(GLenum type, GLsizei count, const GLchar* const* strings) {
  const GLuint program = nextCreateShaderProgram(type, count, strings);
  recorder::programChanged(program);
  return program;
}

const Hook kImageHooks[] = {
    GG_AROUND(glCopyTexImage1D, copyBound),
    GG_AROUND(glCopyTexImage2D, copyBound),
    GG_AROUND(glCopyTexSubImage1D, copyBound),
    GG_AROUND(glCopyTexSubImage2D, copyBound),
    GG_AROUND(glCopyTexSubImage3D, copyBoundLayer),
    GG_AROUND(glCopyTextureSubImage1D, copyNamed),
    GG_AROUND(glCopyTextureSubImage2D, copyNamed),
    GG_AROUND(glCopyTextureSubImage3D, copyNamedLayer),
    GG_AROUND(glCopyImageSubData, copyImage),
    GG_AROUND(glGenerateMipmap, mipmap),
    GG_AROUND(glGenerateMipmapEXT, mipmap),
    GG_AROUND(glGenerateTextureMipmap, mipmapNamed),
    GG_AROUND(glDispatchCompute, dispatch),
    GG_AROUND(glDispatchComputeIndirect, dispatch),
    GG_AROUND(glDispatchComputeGroupSizeARB, dispatch),
    // uploads
    GG_AROUND(glTexImage1D, upload),
    GG_AROUND(glTexImage2D, upload),
    GG_AROUND(glTexImage3D, upload),
    GG_AROUND(glTexSubImage1D, upload),
    GG_AROUND(glTexSubImage2D, upload),
    GG_AROUND(glTexSubImage3D, upload),
    GG_AROUND(glCompressedTexImage1D, upload),
    GG_AROUND(glCompressedTexImage2D, upload),
    GG_AROUND(glCompressedTexImage3D, upload),
    GG_AROUND(glCompressedTexSubImage1D, upload),
    GG_AROUND(glCompressedTexSubImage2D, upload),
    GG_AROUND(glCompressedTexSubImage3D, upload),
    GG_AROUND(glTextureSubImage1D, uploadNamed),
    GG_AROUND(glTextureSubImage2D, uploadNamed),
    GG_AROUND(glTextureSubImage3D, uploadNamed),
    GG_AROUND(glCompressedTextureSubImage1D, uploadNamed),
    GG_AROUND(glCompressedTextureSubImage2D, uploadNamed),
    GG_AROUND(glCompressedTextureSubImage3D, uploadNamed),
    GG_AROUND(glClearTexImage, uploadNamed),
    GG_AROUND(glClearTexSubImage, uploadNamed),
    GG_AROUND(glInvalidateTexImage, uploadNamed),
    GG_AROUND(glInvalidateTexSubImage, uploadNamed),
    // storage
    GG_AROUND(glTexImage2DMultisample, store),
    GG_AROUND(glTexImage3DMultisample, store),
    GG_AROUND(glTexStorage1D, store),
    GG_AROUND(glTexStorage2D, store),
    GG_AROUND(glTexStorage2DMultisample, store),
    GG_AROUND(glTexStorage3D, store),
    GG_AROUND(glTexStorage3DMultisample, store),
    GG_AROUND(glTextureStorage1D, storeNamed),
    GG_AROUND(glTextureStorage2D, storeNamed),
    GG_AROUND(glTextureStorage2DMultisample, storeNamed),
    GG_AROUND(glTextureStorage3D, storeNamed),
    GG_AROUND(glTextureStorage3DMultisample, storeNamed),
    GG_AROUND(glRenderbufferStorage, renderbuffer),
    GG_AROUND(glRenderbufferStorageEXT, renderbuffer),
    GG_AROUND(glRenderbufferStorageMultisample, renderbuffer),
    GG_AROUND(glRenderbufferStorageMultisampleEXT, renderbuffer),
    GG_AROUND(glNamedRenderbufferStorage, renderbufferNamed),
    GG_AROUND(glNamedRenderbufferStorageMultisample, renderbufferNamed),
    // loss
    GG_AROUND(glInvalidateFramebuffer, invalidate),
    GG_AROUND(glInvalidateSubFramebuffer, invalidate),
    GG_AROUND(glInvalidateNamedFramebufferData, invalidate),
    GG_AROUND(glInvalidateNamedFramebufferSubData, invalidate),
    GG_AROUND(glDeleteTextures, deleteTextures),
    GG_AROUND(glDeleteTexturesEXT, deleteTextures),
    GG_AROUND(glDeleteRenderbuffers, deleteRenderbuffers),
    GG_AROUND(glDeleteRenderbuffersEXT, deleteRenderbuffers),
    // programs
    GG_AROUND(glLinkProgram, changeProgram),
    GG_AROUND(glLinkProgramARB, changeProgram),
    GG_AROUND(glProgramBinary, changeProgram),
    GG_HOOK(glCreateShaderProgramv, hookCreateShaderProgram, nextCreateShaderProgram),
    // compatibility profile
    GG_AROUND(glEnd, endPrimitive),
};

} // namespace

std::span<const Hook> imageHooks() {
  return recordsPasses ? std::span<const Hook>(kImageHooks) : std::span<const Hook>();
}

} // namespace ggrade::capture
