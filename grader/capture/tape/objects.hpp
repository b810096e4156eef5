#pragma once
/// \file
/// What commands of a tape refer to: images, buffers, programs, state; each as OpenGL has it now.
/// The context must be current, in a recorder's Session. What can't be recorded refuses the tape.

#include "capture/recorder/images.hpp"
#include "capture/recorder/session.hpp"

#include <GL/gl.h>
#include <nlohmann/json.hpp>

namespace ggrade::capture::tape {

// images.cpp

/// The number of an image. Writes down what it holds, unless that is known.
/// \param target the texture's, for where OpenGL doesn't tell; ignored for renderbuffers
std::uint32_t useImage(trace::ImageKind kind, GLuint name, GLenum target = GL_TEXTURE_2D);
/// The same, of a texture that has yet to get its level from the command that follows.
std::uint32_t useUndefined(GLuint texture, GLenum target);
/// It holds something else, that no command of the tape has put there.
void imageChanged(trace::ImageKind kind, GLuint name);
/// Its name stands for nothing any more.
void imageDeleted(trace::ImageKind kind, GLuint name);

/// What is drawn into: the window, or the attachments of a framebuffer object, with the draw
/// buffers by output.
nlohmann::json targetJson(const recorder::Target& target);
/// The bound read framebuffer and its read buffer.
nlohmann::json readTargetJson();
/// What the sampler samples now. Leaves another unit active.
nlohmann::json textureJson(GLenum target, GLuint unit);

// buffers.cpp

/// Some buffer has got other bytes.
void buffersChanged();
/// The number of the blob with the buffer's bytes, from `start`.
std::uint64_t bufferBlob(GLuint buffer, GLint64 start = 0, GLint64 bytes = -1);

// programs.cpp

/// Remembers the sources that a program is about to be linked from.
void linking(GLuint program);
/// The same, of a program whose sources can't be known.
void unknownProgram(GLuint program);
/// Writes down the programs that were linked and have drawn nothing yet.
void addUnusedPrograms();
/// There is no program, and the profile is core: no pixel changes.
bool drawsNothing();
/// The program in use: `program`, `uniforms`, `blocks`, `textures`, `attributes` of a draw.
void addProgram(nlohmann::json& draw);

// state.cpp

/// Everything that OpenGL's state says of how a draw, clear or blit goes.
nlohmann::json stateJson();

} // namespace ggrade::capture::tape
