#include "report/embedded_page.hpp"

#ifdef FOGCOMP_ENGINE
// Defined in embedded_engine.S.in.
extern "C" const char fogcomp_engine_module[];
extern "C" const char fogcomp_engine_module_end[];
extern "C" const char fogcomp_engine_script[];
extern "C" const char fogcomp_engine_script_end[];

namespace fogcomp::report {
namespace {

std::string_view between(const char* begin, const char* end) {
  return {begin, static_cast<std::size_t>(end - begin)};
}

}  // namespace

EmbeddedEngine embedded_engine() {
  return {between(fogcomp_engine_module, fogcomp_engine_module_end),
          between(fogcomp_engine_script, fogcomp_engine_script_end)};
}

}  // namespace fogcomp::report
#else
namespace fogcomp::report {

EmbeddedEngine embedded_engine() {
  return {};
}

}  // namespace fogcomp::report
#endif
