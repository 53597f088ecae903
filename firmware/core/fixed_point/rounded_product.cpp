#include "core/fixed_point/rounded_product.hpp"

#include "core/fixed_point/shift.hpp"

namespace fog {

std::int64_t rounded_product(std::int32_t a, std::int32_t b, int bits) {
  return round_shift(std::int64_t{a} * b, bits);
}

}  // namespace fog
