#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <stdexcept>
#include <utility>
#include <vector>

#include "board/board_table.hpp"
#include "board/host_compensator.hpp"
#include "core/bytes/crc.hpp"
#include "core/frames/extension_frame.hpp"
#include "core/frames/sensor_frame.hpp"

// The code of a flash image, fed with bytes and read by its frames, for whole boards in tests.
namespace fog::test {

/// Frames that a board can send.
struct FrameChoice {
  OutputSelection output;
  OutputOptions options;
};
inline constexpr std::array kFrameChoices{
    FrameChoice{OutputSelection::kvh, 0},
    FrameChoice{OutputSelection::kvh, kRotationIsAngle | kRotationIsUndelayed},
    FrameChoice{OutputSelection::compact, 0},
    FrameChoice{OutputSelection::both, kRotationIsUndelayed}};

/// One for any model, or one made for a header.
enum class ImageKind : std::uint8_t { generic, specialised };

/// What the line does to the bytes of a sample.
struct LineDamage {
  enum class Kind : std::uint8_t { none, bit_flipped, byte_lost, bytes_added };
  Kind kind = Kind::none;
  std::uint32_t where = 0;  ///< any number; of added bytes, what they are
};

/// An extension record on the line, before its sample.
struct LineRecord {
  ExtensionRecord record;
  LineDamage damage{};
  std::uint8_t other_kind = 0;  ///< so many numbers beyond that of its input
};

/// The bytes of a frame as they come out of the line.
template <class Frame>
std::vector<std::uint8_t> damaged(const Frame& frame, const LineDamage& damage) {
  std::vector<std::uint8_t> bytes(frame.begin(), frame.end());
  const std::size_t at = damage.where % bytes.size();
  switch (damage.kind) {
    case LineDamage::Kind::none:
      break;
    case LineDamage::Kind::bit_flipped:
      bytes[at] = static_cast<std::uint8_t>(bytes[at] ^ (1U << (damage.where / 16U % 8U)));
      break;
    case LineDamage::Kind::byte_lost:
      bytes.erase(bytes.begin() + static_cast<std::ptrdiff_t>(at));
      break;
    case LineDamage::Kind::bytes_added:
      // Half of a frame like this one, so that it begins as one does, or anything.
      bytes.insert(bytes.begin(), frame.begin(), frame.begin() + static_cast<std::ptrdiff_t>(at));
      if (damage.where / 16U % 2U == 0) bytes[0] = static_cast<std::uint8_t>(damage.where >> 8U);
      break;
  }
  return bytes;
}

inline std::vector<std::uint8_t> bytes_of(const LineRecord& record) {
  constexpr std::size_t kKind = 2;  // SPEC.md, "Sensor stream"
  constexpr std::size_t kCrc = 8;
  ExtensionFrame frame = encode_extension_frame(record.record);
  frame[kKind] = static_cast<std::uint8_t>(frame[kKind] + record.other_kind);
  const std::uint16_t crc = crc16(frame.data() + 1, kCrc - 1);
  frame[kCrc] = static_cast<std::uint8_t>(crc);
  frame[kCrc + 1] = static_cast<std::uint8_t>(crc >> 8U);
  return damaged(frame, record.damage);
}

/// The pipeline of an image.
class BoardImage {
 public:
  static constexpr std::size_t kMaxStateWords = fogcomp::board::HostCompensator::kMaxStateWords;

  virtual ~BoardImage() = default;
  virtual std::size_t keep(std::uint32_t* words) = 0;
  virtual void resume(std::uint32_t* words, bool was_short) = 0;
  virtual void resume_after(std::uint32_t* words, SampleTime newest) = 0;
  virtual bool ended_block() const = 0;

  /// What the board makes of the sample and the record before it; nothing if its bytes make none.
  /// One of kFramesEvery comes as bytes and is answered in frames, and so do all from a damage on
  /// until the next answer. Frames are made of nothing but what the board has found, and take two
  /// thirds of the time.
  std::optional<OutputSample> process(const SensorSample& sample, SampleTime now,
                                      const LineDamage& damage = {},
                                      const std::optional<LineRecord>& record = {}) {
    const bool record_whole =
        !record || (record->damage.kind == LineDamage::Kind::none && record->other_kind == 0);
    const bool whole = damage.kind == LineDamage::Kind::none && record_whole && !in_pieces_;
    if (whole && ++samples_ % kFramesEvery != 0) {
      if (record) take(record->record);
      return judge(sample, now);
    }
    std::size_t size = 0;
    std::vector<std::uint8_t> bytes = record ? bytes_of(*record) : std::vector<std::uint8_t>();
    for (const std::uint8_t byte : damaged(encode_sensor_frame(sample), damage)) {
      bytes.push_back(byte);
    }
    for (const std::uint8_t byte : bytes) size = feed(byte, frames_.data(), now);
    in_pieces_ = size == 0;
    if (in_pieces_ && !whole) return std::nullopt;
    if (!frames_say(last(), size)) ++false_frames_;
    return last();
  }

  /// No sample has come. The frames must call no rate valid, and say why.
  void answer_silence() {
    const std::size_t size = silence(frames_.data());
    const Status status = last().status;
    const bool said = has_any(status, Status::no_samples) && !last().compensated_valid() &&
                      !last().denoised_valid();
    if (!said || !frames_say(last(), size)) ++false_frames_;
  }

  /// Frames that did not say what the board had found.
  std::uint64_t false_frames() const { return false_frames_; }

