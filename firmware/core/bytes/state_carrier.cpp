#include "core/bytes/state_carrier.hpp"

namespace fog {

void StateCarrier::carry(void* member, std::size_t bytes) {
  if (restores()) {
    __builtin_memcpy(member, next_, bytes);
  } else {
    __builtin_memcpy(next_, member, bytes);
  }
  next_ += bytes / sizeof *next_;
}

}  // namespace fog
