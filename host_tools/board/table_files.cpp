#include "board/table_files.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>

#include "board/delays.hpp"
#include "core/bytes/byte_order.hpp"
#include "core/bytes/crc.hpp"
#include "core/health/image_seal.hpp"
#include "core/pipeline/model_needs.hpp"
#include "core/pipeline/model_slot.hpp"
#include "model/catalogue.hpp"
#include "model/model_file.hpp"
#include "support/input_error.hpp"
#include "support/model_title.hpp"
#include "support/output_file.hpp"
#include "support/text.hpp"

namespace fogcomp::board {
namespace {

constexpr const char* kTableStart = "fog_model[FOG_MODEL_WORDS] = {";

std::string table_lines(const BoardTable& table) {
  std::string text;
  for (std::size_t i = 0; i < table.notes.size(); ++i) {
    const std::size_t end =
        i + 1 < table.notes.size() ? table.notes[i + 1].first_word : table.words.size();
    text += "  /* " + table.notes[i].text + " */\n";
    std::string line = " ";
    for (std::size_t word = table.notes[i].first_word; word < end; ++word) {
      // -2147483648 is not a C literal of type int
      const std::string number = table.words[word] == INT32_MIN ? std::string("(-2147483647 - 1)")
                                                                : std::to_string(table.words[word]);
      if (line.size() + number.size() > 92) {
        text += line + "\n";
        line = " ";
      }
      line += " " + number + ",";
    }
    text += line + "\n";
  }
  return text;
}

void append_word(std::string& bytes, std::uint32_t word) {
  std::array<std::uint8_t, 4> four{};
  fog::store_le32(four.data(), word);
  bytes.append(four.begin(), four.end());
}

// Details of the error "not in image" of `read_model`.
void require_room(const BoardTable& table, const std::string& file) {
  const fog::ModelParameters parameters = read_board_table(table, file);
  const fog::DenoiseParameters& denoise = parameters.denoise;
  if (denoise.levels() > fog::kGenericImage.levels) {
    throw InputError(file, format("the generic image has denoisers of up to %zu levels, not %zu; "
                                  "fit it with fewer, or build an image of its own",
                                  fog::kGenericImage.levels, denoise.levels()));
  }
  if ((fog::kGenericImage.filters & fog::filters_of(denoise.taps())) == 0) {
    throw InputError(file, format("the generic image has filters of %zu taps, as sym8 and db8 are, "
                                  "not of %zu; fit it with --wavelet sym8, or build an image of "
                                  "its own",
                                  fog::kGenericTaps % fog::kOrNone, denoise.taps()));
  }
  if (table.words.size() > fog::kMaxSlotWords) {
    throw InputError(file, format("a table of %zu words, of which a slot holds %zu",
                                  table.words.size(), fog::kMaxSlotWords));
  }
  fog::ModelParameters generic;
  const fog::ModelError error = fog::read_model(table.span(), fog::kGenericImage, generic);
  if (error != fog::ModelError::none) throw InputError(file, fog::describe(error));
}

std::string hex_record(std::uint8_t type, std::uint16_t address, const std::string& data) {
  std::string bytes{static_cast<char>(data.size()), static_cast<char>(address >> 8U),
                    static_cast<char>(address), static_cast<char>(type)};
  bytes += data;
  std::uint8_t sum = 0;
  for (const char byte : bytes)
    sum = static_cast<std::uint8_t>(sum + static_cast<std::uint8_t>(byte));
  bytes += static_cast<char>(0x100U - sum);
  std::string line = ":";
  for (const char byte : bytes) line += format("%02X", static_cast<std::uint8_t>(byte));
  return line + "\n";
}

}  // namespace

std::string header_text(const BoardTable& table, const std::string& model_name,
                        std::uint32_t data_hash) {
  const fog::ModelParameters parameters = read_board_table(table, "export");
  std::string text;
  text += std::string(kHeaderTitle) + FOGCOMP_VERSION " export: do not edit.\n";
  text +=
      format(" * model %s, CRC-32 %08x, fitted to recordings of CRC-32 %08x\n", model_name.c_str(),
             static_cast<unsigned>(parameters.provenance), static_cast<unsigned>(data_hash));
  text += " * Meaning of every word: firmware/SPEC.md, \"Model table\". */\n";
  text += "#ifndef FOG_MODEL_H\n#define FOG_MODEL_H\n\n#include <stdint.h>\n\n";
  text += format("#define FOG_MODEL_LAYOUT %d\n", fog::kModelLayout);
  text += format("#define FOG_MODEL_EFFECTS 0x%xu /* bit = effect id */\n",
                 static_cast<unsigned>(parameters.effects.enabled()));
  text += format("#define FOG_MODEL_EXPRESSIONS 0x%xu /* operations and signals; 0: none */\n",
                 static_cast<unsigned>(parameters.expressions.used));
  text += format("#define FOG_MODEL_NETWORK_INPUTS 0x%xu /* bit = input; 0: no network */\n",
                 static_cast<unsigned>(parameters.network.used()));
  text += format("#define FOG_MODEL_TAPS %zu\n", parameters.denoise.taps());
  text += format("#define FOG_MODEL_LEVELS %zu\n", parameters.denoise.levels());
  text += format("#define FOG_MODEL_OUTPUT %d /* frames: 0 KVH, 1 compact, 2 both */\n",
                 static_cast<int>(parameters.output));
  text += format(
      "#define FOG_MODEL_OUTPUT_OPTIONS 0x%xu /* 4: delta angle, 8: KVH commands, 16: undelayed "
      "*/\n",
      static_cast<unsigned>(parameters.output_options));
  text += "/* " + rate_words(parameters) + " */\n";
  text += format("#define FOG_MODEL_SENSOR_LINE %uu /* bit rate + 2^24 format */\n",
                 parameters.sensor_line().word());
  text += format("#define FOG_MODEL_OUTPUT_LINE %uu\n", parameters.output_line().word());
  const std::int32_t* const bound = &table.words[fog::kProcessorAt];
  text += format("#define FOG_MODEL_BOUND %d /* 1: to one processor */\n",
                 static_cast<int>(fog::is_bound_elsewhere(bound, {})));
  text += format("#define FOG_MODEL_WORDS %zu\n\n", table.words.size());
  text += std::string("static const int32_t ") + kTableStart + "\n" + table_lines(table) + "};\n\n";
  text += "#endif\n";
  return text;
}

namespace {

std::string line_of(const std::string& text, std::size_t at, const std::string& file) {
  const auto end = text.begin() + static_cast<std::ptrdiff_t>(at);
  return file + ":" + std::to_string(1 + std::count(text.begin(), end, '\n'));
}

// Reads the word at `at` and moves `at` behind it.
std::int32_t read_word(const std::string& text, std::size_t& at, const std::string& file) {
  const std::string most_negative = "(-2147483647 - 1)";
  if (text.compare(at, most_negative.size(), most_negative) == 0) {
    at += most_negative.size();
    return INT32_MIN;
  }
  const std::size_t end = text.find_first_of(" \t\r\n,}", at);
  const auto value = parse_number(text.substr(at, end == std::string::npos ? end : end - at));
  if (!value || *value < INT32_MIN || *value > INT32_MAX ||
      *value != static_cast<double>(static_cast<std::int64_t>(*value))) {
    throw InputError(line_of(text, at, file), "not a 32-bit integer; export the header again");
  }
  at = end;
  return static_cast<std::int32_t>(*value);
}

}  // namespace

BoardTable parse_header(const std::string& text, const std::string& file) {
  const std::size_t start = text.find(kTableStart);
  if (start == std::string::npos) {
    throw InputError(file,
                     "is neither a fogcomp model nor an exported header; fogcomp fit and "
                     "fogcomp export make them");
  }
  BoardTable table;
  std::size_t at = start + std::string(kTableStart).size();
  for (;;) {
    at = text.find_first_not_of(" \t\r\n,", at);
    if (at == std::string::npos) throw InputError(file, "ends inside the table; export it again");
    if (text[at] == '}') break;
    if (text.compare(at, 2, "/*") == 0) {
      const std::size_t end = text.find("*/", at);
      if (end == std::string::npos) {
        throw InputError(line_of(text, at, file), "comment without an end; export it again");
      }
      at = end + 2;
      continue;
    }
    table.words.push_back(read_word(text, at, file));
  }
  read_board_table(table, file);
  return table;
}

std::string slot_bytes(const BoardTable& table, std::uint32_t sequence, const std::string& file) {
  require_room(table, file);
  std::string bytes;
  append_word(bytes, static_cast<std::uint32_t>(fog::kSlotMagic));
  append_word(bytes, static_cast<std::uint32_t>(fog::kSlotLayout));
  append_word(bytes, sequence);
  append_word(bytes, static_cast<std::uint32_t>(table.words.size()));
  for (const std::int32_t word : table.words) append_word(bytes, static_cast<std::uint32_t>(word));
  const auto seal = fog::seal_of(fog::crc32(reinterpret_cast<const std::uint8_t*>(bytes.data()),
                                            bytes.size(), fog::kIntactImage));
  return bytes.append(seal.begin(), seal.end());
}

bool looks_like_slot(const std::string& bytes) {
  std::string magic;
  append_word(magic, static_cast<std::uint32_t>(fog::kSlotMagic));
  return bytes.compare(0, magic.size(), magic) == 0;
}

BoardTable parse_slot(const std::string& bytes, const std::string& file) {
  std::vector<std::int32_t> words(bytes.size() / sizeof(std::int32_t));
  std::memcpy(words.data(), bytes.data(), words.size() * sizeof(std::int32_t));
  const fog::SlotContents slot = fog::read_slot({words.data(), words.size()});
  if (slot.error != fog::ModelError::none) {
    throw InputError(
        file, std::string("a table that is ") + fog::describe(slot.error) + "; export it again");
  }
  const std::size_t end = sizeof fog::kSlotMagic + slot.sealed.size;
  if (end != bytes.size()) {
    throw InputError(file,
                     format("has %zu bytes after the table; export it again", bytes.size() - end));
  }
  BoardTable table;
  table.words.assign(slot.table.begin(), slot.table.end());
  read_board_table(table, file);
  return table;
}

std::string slot_hex(const std::string& bytes, unsigned slot) {
  constexpr std::array<std::uint32_t, fog::kModelSlots> kAddresses{0x0800C000, 0x08010000};
  const std::uint32_t address = kAddresses.at(slot);
  const std::string upper{static_cast<char>(address >> 24U), static_cast<char>(address >> 16U)};
  std::string text = hex_record(4, 0, upper);
  constexpr std::size_t kLine = 16;
  for (std::size_t at = 0; at < bytes.size(); at += kLine) {
    text += hex_record(0, static_cast<std::uint16_t>(address + at), bytes.substr(at, kLine));
  }
  return text + hex_record(1, 0, "");
}

BoardSource::BoardSource(const std::string& path) : path_(path) {
  const std::string text = read_file(path);
  is_model_ = model::looks_like_model(text);
  if (is_model_) {
    model_ = model::parse_model(text, path);
  } else if (looks_like_slot(text)) {
    table_ = parse_slot(text, path);
  } else {
    table_ = parse_header(text, path);
  }
}

double BoardSource::scale_factor() const {
  if (is_model_) return model_.scale_factor;
  const fog::CalibrationParameters calibration = read_board_table(table_, path_).calibration;
  return 3600 * 1024 / std::ldexp(calibration.multiplier, -calibration.shift);
}

fog::InputMask BoardSource::needs() const {
  return is_model_ ? model::needs_of(model_) : fog::needs_of(read_board_table(table_, path_));
}

const BoardTable& BoardSource::table(const BoardSettings& settings) {
  if (is_model_) table_ = make_board_table(model_, settings);
  return table_;
}

}  // namespace fogcomp::board
