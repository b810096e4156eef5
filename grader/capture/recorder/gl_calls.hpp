#pragma once
/// \file
/// The GL functions that the recorder itself calls, past all hooks: `gl().finish()`.

#include "capture/gl_hooks.hpp"

#include <GL/gl.h>
#include <GL/glext.h>

#include <cstdint>

namespace ggrade::capture::recorder {

struct GlCalls {
#define GG_CALL(member, name) decltype(&::name) member = real<decltype(&::name)>(#name)
  GG_CALL(activeTexture, glActiveTexture);
  GG_CALL(bindBuffer, glBindBuffer);
  GG_CALL(bindFramebuffer, glBindFramebuffer);
  GG_CALL(blitNamedFramebuffer, glBlitNamedFramebuffer);
  GG_CALL(checkFramebufferStatus, glCheckFramebufferStatus);
  GG_CALL(clampColor, glClampColor);
  GG_CALL(colorMaski, glColorMaski);
  GG_CALL(createFramebuffers, glCreateFramebuffers);
  GG_CALL(createRenderbuffers, glCreateRenderbuffers);
  GG_CALL(deleteFramebuffers, glDeleteFramebuffers);
  GG_CALL(deleteRenderbuffers, glDeleteRenderbuffers);
  GG_CALL(disable, glDisable);
  GG_CALL(disablei, glDisablei);
  GG_CALL(enable, glEnable);
  GG_CALL(enablei, glEnablei);
  GG_CALL(finish, glFinish);
  GG_CALL(getActiveUniform, glGetActiveUniform);
  GG_CALL(getActiveUniformBlockiv, glGetActiveUniformBlockiv);
  GG_CALL(getActiveUniformsiv, glGetActiveUniformsiv);
  GG_CALL(getAttachedShaders, glGetAttachedShaders);
  GG_CALL(getBooleani_v, glGetBooleani_v);
  GG_CALL(getError, glGetError);
  GG_CALL(getFloatv, glGetFloatv);
  GG_CALL(getFramebufferAttachmentParameteriv, glGetFramebufferAttachmentParameteriv);
  GG_CALL(getInteger64i_v, glGetInteger64i_v);
  GG_CALL(getIntegeri_v, glGetIntegeri_v);
  GG_CALL(getIntegerv, glGetIntegerv);
  GG_CALL(getNamedBufferParameteri64v, glGetNamedBufferParameteri64v);
  GG_CALL(getNamedBufferParameteriv, glGetNamedBufferParameteriv);
  GG_CALL(getNamedBufferSubData, glGetNamedBufferSubData);
  GG_CALL(getNamedRenderbufferParameteriv, glGetNamedRenderbufferParameteriv);
  GG_CALL(getProgramInterfaceiv, glGetProgramInterfaceiv);
  GG_CALL(getProgramPipelineiv, glGetProgramPipelineiv);
  GG_CALL(getProgramResourceName, glGetProgramResourceName);
  GG_CALL(getProgramResourceiv, glGetProgramResourceiv);
  GG_CALL(getProgramiv, glGetProgramiv);
  GG_CALL(getSamplerParameterfv, glGetSamplerParameterfv);
  GG_CALL(getSamplerParameteriv, glGetSamplerParameteriv);
  GG_CALL(getShaderSource, glGetShaderSource);
  GG_CALL(getShaderiv, glGetShaderiv);
  GG_CALL(getTextureLevelParameteriv, glGetTextureLevelParameteriv);
  GG_CALL(getTextureParameterfv, glGetTextureParameterfv);
  GG_CALL(getTextureParameteriv, glGetTextureParameteriv);
  GG_CALL(getTextureSubImage, glGetTextureSubImage);
  GG_CALL(getUniformLocation, glGetUniformLocation);
  GG_CALL(getUniformfv, glGetUniformfv);
  GG_CALL(getUniformiv, glGetUniformiv);
  GG_CALL(getUniformuiv, glGetUniformuiv);
  GG_CALL(getVertexAttribfv, glGetVertexAttribfv);
  GG_CALL(getVertexAttribiv, glGetVertexAttribiv);
  GG_CALL(isBuffer, glIsBuffer);
  GG_CALL(isEnabled, glIsEnabled);
  GG_CALL(isEnabledi, glIsEnabledi);
  GG_CALL(isFramebuffer, glIsFramebuffer);
  GG_CALL(isRenderbuffer, glIsRenderbuffer);
  GG_CALL(isTexture, glIsTexture);
  GG_CALL(memoryBarrier, glMemoryBarrier);
  GG_CALL(namedFramebufferDrawBuffer, glNamedFramebufferDrawBuffer);
  GG_CALL(namedFramebufferReadBuffer, glNamedFramebufferReadBuffer);
  GG_CALL(namedFramebufferRenderbuffer, glNamedFramebufferRenderbuffer);
  GG_CALL(namedFramebufferTexture, glNamedFramebufferTexture);
  GG_CALL(namedFramebufferTextureLayer, glNamedFramebufferTextureLayer);
  GG_CALL(namedRenderbufferStorage, glNamedRenderbufferStorage);
  GG_CALL(pixelStorei, glPixelStorei);
  GG_CALL(pixelTransferf, glPixelTransferf);
  GG_CALL(readPixels, glReadPixels);
  GG_CALL(textureSubImage2D, glTextureSubImage2D);
  GG_CALL(textureSubImage3D, glTextureSubImage3D);
#undef GG_CALL
};

inline const GlCalls& gl() {
  static const GlCalls calls;
  return calls;
}

inline std::uint32_t number(GLenum name) {
  return static_cast<std::uint32_t>(integer(name));
}

} // namespace ggrade::capture::recorder
