#pragma once
/// \file
/// The OpenGL functions that a tape is played with: `gl().viewport(...)`.

#include <GL/gl.h>
#include <GL/glext.h>

namespace ggrade::player {

using Function = void (*)();
Function functionOf(const char* name); ///< throws std::runtime_error where there is none

struct Gl {
#define GG_CALL(member, name)                                                                      \
  decltype(&::name) member = reinterpret_cast<decltype(&::name)>(functionOf(#name))
  GG_CALL(activeTexture, glActiveTexture);
  GG_CALL(attachShader, glAttachShader);
  GG_CALL(bindAttribLocation, glBindAttribLocation);
  GG_CALL(bindBuffer, glBindBuffer);
  GG_CALL(bindBufferBase, glBindBufferBase);
  GG_CALL(bindFragDataLocation, glBindFragDataLocation);
  GG_CALL(bindFramebuffer, glBindFramebuffer);
  GG_CALL(bindRenderbuffer, glBindRenderbuffer);
  GG_CALL(bindSampler, glBindSampler);
  GG_CALL(bindTexture, glBindTexture);
  GG_CALL(bindVertexArray, glBindVertexArray);
  GG_CALL(blendColor, glBlendColor);
  GG_CALL(blendEquationSeparatei, glBlendEquationSeparatei);
  GG_CALL(blendFuncSeparatei, glBlendFuncSeparatei);
  GG_CALL(blitFramebuffer, glBlitFramebuffer);
  GG_CALL(bufferData, glBufferData);
  GG_CALL(clear, glClear);
  GG_CALL(clearBufferfi, glClearBufferfi);
  GG_CALL(clearBufferfv, glClearBufferfv);
  GG_CALL(clearBufferiv, glClearBufferiv);
  GG_CALL(clearBufferuiv, glClearBufferuiv);
  GG_CALL(clearColor, glClearColor);
  GG_CALL(clearDepth, glClearDepth);
  GG_CALL(clearStencil, glClearStencil);
  GG_CALL(colorMaski, glColorMaski);
  GG_CALL(compileShader, glCompileShader);
  GG_CALL(copyImageSubData, glCopyImageSubData);
  GG_CALL(copyTexImage2D, glCopyTexImage2D);
  GG_CALL(copyTexSubImage2D, glCopyTexSubImage2D);
  GG_CALL(copyTexSubImage3D, glCopyTexSubImage3D);
  GG_CALL(createProgram, glCreateProgram);
  GG_CALL(createShader, glCreateShader);
  GG_CALL(cullFace, glCullFace);
  GG_CALL(deleteFramebuffers, glDeleteFramebuffers);
  GG_CALL(deleteRenderbuffers, glDeleteRenderbuffers);
  GG_CALL(deleteShader, glDeleteShader);
  GG_CALL(deleteTextures, glDeleteTextures);
  GG_CALL(deleteVertexArrays, glDeleteVertexArrays);
  GG_CALL(depthFunc, glDepthFunc);
  GG_CALL(depthMask, glDepthMask);
  GG_CALL(depthRange, glDepthRange);
  GG_CALL(disable, glDisable);
  GG_CALL(disablei, glDisablei);
  GG_CALL(drawArraysInstancedBaseInstance, glDrawArraysInstancedBaseInstance);
  GG_CALL(drawBuffer, glDrawBuffer);
  GG_CALL(drawBuffers, glDrawBuffers);
  GG_CALL(drawElementsInstancedBaseVertexBaseInstance,
          glDrawElementsInstancedBaseVertexBaseInstance);
  GG_CALL(enable, glEnable);
  GG_CALL(enablei, glEnablei);
  GG_CALL(enableVertexAttribArray, glEnableVertexAttribArray);
  GG_CALL(framebufferRenderbuffer, glFramebufferRenderbuffer);
  GG_CALL(framebufferTexture, glFramebufferTexture);
  GG_CALL(framebufferTexture2D, glFramebufferTexture2D);
  GG_CALL(framebufferTextureLayer, glFramebufferTextureLayer);
  GG_CALL(frontFace, glFrontFace);
  GG_CALL(genBuffers, glGenBuffers);
  GG_CALL(genFramebuffers, glGenFramebuffers);
  GG_CALL(genRenderbuffers, glGenRenderbuffers);
  GG_CALL(genSamplers, glGenSamplers);
  GG_CALL(genTextures, glGenTextures);
  GG_CALL(genVertexArrays, glGenVertexArrays);
  GG_CALL(generateMipmap, glGenerateMipmap);
  GG_CALL(getError, glGetError);
  GG_CALL(getUniformBlockIndex, glGetUniformBlockIndex);
  GG_CALL(getUniformLocation, glGetUniformLocation);
  GG_CALL(getAttribLocation, glGetAttribLocation);
  GG_CALL(lineWidth, glLineWidth);
  GG_CALL(linkProgram, glLinkProgram);
  GG_CALL(logicOp, glLogicOp);
  GG_CALL(patchParameteri, glPatchParameteri);
  GG_CALL(pixelStorei, glPixelStorei);
  GG_CALL(pointSize, glPointSize);
  GG_CALL(polygonMode, glPolygonMode);
  GG_CALL(polygonOffset, glPolygonOffset);
  GG_CALL(primitiveRestartIndex, glPrimitiveRestartIndex);
  GG_CALL(provokingVertex, glProvokingVertex);
  GG_CALL(readBuffer, glReadBuffer);
  GG_CALL(renderbufferStorageMultisample, glRenderbufferStorageMultisample);
  GG_CALL(sampleCoverage, glSampleCoverage);
  GG_CALL(sampleMaski, glSampleMaski);
  GG_CALL(samplerParameterf, glSamplerParameterf);
  GG_CALL(samplerParameterfv, glSamplerParameterfv);
  GG_CALL(samplerParameteri, glSamplerParameteri);
  GG_CALL(scissor, glScissor);
  GG_CALL(shaderSource, glShaderSource);
  GG_CALL(stencilFuncSeparate, glStencilFuncSeparate);
  GG_CALL(stencilMaskSeparate, glStencilMaskSeparate);
  GG_CALL(stencilOpSeparate, glStencilOpSeparate);
  GG_CALL(texImage1D, glTexImage1D);
  GG_CALL(texImage2D, glTexImage2D);
  GG_CALL(texImage2DMultisample, glTexImage2DMultisample);
  GG_CALL(texImage3D, glTexImage3D);
  GG_CALL(texImage3DMultisample, glTexImage3DMultisample);
  GG_CALL(texParameterf, glTexParameterf);
  GG_CALL(texParameterfv, glTexParameterfv);
  GG_CALL(texParameteri, glTexParameteri);
  GG_CALL(uniform1fv, glUniform1fv);
  GG_CALL(uniform1i, glUniform1i);
  GG_CALL(uniform1iv, glUniform1iv);
  GG_CALL(uniform1uiv, glUniform1uiv);
  GG_CALL(uniform2fv, glUniform2fv);
  GG_CALL(uniform2iv, glUniform2iv);
  GG_CALL(uniform2uiv, glUniform2uiv);
  GG_CALL(uniform3fv, glUniform3fv);
  GG_CALL(uniform3iv, glUniform3iv);
  GG_CALL(uniform3uiv, glUniform3uiv);
  GG_CALL(uniform4fv, glUniform4fv);
  GG_CALL(uniform4iv, glUniform4iv);
  GG_CALL(uniform4uiv, glUniform4uiv);
  GG_CALL(uniformBlockBinding, glUniformBlockBinding);
  GG_CALL(uniformMatrix2fv, glUniformMatrix2fv);
  GG_CALL(uniformMatrix2x3fv, glUniformMatrix2x3fv);
  GG_CALL(uniformMatrix2x4fv, glUniformMatrix2x4fv);
  GG_CALL(uniformMatrix3fv, glUniformMatrix3fv);
  GG_CALL(uniformMatrix3x2fv, glUniformMatrix3x2fv);
  GG_CALL(uniformMatrix3x4fv, glUniformMatrix3x4fv);
  GG_CALL(uniformMatrix4fv, glUniformMatrix4fv);
  GG_CALL(uniformMatrix4x2fv, glUniformMatrix4x2fv);
  GG_CALL(uniformMatrix4x3fv, glUniformMatrix4x3fv);
  GG_CALL(useProgram, glUseProgram);
  GG_CALL(vertexAttrib4fv, glVertexAttrib4fv);
  GG_CALL(vertexAttribDivisor, glVertexAttribDivisor);
  GG_CALL(vertexAttribIPointer, glVertexAttribIPointer);
  GG_CALL(vertexAttribPointer, glVertexAttribPointer);
  GG_CALL(viewport, glViewport);
#undef GG_CALL
};

inline const Gl& gl() {
  static const Gl calls;
  return calls;
}

} // namespace ggrade::player
