#pragma once

#include "app/picture_options.h"

namespace asos {

/// --from: scene, camera, settings and display of a picture that was saved before. Options that
/// stand in the help behind it override what it says, wherever they are typed, so this has to be
/// added before them. A file that cannot be read is no usage error: it is left in `arguments`.
void add_from_option(CLI::App& app, PictureArguments& arguments);

}  // namespace asos
