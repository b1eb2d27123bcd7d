#pragma once

#include "app/picture_options.h"

namespace asos {

/// --from: scene, camera, settings and display of a saved picture. Options that are added after it
/// override it, wherever they are typed, so add it first. A file that cannot be read is no usage
/// error: the error is stored in `arguments`.
void add_from_option(CLI::App& app, PictureArguments& arguments);

}  // namespace asos
