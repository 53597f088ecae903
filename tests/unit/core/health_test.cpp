#include <gtest/gtest.h>

#include <cstdint>
#include <functional>
#include <random>
#include <utility>
#include <vector>

#include "core/frames/compact_frame.hpp"
#include "core/frames/health_record.hpp"
#include "core/frames/health_request.hpp"
#include "core/frames/kvh_frame.hpp"
#include "core/frames/rate_float.hpp"
#include "core/health/image_seal.hpp"
#include "core/health/integrity_token.hpp"
#include "core/health/memory_scan.hpp"
#include "core/health/sealed_scan.hpp"

namespace {

using fog::Status;

std::vector<std::uint8_t> sealed(std::size_t size, std::uint32_t start, std::uint32_t seed) {
  std::mt19937 random(seed);
  std::vector<std::uint8_t> bytes(size);
  for (std::uint8_t& byte : bytes) byte = static_cast<std::uint8_t>(random());
  const auto seal = fog::seal_of(fog::crc32(bytes.data(), bytes.size(), start));
  bytes.insert(bytes.end(), seal.begin(), seal.end());
  return bytes;
}

// ---- image ----

TEST(SealedScan, EndsIntactForEverySizeOfPieceAndOfParts) {
  for (const std::size_t size : {0U, 1U, 63U, 1000U}) {
    const auto image = sealed(size, fog::kImageCrcStart, 1);
    const auto constants = sealed(37, fog::kIntactImage, 2);
    for (const std::size_t piece : {1U, 7U, 34U, 5000U}) {
      fog::SealedScan<2> scan(
          {{{image.data(), image.size()}, {constants.data(), constants.size()}}});
      for (int pass = 0; pass < 3; ++pass) {
        std::size_t steps = 1;
        volatile std::uint32_t crc = 0;
        while (!scan.step(piece, crc)) ++steps;
        EXPECT_EQ(crc, fog::kIntactImage);
        EXPECT_EQ(steps, (scan.size() + piece - 1) / piece);
      }
    }
  }
}

TEST(SealedScan, FindsEveryFlippedBitOfImageConstantsAndSeals) {
  auto image = sealed(200, fog::kImageCrcStart, 3);
  auto constants = sealed(50, fog::kIntactImage, 4);
  for (auto* part : {&image, &constants}) {
    for (std::size_t bit = 0; bit < 8 * part->size(); ++bit) {
      std::uint8_t& byte = (*part)[bit / 8];
      byte = static_cast<std::uint8_t>(byte ^ (1U << (bit % 8)));
      fog::SealedScan<2> scan(
          {{{image.data(), image.size()}, {constants.data(), constants.size()}}});
      volatile std::uint32_t crc = 0;
      while (!scan.step(11, crc)) {
      }
      EXPECT_NE(crc, fog::kIntactImage) << bit;
      byte = static_cast<std::uint8_t>(byte ^ (1U << (bit % 8)));
    }
  }
}

// An image whose model is loaded, with the model between it and its constants; or without one.
TEST(SealedScan, GoesOverASlotAsWell) {
  const auto image = sealed(200, fog::kImageCrcStart, 5);
  const auto constants = sealed(50, fog::kIntactImage, 6);
  for (const bool loaded : {true, false}) {
    auto slot = sealed(120, fog::kIntactImage, 7);
    const std::size_t slot_size = loaded ? slot.size() : 0;
    for (std::size_t bit = 0; bit <= 8 * slot_size; ++bit) {
      const bool flipped = bit < 8 * slot_size;
      if (flipped) slot[bit / 8] = static_cast<std::uint8_t>(slot[bit / 8] ^ (1U << (bit % 8)));
      const std::size_t head = std::min<std::size_t>(slot_size, 4);
      fog::SealedScan<4> scan({{{image.data(), image.size()},
                                {slot.data(), head},
                                {slot.data() + head, slot_size - head},
                                {constants.data(), constants.size()}}});
      std::size_t steps = 1;
      volatile std::uint32_t crc = 0;
      while (!scan.step(13, crc)) ++steps;
      EXPECT_EQ(crc == fog::kIntactImage, !flipped) << bit;
      EXPECT_EQ(steps, (image.size() + slot_size + constants.size() + 12) / 13);
      if (flipped) slot[bit / 8] = static_cast<std::uint8_t>(slot[bit / 8] ^ (1U << (bit % 8)));
    }
  }
}

bool next_is_intact(fog::IntegrityToken& token) {
  token.consume();
  const bool for_status = token.for_status() == fog::kIntactImage;
  EXPECT_EQ(for_status, token.for_frames() == fog::kIntactImage);
  return for_status;
}

TEST(IntegrityToken, LastsOnlyAsLongAsChecksAreGiven) {
  fog::IntegrityToken token(10);
  EXPECT_FALSE(next_is_intact(token));  // none given yet
  token.publish(fog::kIntactImage, fog::kIntactImage);
  for (int i = 1; i < 10; ++i) EXPECT_FALSE(next_is_intact(token)) << i;
  for (int round = 0; round < 5; ++round) {
    for (int i = 0; i < 10; ++i) {
      EXPECT_TRUE(next_is_intact(token)) << i;
      if (i == 4) token.publish(fog::kIntactImage, fog::kIntactImage);
    }
  }
  for (int i = 0; i < 10; ++i) EXPECT_TRUE(next_is_intact(token));
  for (int i = 0; i < 100; ++i) EXPECT_FALSE(next_is_intact(token));  // the check stopped
  token.publish(0x12345678, 0x12345678);
  for (int i = 0; i < 10; ++i) EXPECT_FALSE(next_is_intact(token));
  fog::IntegrityToken no_image = fog::IntegrityToken::not_needed();
  for (int i = 0; i < 1000; ++i) EXPECT_TRUE(next_is_intact(no_image));
}

// The frame of a damaged image must be useless even if its status hides the damage.
TEST(Frames, OfADamagedImageAreRefusedOrSayNotValid) {
  fog::OutputSample good;
  good.denoised = fog::Rate::from_raw(12345);
  fog::OutputSample admitted = good;
  admitted.status = Status::self_test_failed;
  std::mt19937 random(1);
  fog::OutputSample read;
  std::uint16_t delay = 0;
  for (int i = 0; i < 1000; ++i) {
    const std::uint32_t image_crc =
        i == 0 ? fog::kImageCrcStart : static_cast<std::uint32_t>(random());
    const fog::KvhFrame wrong = fog::encode_kvh_frame({}, fog::rate_as_radians_float(good.denoised),
                                                      good.denoised_valid(), 0, image_crc);
    EXPECT_NE(fog::crc32(wrong.data(), wrong.size()), 0U);
    const fog::KvhFrame right = fog::encode_kvh_frame(
        {}, fog::rate_as_radians_float(admitted.denoised), admitted.denoised_valid(), 0, image_crc);
    EXPECT_EQ(fog::crc32(right.data(), right.size()), 0U);
    EXPECT_EQ(right[28], 0);
    const fog::CompactFrame compact = fog::encode_compact_frame(good, 465, image_crc);
    EXPECT_FALSE(fog::decode_compact_frame(compact.data(), read, delay));
    const fog::CompactFrame said = fog::encode_compact_frame(admitted, 465, image_crc);
    ASSERT_TRUE(fog::decode_compact_frame(said.data(), read, delay));
    EXPECT_FALSE(read.compensated_valid() || read.denoised_valid());
  }
}

// ---- memory ----

/// A memory with faulty writes.
struct FaultyMemory {
  std::vector<std::uint32_t> cells;
  std::function<void(std::vector<std::uint32_t>&, std::size_t written, std::uint32_t before)> fault;

