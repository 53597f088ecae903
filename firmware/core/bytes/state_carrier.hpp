#pragma once

#include <cstddef>
#include <cstdint>
#include <type_traits>

namespace fog {

/// Saves the state of objects over a restart of the board, or restores it. Each object lists its
/// members in `carry(StateCarrier&)`; the same list serves both directions, so the two cannot
/// disagree. The owner of the words checks that they are intact and of the same model.
class StateCarrier {
 public:
  enum class Way : bool { to_words, to_members };

  /// `words` has to hold all members.
  StateCarrier(Way way, std::uint32_t* words) : next_(words), way_(way) {}

  template <class Member>
  void operator()(Member& member) {
    static_assert(std::is_trivially_copyable_v<Member>);
    static_assert(sizeof(Member) % sizeof(std::uint32_t) == 0);
    carry(&member, sizeof member);
  }

  bool restores() const { return way_ == Way::to_members; }
  /// End of the words written or read so far.
  const std::uint32_t* end() const { return next_; }

 private:
  void carry(void* member, std::size_t bytes);  // out of line: a member costs a call

  std::uint32_t* next_;
  Way way_;
};

}  // namespace fog
