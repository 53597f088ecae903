#include "flip_plan.hpp"

#include <algorithm>
#include <numeric>
#include <stdexcept>

namespace fogcomp::injection {
namespace {

std::vector<std::string> split(const std::string& text) {
  std::vector<std::string> parts(1);
  for (const char c : text) {
    if (c == ':') {
      parts.emplace_back();
    } else {
      parts.back() += c;
    }
  }
  return parts;
}

}  // namespace

std::vector<Flip> plan_flips(const std::vector<std::string>& areas, std::mt19937& random) {
  std::vector<Flip> flips;
  for (const std::string& area : areas) {
    const std::vector<std::string> parts = split(area);
    if (parts.size() != 4) throw std::runtime_error("no area NAME:ADDRESS:BYTES:COUNT: " + area);
    const auto address = static_cast<std::uint32_t>(std::stoul(parts[1], nullptr, 0));
    const auto bytes = static_cast<std::uint32_t>(std::stoul(parts[2], nullptr, 0));
    std::vector<std::uint32_t> bits(std::size_t{bytes} * 8);
    std::iota(bits.begin(), bits.end(), 0U);
    if (parts[3] != "all") {
      std::shuffle(bits.begin(), bits.end(), random);
      bits.resize(std::min(bits.size(), std::size_t{std::stoul(parts[3])}));
    }
    for (const std::uint32_t bit : bits) {
      flips.push_back({parts[0], address + bit / 8, bit % 8});
    }
  }
  return flips;
}

}  // namespace fogcomp::injection