  std::uint32_t read(std::size_t i) const { return cells[i]; }
  void write(std::size_t i, std::uint32_t value) {
    const std::uint32_t before = cells[i];
    cells[i] = value;
    if (fault) fault(cells, i, before);
  }
};

constexpr std::size_t kWords = fog::MemoryScan<>::kBlockWords;

bool any_pattern_fails(FaultyMemory memory) {
  bool failed = false;
  for (const std::uint32_t pattern : fog::kMarchPatterns) {
    FaultyMemory copy = memory;
    failed = failed || !fog::march(copy, kWords, pattern);
  }
  return failed;
}

TEST(March, PassesAGoodMemoryAndLeavesItAsItWas) {
  std::mt19937 random(1);
  FaultyMemory memory{std::vector<std::uint32_t>(kWords), {}};
  for (std::uint32_t& cell : memory.cells) cell = static_cast<std::uint32_t>(random());
  const auto before = memory.cells;
  for (const std::uint32_t pattern : fog::kMarchPatterns) {
    EXPECT_TRUE(fog::march_and_restore<kWords>(memory, pattern));
    EXPECT_EQ(memory.cells, before);
  }
}

TEST(March, FindsEveryStuckCellWithEachPattern) {
  for (std::size_t bit = 0; bit < 32 * kWords; ++bit) {
    const std::uint32_t mask = 1U << (bit % 32);
    for (const bool high : {false, true}) {
      FaultyMemory memory{
          std::vector<std::uint32_t>(kWords), [&](auto& cells, std::size_t, std::uint32_t) {
            cells[bit / 32] = high ? cells[bit / 32] | mask : cells[bit / 32] & ~mask;
          }};
      for (const std::uint32_t pattern : fog::kMarchPatterns) {
        FaultyMemory copy = memory;
        EXPECT_FALSE(fog::march(copy, kWords, pattern)) << bit << " " << high;
      }
    }
  }
}

// Writing the pattern to the first word of two turns the second over. Until the downward pass the
// second one is written after it.
TEST(March, DisturbedAfterItsLastWrite_FoundByTheLastRead) {
  for (const std::uint32_t pattern : fog::kMarchPatterns) {
    FaultyMemory memory{std::vector<std::uint32_t>(kWords),
                        [=](auto& cells, std::size_t i, std::uint32_t before) {
                          if (i == 0 && before == ~pattern && cells[0] == pattern) {
                            cells[kWords - 1] = ~pattern;
                          }
                        }};
    EXPECT_FALSE(fog::march(memory, kWords, pattern)) << pattern;
  }
}

TEST(March, FindsEveryCellThatCannotRiseOrFall) {
  for (std::size_t bit = 0; bit < 32 * kWords; ++bit) {
    const std::uint32_t mask = 1U << (bit % 32);
    for (const bool rises : {false, true}) {
      EXPECT_TRUE(any_pattern_fails({std::vector<std::uint32_t>(kWords),
                                     [&](auto& cells, std::size_t written, std::uint32_t before) {
                                       if (written != bit / 32) return;
                                       if (rises && (before & mask) == 0U) cells[written] &= ~mask;
                                       if (!rises && (before & mask) != 0U) cells[written] |= mask;
                                     }}))
          << bit;
    }
  }
}

// A transition of one cell, up or down, inverts another cell, in the same word or in another.
TEST(March, FindsEveryPairOfCoupledCells) {
  int missed = 0;
  for (std::size_t from = 0; from < 32 * kWords; ++from) {
    for (std::size_t to = 0; to < 32 * kWords; ++to) {
      if (from == to) continue;
      const std::uint32_t mask = 1U << (from % 32);
      for (const bool rising : {false, true}) {
        missed += !any_pattern_fails({std::vector<std::uint32_t>(kWords),
                                      [&](auto& cells, std::size_t written, std::uint32_t before) {
                                        if (written != from / 32) return;
                                        const bool was = (before & mask) != 0U;
                                        const bool is = (cells[written] & mask) != 0U;
                                        if (was != is && is == rising)
                                          cells[to / 32] ^= 1U << (to % 32);
                                      }});
      }
    }
  }
  EXPECT_EQ(missed, 0);
}

/// Words of which one cannot hold bit 3 high.
struct WornWords {
  static inline const volatile std::uint32_t* worn = nullptr;
  volatile std::uint32_t* words;

