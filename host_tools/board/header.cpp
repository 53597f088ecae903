#include "board/header.hpp"

#include <algorithm>
#include <cstdlib>

#include "board/rate_response.hpp"
#include "support/input_error.hpp"
#include "support/model_title.hpp"
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

}  // namespace fogcomp::board
