#pragma once

#include <string>

namespace fogcomp {

/// A text that was compiled in from a file of the source tree (FogEmbedFiles.cmake), so that the
/// tool needs no installation.
struct EmbeddedFile {
  std::string name;  ///< without folder and extension
  std::string text;
};

}  // namespace fogcomp