  std::uint32_t read(std::size_t i) const { return words[i]; }
  void write(std::size_t i, std::uint32_t value) {
    words[i] = words + i == worn ? value & ~8U : value;
  }
};

// Exactly which blocks are left out; each pass tests all others.
TEST(MemoryScan, GoesOverAllBlocksButThoseInUseAndRestoresThem) {
  constexpr std::size_t kBlocks = 10;
  std::vector<std::uint32_t> memory(kBlocks * kWords + 3);
  std::mt19937 random(1);
  for (std::uint32_t& word : memory) word = static_cast<std::uint32_t>(random()) & ~8U;
  const auto before = memory;
  volatile std::uint32_t* const start = memory.data();
  for (const std::size_t from : {0U, 4U, 5U, 7U, 8U}) {
    for (const std::size_t size : {0U, 1U, 4U, 12U}) {
      const fog::Span<volatile std::uint32_t> in_use{start + from, size};
      for (std::size_t worn = 0; worn < memory.size(); ++worn) {
        WornWords::worn = start + worn;
        fog::MemoryScan<WornWords> scan({start, memory.size()});
        ASSERT_EQ(scan.blocks(), kBlocks);
        const std::size_t block = worn / kWords;
        const bool left_out = block * kWords < from + size && (block + 1) * kWords > from;
        for (std::size_t step = 0; step < fog::kMarchPatterns.size() * kBlocks; ++step) {
          const bool good = step % kBlocks != block || left_out;
          ASSERT_EQ(scan.step(in_use), good) << from << " " << size << " " << worn << " " << step;
        }
        ASSERT_EQ(memory, before);
      }
    }
  }
}

/// Records the first value written over a word: the pattern of the pass.
struct NotedWords {
  static inline std::vector<std::uint32_t> patterns;
  volatile std::uint32_t* words;