 protected:
  explicit BoardImage(const ModelParameters& parameters) : parameters_(parameters) {}
  virtual std::size_t feed(std::uint8_t byte, std::uint8_t* out, SampleTime now) = 0;
  virtual std::size_t silence(std::uint8_t* out) = 0;
  virtual void take(const ExtensionRecord& record) = 0;
  virtual OutputSample judge(const SensorSample& sample, SampleTime now) = 0;
  virtual const OutputSample& last() const = 0;

 private:
  bool frames_say(const OutputSample& out, std::size_t size) const {
    if (size != output_bytes(parameters_.output)) return false;
    const std::uint8_t* at = frames_.data();
    if (parameters_.output != OutputSelection::compact) {
      if (!kvh_says(out, at)) return false;
      at += kKvhFrameBytes;
    }
    if (parameters_.output == OutputSelection::kvh) return true;
    OutputSample said;
    std::uint16_t delay = 0;
    return decode_compact_frame(at, said, delay) && said.status == out.status &&
           said.compensated.raw() == out.compensated.raw() && said.drift.raw() == out.drift.raw();
  }
  bool kvh_says(const OutputSample& out, const std::uint8_t* frame) const {
    constexpr std::size_t kStatus = 28;  // SPEC.md, "KVH format A"
    constexpr std::uint8_t kZValid = 4;
    const bool undelayed = (parameters_.output_options & kRotationIsUndelayed) != 0U;
    const bool valid = undelayed ? out.compensated_valid() : out.denoised_valid();
    return frame[kStatus] == (valid ? kZValid : 0);
  }

  static constexpr std::uint32_t kFramesEvery = 17;  // prime: lines repeat and swap every fourth

  const ModelParameters& parameters_;
  std::array<std::uint8_t, kMaxOutputBytes> frames_{};
  std::uint32_t samples_ = 0;
  bool in_pieces_ = false;  // the parser may have bytes of a damaged sample
  std::uint64_t false_frames_ = 0;
};

template <class Pipeline>
class BoardImageOf final : public BoardImage {
 public:
  explicit BoardImageOf(const ModelParameters& parameters)
      : BoardImage(parameters), pipeline_(parameters, IntegrityToken::not_needed()) {
    static_assert(Pipeline::kMaxStateWords <= kMaxStateWords);
  }
  std::size_t keep(std::uint32_t* words) override { return pipeline_.keep(words); }
  void resume(std::uint32_t* words, bool was_short) override { pipeline_.resume(words, was_short); }
  void resume_after(std::uint32_t* words, SampleTime newest) override {
    pipeline_.resume_after(words, newest);
  }
  bool ended_block() const override { return pipeline_.ended_block(); }

 private:
  std::size_t feed(std::uint8_t byte, std::uint8_t* out, SampleTime now) override {
    const auto as_it_is = [](const SensorSample& sample) -> const SensorSample& { return sample; };
    return pipeline_.feed(byte, out, as_it_is, [now] { return now; });
  }
  std::size_t silence(std::uint8_t* out) override { return pipeline_.answer_silence(out); }
  void take(const ExtensionRecord& record) override { pipeline_.take(record); }
  OutputSample judge(const SensorSample& sample, SampleTime now) override {
    return pipeline_.process(sample, now);
  }
  const OutputSample& last() const override { return pipeline_.last(); }

  Pipeline pipeline_;
};

/// The images that are built with a header of paper_like_model() without a denoiser and these
/// frames: of the model as it is, and of one that remembers temperatures or has inputs beside them
/// (with_memory(), with_input()).
constexpr EffectMask kPaperEffects = bit_of(effects::Bias<BoardNumbers>::description) |
                                     bit_of(effects::BiasTemperature<BoardNumbers>::description) |
                                     bit_of(effects::TemperatureRate<BoardNumbers>::description);
constexpr NetworkInputMask kPaperInputs =
    bit_of(NetworkInput::temperature) | bit_of(NetworkInput::temperature_rate);
constexpr EffectMask kMemoryEffects =
    kPaperEffects | bit_of(effects::ThermalLag<BoardNumbers>::description) |
    bit_of(effects::ThermalHysteresis<BoardNumbers>::description) |
    bit_of(effects::WarmUp<BoardNumbers>::description) |
    bit_of(effects::AxialGradient<BoardNumbers>::description) |
    bit_of(effects::Magnetic<BoardNumbers>::description) |
    bit_of(effects::LightPower<BoardNumbers>::description);
template <std::size_t kFrames, bool kMemory>
using PaperImage =
    Compensator<kMemory ? kMemoryEffects : kPaperEffects, kMemory ? kAllExpressions : 0,
                kPaperInputs, 0, 0, kFrameChoices[kFrames].output, kFrameChoices[kFrames].options>;

/// The board of a table. Throws if no specialised image has room for it.
template <std::size_t kFrames = 0, bool kMemory = false>
std::unique_ptr<BoardImage> make_image(const fogcomp::board::BoardTable& table,
                                       const ModelParameters& parameters, ImageKind kind) {
  if (kind == ImageKind::generic) {
    return std::make_unique<BoardImageOf<fogcomp::board::HostCompensator>>(parameters);
  }
  ModelParameters read;
  using Image = PaperImage<kFrames, kMemory>;
  if (read_model(table.span(), Image::capacity, read) == ModelError::none) {
    return std::make_unique<BoardImageOf<Image>>(parameters);
  }
  if constexpr (kFrames + 1 < kFrameChoices.size()) {
    return make_image<kFrames + 1, kMemory>(table, parameters, kind);
  } else if constexpr (!kMemory) {
    return make_image<0, true>(table, parameters, kind);
  }
  throw std::invalid_argument("no specialised image has room for the table");
}

}  // namespace fog::test
