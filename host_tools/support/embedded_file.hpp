#pragma once

#include <string>

namespace fogcomp {

/// A text file of the source tree, compiled in (FogEmbedFiles.cmake), so that the tool needs no
/// installation.
struct EmbeddedFile {
  std::string name;  ///< without folder and extension
  std::string text;
};

}  // namespace fogcomp