  std::uint32_t read(std::size_t i) const { return words[i]; }
  void write(std::size_t i, std::uint32_t value) {
    if (words[i] == kHeld && value != kHeld) patterns.push_back(value);
    words[i] = value;
  }
  static constexpr std::uint32_t kHeld = 0x12345678;
};

TEST(MemoryScan, TakesAnotherPatternEachPass) {
  std::vector<std::uint32_t> memory(3 * kWords, NotedWords::kHeld);
  fog::MemoryScan<NotedWords> scan({memory.data(), memory.size()});
  NotedWords::patterns.clear();
  std::vector<std::uint32_t> expected;
  for (std::size_t pass = 0; pass < 2 * fog::kMarchPatterns.size(); ++pass) {
    for (int block = 0; block < 3; ++block) EXPECT_TRUE(scan.step({memory.data(), 0}));
    expected.insert(expected.end(), memory.size(),
                    fog::kMarchPatterns[pass % fog::kMarchPatterns.size()]);
  }
  EXPECT_EQ(NotedWords::patterns, expected);
}

// ---- record ----

using Word = fog::HealthWord;

fog::HealthRecord some_record() {
  fog::HealthRecord record;
  record.image_intact = true;
  record.model_error = 6;
  record[Word::model] = 0x01020304;
  record[Word::samples] = 1000;
  record[Word::memory_passes] = 11;
  record[Word::status_last] = static_cast<std::uint32_t>(Status::drift_held);
  record[Word::serial] = 0x2D474F46;
  record.reset_cause = {'w', 'a', 't', 'c', 'h', 'd', 'o', 'g'};
  return record;
}

TEST(HealthRecord, ReturnsWhatWasPutInAndRefusesDamage) {
  const fog::HealthRecord sent = some_record();
  const fog::HealthResponse response = fog::encode_health_response(sent);
  fog::HealthRecord got;
  ASSERT_TRUE(fog::decode_health_response(response.data(), got));
  EXPECT_EQ(fog::encode_health_response(got), response);
  EXPECT_TRUE(got.image_intact && !got.memory_good && got.model_error == 6);
  EXPECT_EQ(got.words, sent.words);
  EXPECT_EQ(got.status_last(), Status::drift_held);
  EXPECT_STREQ(got.reset_cause.data(), "watchdog");
  for (std::size_t bit = 0; bit < 8 * response.size(); ++bit) {
    fog::HealthResponse damaged = response;
    damaged[bit / 8] = static_cast<std::uint8_t>(damaged[bit / 8] ^ (1U << (bit % 8)));
    EXPECT_FALSE(fog::decode_health_response(damaged.data(), got)) << bit;
  }
}

// SPEC.md, "Health record", byte by byte.
TEST(HealthRecord, HasTheLayoutOfItsSpecification) {
  const Word order[] = {
      Word::model,         Word::image,         Word::samples,     Word::invalid_rates,
      Word::sequence_gaps, Word::status_last,   Word::status_seen, Word::discarded_bytes,
      Word::image_passes,  Word::memory_passes, Word::stack,       Word::rate_delay,
      Word::sample_period, Word::version,       Word::sources,     Word::processor};
  fog::HealthRecord record;
  std::uint8_t next = 1;
  const auto four = [&next] {
    std::uint32_t word = 0;
    for (unsigned shift = 0; shift < 32; shift += 8) word |= std::uint32_t{next++} << shift;
    return word;
  };
  for (const Word word : order) record[word] = four();
  for (std::size_t i = 16; i < record.words.size(); ++i) record.words[i] = four();
  record[Word::serial] = record.words[18];
  record.words[21] &= 0xFFFFFFU;  // its end
  for (std::size_t i = 0; i < 15; ++i) record.reset_cause[i] = static_cast<char>(next++);
  for (unsigned flags = 0; flags < 256; ++flags) {
    if ((flags & 0x0CU) != 0) continue;
    record.image_intact = flags % 2 != 0;
    record.memory_good = flags / 2 % 2 != 0;
    record.model_error = static_cast<std::uint8_t>(flags / 16);
    const fog::HealthResponse sent = fog::encode_health_response(record);
    ASSERT_EQ(sent.size(), 112U);
    EXPECT_EQ(sent[0], 0xC3);
    EXPECT_EQ(sent[1], 0x99);
    EXPECT_EQ(sent[2], 4);
    EXPECT_EQ(sent[3], flags);
    for (std::size_t i = 4; i < 107; ++i) EXPECT_EQ(sent[i], i == 91 ? 0 : i - 3) << i;
    EXPECT_EQ(sent[107], 0);
    const std::uint32_t crc = fog::crc32(sent.data(), 108);
    for (std::size_t i = 0; i < 4; ++i) EXPECT_EQ(sent[108 + i], (crc >> (8 * i)) & 0xFFU);

    fog::HealthRecord got;
    got.image_intact = !record.image_intact;
    got.memory_good = !record.memory_good;
    ASSERT_TRUE(fog::decode_health_response(sent.data(), got));
    EXPECT_EQ(got.image_intact, record.image_intact);
    EXPECT_EQ(got.memory_good, record.memory_good);
    EXPECT_EQ(got.model_error, record.model_error);
    EXPECT_EQ(fog::encode_health_response(got), sent);
  }
}

TEST(HealthRecord, OfAnEarlierImage_IsRead) {
  fog::HealthRecord record = some_record();
  record[Word::rate_delay] = 465;
  fog::HealthResponse response = fog::encode_health_response(record);
  response[2] = 3;
  const std::uint32_t crc = fog::crc32(response.data(), 108);
  for (std::size_t i = 0; i < 4; ++i) response[108 + i] = static_cast<std::uint8_t>(crc >> (8 * i));
  fog::HealthRecord got;
  ASSERT_TRUE(fog::decode_health_response(response.data(), got));
  EXPECT_EQ(got.words, record.words);
}

// Each with a good CRC: sync, layout, a flag that no board has, a serial number and a reset cause
// without an end.
TEST(HealthRecord, LeavesAloneWhatItRefuses) {
  const fog::HealthResponse response = fog::encode_health_response(some_record());
  for (const auto& [at, bit] : {std::pair<std::size_t, unsigned>{0, 0},
                                {1, 0},
                                {2, 0},
                                {3, 2},
                                {3, 3},
                                {91, 0},
                                {91, 7},
                                {107, 0},
                                {107, 7}}) {
    fog::HealthResponse other = response;
    other[at] = static_cast<std::uint8_t>(other[at] ^ (1U << bit));
    const std::uint32_t crc = fog::crc32(other.data(), 108);
    for (std::size_t i = 0; i < 4; ++i) other[108 + i] = static_cast<std::uint8_t>(crc >> (8 * i));
    fog::HealthRecord untouched;
    EXPECT_FALSE(fog::decode_health_response(other.data(), untouched)) << at;
    EXPECT_EQ(untouched.words, fog::HealthRecord().words);
  }
}

TEST(SampleCounts, CountWhatIsWrongWithSamples) {
  fog::SampleCounts counts;
  fog::OutputSample sample;
  counts.count(sample);
  sample.status = Status::gyro_stuck | Status::sequence_gap;
  counts.count(sample);
  sample.status = Status::drift_held;
  counts.count(sample);
  EXPECT_EQ(counts.samples, 3U);
  EXPECT_EQ(counts.invalid_rates, 1U);
  EXPECT_EQ(counts.sequence_gaps, 1U);
  EXPECT_EQ(counts.status_last, Status::drift_held);
  EXPECT_EQ(counts.status_seen, sample.status | Status::gyro_stuck | Status::sequence_gap);
}

TEST(HealthRequest, HasTheCrcOfItsSpecification) {
  const std::uint16_t crc = fog::crc16(fog::kHealthRequest.data() + 1, 3);
  EXPECT_EQ(fog::kHealthRequest[4], crc & 0xFFU);
  EXPECT_EQ(fog::kHealthRequest[5], crc >> 8U);
}

TEST(HealthRequest, IsFoundBetweenOtherBytesAndNotWithOneWrong) {
  fog::HealthRequestParser parser;
  const auto found = [&](const std::vector<std::uint8_t>& bytes) {
    int times = 0;
    for (const std::uint8_t byte : bytes) times += parser.feed(byte);
    return times;
  };
  const std::vector<std::uint8_t> request(fog::kHealthRequest.begin(), fog::kHealthRequest.end());
  EXPECT_EQ(found(request), 1);
  EXPECT_EQ(found({0xA5, 0xA5, 0x99, 0x00}), 0);
  EXPECT_EQ(found(request), 1);
  for (std::size_t i = 0; i < request.size(); ++i) {
    auto wrong = request;
    wrong[i] ^= 1U;
    EXPECT_EQ(found(wrong), 0) << i;
  }
  EXPECT_EQ(found(request), 1);
}

}  // namespace
