#pragma once

#include <cstdint>
#include <random>
#include <string>
#include <vector>

namespace fogcomp::injection {

/// One bit to flip.
struct Flip {
  std::string area;
  std::uint32_t address;
  unsigned bit;  ///< 0 to 7
};

/// Words "NAME:ADDRESS:BYTES:COUNT": COUNT bits of an area of memory, drawn without repetition, or
/// all of them where COUNT is `all`. Numbers as strtoul reads them. Throws std::runtime_error.
std::vector<Flip> plan_flips(const std::vector<std::string>& areas, std::mt19937& random);

}  // namespace fogcomp::injection
