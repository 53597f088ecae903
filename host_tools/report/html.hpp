#pragma once

#include <string>
#include <utility>
#include <vector>

#include "findings/text.hpp"
#include "support/embedded_file.hpp"
#include "support/json.hpp"

namespace fogcomp::report {

/// A text as the content of an element or of a quoted attribute.
std::string escaped(std::string text);
std::string escaped(const findings::Text& text);

/// As data for a script: nothing in it may end the element.
std::string script_data(const Json& json);

/// The text of the embedded file of that name, which must be there.
const std::string& file_of(const std::vector<EmbeddedFile>& files, const std::string& name);

/// The frame with each {{part}} put in.
std::string filled(const std::string& frame,
                   const std::vector<std::pair<std::string, std::string>>& parts);

}  // namespace fogcomp::report
