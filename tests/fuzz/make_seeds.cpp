// make_seeds DIR: initial inputs of the fuzzers, DIR/TARGET/NAME: small valid inputs of every kind.
#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <random>
#include <string>

#include "board/table_files.hpp"
#include "core/bytes/byte_order.hpp"
#include "core/frames/extension_frame.hpp"
#include "core/frames/health_record.hpp"
#include "core/frames/health_request.hpp"
#include "core/frames/sensor_frame.hpp"
#include "core/pipeline/slot_loader.hpp"
#include "model/model_file.hpp"
#include "support/output_file.hpp"
#include "support/typical_effects.hpp"

namespace {

class Seeds {
 public:
  explicit Seeds(std::filesystem::path folder) : folder_(std::move(folder)) {}

  void add(const std::string& target, const std::string& name, const std::string& bytes) const {
    std::filesystem::create_directories(folder_ / target);
    fogcomp::write_file((folder_ / target / name).string(), bytes);
  }

 private:
  std::filesystem::path folder_;
};

template <class Bytes>
void append(std::string& text, const Bytes& bytes) {
  text.append(bytes.begin(), bytes.end());
}

void append32(std::string& text, std::uint32_t word) {
  std::array<std::uint8_t, 4> bytes;
  fog::store_le32(bytes.data(), word);
  append(text, bytes);
}

std::string stream() {
  std::string bytes;
  for (std::uint16_t i = 0; i < 6; ++i) {
    if (i % 2 == 0) {
      append(bytes, fog::encode_extension_frame(
                        {static_cast<fog::Input>(i / 2), fog::ExtensionValue::from_raw(i << 20)}));
    }
    append(bytes, fog::encode_sensor_frame({i, 1000 * i, (20 + i) << 16, i != 3, i != 4}));
  }
  return bytes;
}

// As model_table takes it: the table, then samples over the whole range of counts and temperature.
std::string table_and_samples(const fogcomp::board::BoardTable& table) {
  std::string bytes{static_cast<char>(table.words.size() & 0xFFU),
                    static_cast<char>(table.words.size() >> 8U)};
  for (const std::int32_t word : table.words) append32(bytes, static_cast<std::uint32_t>(word));
  std::mt19937 random(1);
  for (int i = 0; i < 12; ++i) {
    append32(bytes, static_cast<std::uint32_t>(i % 3 == 0 ? random() : random() % 4001U));
    append32(bytes, static_cast<std::uint32_t>(-60 + 15 * i) << 16U);
    bytes += static_cast<char>(i % 5 == 4 ? random() % 16 : 0);
  }
  return bytes;
}

// A header's table alone, as short as the reader takes it.
std::string bare_header(const fogcomp::board::BoardTable& table) {
  std::string text = "fog_model[FOG_MODEL_WORDS] = {";
  for (const std::int32_t word : table.words) text += std::to_string(word) + ",";
  return text + "}";
}

// What load_port.cpp makes the messages of that load a table.
std::string load_steps(const fogcomp::board::BoardTable& table) {
  const std::string slot = fogcomp::board::slot_bytes(table, 2, "seed");
  std::string bytes;
  const auto append_step = [&](fog::LoadStep step, std::size_t at, std::size_t words) {
    bytes += static_cast<char>(step);
    bytes += static_cast<char>(words);
    bytes.append(2, '\0');
    append32(bytes, static_cast<std::uint32_t>(step == fog::LoadStep::block ? at : 0));
    bytes += slot.substr(4 * at, 4 * words);
  };
  append_step(fog::LoadStep::begin, 0, fog::kLoadHeadWords);
  const std::size_t words = slot.size() / 4;
  for (std::size_t at = fog::kLoadHeadWords; at < words; at += fog::kMaxLoadWords) {
    append_step(fog::LoadStep::block, at, std::min(fog::kMaxLoadWords, words - at));
  }
  append_step(fog::LoadStep::end, 0, 0);
  return bytes;
}

void add_models(const Seeds& seeds) {
  fogcomp::model::Model rough = fog::test::paper_like_model();
  rough.denoise.wavelet = "db2";
  rough.denoise.levels = 3;
  const std::pair<const char*, fogcomp::model::Model> models[] = {
      {"paper", fog::test::paper_like_model()},
      {"all_effects", fog::test::all_effects_model()},
      {"expressions", fog::test::expressions_model()},
      {"rough", rough}};
  for (const auto& [name, model] : models) {
    const fogcomp::board::BoardTable table =
        fogcomp::board::make_board_table(model, {20, fog::OutputSelection::both, true});
    seeds.add("model_file", name, fogcomp::model::model_text(model));
    seeds.add("weights_header", name, fogcomp::board::header_text(table, name, 1));
    seeds.add("weights_header", std::string("bare_") + name, bare_header(table));
    seeds.add("model_table", name, table_and_samples(table));
  }
}

}  // namespace

int main(int count, char** arguments) {
  if (count != 2) {
    std::fprintf(stderr, "usage: make_seeds DIR\n");
    return 2;
  }
  const Seeds seeds(arguments[1]);
  seeds.add("sensor_stream", "frames", stream());
  std::string request;
  append(request, fog::kHealthRequest);
  std::string answer;
  append(answer, fog::encode_health_response({}));
  seeds.add("command_port", "request", request + request.substr(0, 3) + request);
  seeds.add("command_port", "answer", answer);
  seeds.add("load_port", "table",
            load_steps(fogcomp::board::make_board_table(fog::test::paper_like_model(), {})));
  seeds.add("recording", "frames", '\0' + stream());
  seeds.add("recording", "text",
            std::string(1, '\0') +
                "# made\ntime_s,temperature_degc,rate_dph,segment,magnetic_ut\n"
                "0,20.5,0.71,soak,50\n10,20.6,0.72,soak,50\n20,-4e1,0.73,ramp,49\n");
  seeds.add("recording", "counts",
            "\3time_s;counts;temperature_degc\r\n0;12;20,5\r\n10;13;20,6\r\n");
  seeds.add("recording", "laboratory",
            std::string(1, '\0') +
                "Device: FOG-7\nTime;Coil temp;Gyro_X\nms;K;deg/s\n0,5;293,15;0,001\n"
                "10,5;;0,002\n20,5;293,25;NaN\n");
  seeds.add(
      "recording", "calendar",
      std::string(1, '\0') +
          "\"DateTime\" \"T [degF]\" \"w(rad/s)\"\n"
          "\"2024-02-29T23:59:59.5Z\" 68.5 1e-6\n\"2024-03-01T00:00:00,5+00:00\" 68.6 2e-6\n");
  seeds.add("recording", "unix",
            std::string(1, '\0') +
                "% made\ntimestamp\ttemp\trate_dph\n1709625600123\t20.1\t0.7\n"
                "1709625600223\t20.2\t0.8\n");
  seeds.add("expression", "written", "stress = lag(dTdt^2, ?tau[60,3000])*sin(t/9)-min(T, 3)");
  seeds.add("programme", "programme",
            "start 20 degC\nsegment a\nrepeat 2\nramp to -40 degC at 0.5 degC/min\nsoak 2h\nend\n"
            "random_steps 10 degC to 30 degC at 3 degC/min every 15 min for 1 h\naxis up\n");
  add_models(seeds);
  return 0;
}
