#pragma once
/// \file
/// What computers leave in folders unasked: passed over and counted, never an error.

#include <string_view>

namespace ggrade::intake {

/// The component of `path` (parts divided by / or \) that makes it clutter: `__MACOSX`, `.vs`,
/// `.git`, `.DS_Store`, `Thumbs.db`, or `._*` for a name that starts so. Empty if there is none.
std::string_view clutterIn(std::string_view path);

} // namespace ggrade::intake
