#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "core/frames/slots_record.hpp"
#include "core/health/sealed_scan.hpp"
#include "core/pipeline/model_parameters.hpp"
#include "core/pipeline/model_slot.hpp"
#include "core/pipeline/slot_loader.hpp"
#include "fog_model.h"
#include "hal/model_memory.hpp"
#include "hal/processor.hpp"

// Source of the model table: the header that the image is built with or, if that says so, a slot of
// flash.
namespace fog::app {

#ifdef FOG_MODEL_IN_SLOTS

class ModelTable {
 public:
  static constexpr bool is_loaded = true;
  static constexpr std::size_t sealed_parts = 4;
  using Sealed = SealedScan<sealed_parts>::Parts;

  /// Decodes the table; on an error there is no model.
  ModelError read(const ModelShape& capacity, ModelParameters& parameters) {
    choice_ = choose_slot(memories(), capacity, hal::processor_number(), parameters);
    return choice_.error;
  }
  /// Serial number of the gyro, ASCII; empty if the table has none. Requires a table.
  const char* serial() const {
    return reinterpret_cast<const char*>(choice_.used().table.data + kIdentityAt);
  }
  /// The parts that the self-test checks.
  Sealed sealed(Span<const std::uint8_t> image, Span<const std::uint8_t> constants) const {
    if (!is_used()) return {image, {}, {}, constants};
    return {image, slot_magic(), choice_.used().sealed, constants};
  }
  /// Unique among the tables that this image could use.
  std::uint32_t key() const { return is_used() ? table_crc(choice_.used()) : 0; }
  /// The properties that decide whether another table may be loaded.
  LoadTarget load_target() const {
    return fog::load_target(choice_, memories(), hal::processor_number());
  }
  /// For the slots record.
  SlotsRecord slots() const {
    SlotsRecord record{static_cast<std::uint8_t>(choice_.slot), {}};
    for (std::size_t i = 0; i < kModelSlots; ++i) record.slots[i] = record_of(choice_.slots[i]);
    return record;
  }

 private:
  static std::array<SlotMemory, kModelSlots> memories() {
    const auto found = hal::model_memories();
    return {{{found[0].words, found[0].size}, {found[1].words, found[1].size}}};
  }
  bool is_used() const { return choice_.error == ModelError::none; }
  static std::uint32_t table_crc(const SlotContents& slot) {
    return static_cast<std::uint32_t>(slot.table[slot.table.size - 1]);
  }
  static SlotRecord record_of(const SlotContents& slot) {
    SlotRecord record{static_cast<std::uint8_t>(slot.error), slot.sequence, 0, 0, {}};
    if (slot.table.size <= kProcessorAt) return record;
    record.model = static_cast<std::uint32_t>(slot.table[kIdentityAt - 1]);
    record.table = table_crc(slot);
    __builtin_memcpy(record.serial.data(), slot.table.data + kIdentityAt, sizeof record.serial);
    return record;
  }

  SlotChoice choice_;
};

#else

class ModelTable {
 public:
  static constexpr bool is_loaded = false;
  static constexpr std::size_t sealed_parts = 2;
  using Sealed = SealedScan<sealed_parts>::Parts;

  ModelError read(const ModelShape& capacity, ModelParameters& parameters) {
    const ModelError error = read_model({fog_model, FOG_MODEL_WORDS}, capacity, parameters);
    if constexpr (FOG_MODEL_BOUND != 0) {
      if (error == ModelError::none &&
          is_bound_elsewhere(&fog_model[kProcessorAt], hal::processor_number())) {
        read_model({}, capacity, parameters);  // no model
        return ModelError::other_board;
      }
    }
    return error;
  }
  /// A refused table may contain anything. Not inline, because the caller has a table of its own.
  [[gnu::noinline]] static const char* serial() {
    return reinterpret_cast<const char*>(&fog_model[kIdentityAt]);
  }
  static Sealed sealed(Span<const std::uint8_t> image, Span<const std::uint8_t> constants) {
    return {image, constants};
  }
  static constexpr std::uint32_t key() { return 0; }  // the seal of the image identifies it
};

#endif

}  // namespace fog::app
