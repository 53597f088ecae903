#include "dataset/data_hash.hpp"

#include "core/protocol/crc.hpp"
#include "dataset/input_columns.hpp"

namespace fogcomp {

std::uint32_t data_hash(const Recording& recording, std::uint32_t crc) {
  const auto add = [&crc](const std::vector<double>& column) {
    crc = fog::crc32(reinterpret_cast<const std::uint8_t*>(column.data()),
                     column.size() * sizeof(double), crc);
  };
  add(recording.time_s);
  add(recording.temperature_degc);
  add(recording.rate_dph);
  add(recording.input_rate_dph);
  for (std::size_t i = 0; i < fog::kExtensionInputs; ++i) {
    const std::vector<double>& column = extension_column(recording, i);
    if (column.empty()) continue;
    // Its number, so that the same values in another column make another hash.
    const auto number = static_cast<std::uint8_t>(i);
    crc = fog::crc32(&number, 1, crc);
    add(column);
  }
  return crc;
}

}  // namespace fogcomp
