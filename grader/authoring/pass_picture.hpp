#pragma once
/// \file
/// Pictures of what a pass drew, for a step whose window shows nothing new.

#include "image/image.hpp"
#include "trace/trace.hpp"

#include <nlohmann/json.hpp>

#include <string>

namespace ggrade::authoring {

/// The textures that `wanted` describes, as a picture of rows of three:
///
///     { "attachment": "depth", "sizes": [[1024, 1024]], "height": 360, "light": false }
///
/// Of each size, in that order, what the last pass left that drew into such an attachment of a
/// texture of that size (a stencil may be the window's); `attachment` may be a list, of which each
/// size then shows all. Each is scaled to `height` pixels (larger ones averaged, smaller ones in
/// squares). Depths as trace::picture shows them; colours as stored or, with `light`, divided by
/// the greatest value of all and sRGB encoded, as a display would show them. Throws UsageError,
/// with `name`, when no pass drew such a texture or there is no copy of it.
Image passPicture(const trace::Trace& trace, const nlohmann::json& wanted, const std::string& name);

} // namespace ggrade::authoring
