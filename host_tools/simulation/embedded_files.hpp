#pragma once

#include <string>
#include <vector>

#include "support/embedded_file.hpp"

namespace fogcomp::simulation {

/// host_tools/simulation/profiles/*.profile
const std::vector<EmbeddedFile>& ready_made_profiles();
/// host_tools/simulation/presets/*.gyro
const std::vector<EmbeddedFile>& ready_made_presets();

/// The text of `name` among `files`, or of the file with that path. Throws InputError with the
/// nearest name if neither exists; `what` is "profile" or "preset".
std::string find_text(const std::string& name, const std::vector<EmbeddedFile>& files,
                      const std::string& what);

/// The first comment of an embedded file, up to its first full stop, colon, semicolon or bracket.
std::string first_sentence(const EmbeddedFile& file);

}  // namespace fogcomp::simulation
