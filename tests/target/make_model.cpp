// make_model OUT.model INPUTS [EFFECT|NAME=EXPRESSION...]: a model of these effects at their
// typical size, without any of all that a board can have, and of a network with so many inputs (0:
// no network) and 10 neurons. For the images of the target tests and of tests/bench.
// make_model OUT.h lenient HEADER: a header without flags that make a rate not valid by choice.
#include <cstdio>
#include <exception>
#include <stdexcept>
#include <string>
#include <vector>

#include "board/table_files.hpp"
#include "model/model_file.hpp"
#include "support/output_file.hpp"
#include "support/typical_effects.hpp"

namespace {

// The inputs of a network: so many of these.
const std::vector<fogcomp::model::RealInput> kInputs{
    {fog::NetworkInput::temperature, 10, 51, 0},
    {fog::NetworkInput::temperature_rate, 0, 0.6, 0},
    {fog::NetworkInput::lagged_temperature, 10, 50, 600},
    {fog::NetworkInput::input_rate, 8.5, 10, 0}};

fogcomp::model::EffectTerm typical_term(const std::string& name) {
  for (const fogcomp::model::EffectTerm& term : fog::test::typical_terms()) {
    if (term.name == name) return term;
  }
  if (name.find('=') != std::string::npos) return fog::test::written_term(name);
  throw std::invalid_argument("no effect '" + name + "' that a board can have");
}

void run(const std::string& output, int inputs, const std::vector<std::string>& effects) {
  fogcomp::model::Model model = fog::test::all_effects_model();
  model.network = {};
  if (inputs > 0) {
    model.network = fog::test::network_of({kInputs.begin(), kInputs.begin() + inputs});
  }
  if (!effects.empty()) {
    if (effects[0] != "all") model.terms.clear();
    for (const std::string& effect : effects) {
      if (effect != "all") model.terms.push_back(typical_term(effect));
    }
  }
  fogcomp::model::save_model(model, output);
}

// The same board, whose rate is valid wherever a model may choose. The flags stand before the CRC.
void write_lenient(const std::string& header, const std::string& output) {
  fogcomp::board::BoardTable table =
      fogcomp::board::parse_header(fogcomp::read_file(header), header);
  constexpr std::size_t kFromFlagsOn = 4;  // flags, the two lines, the checksum
  table.words[table.words.size() - kFromFlagsOn] = static_cast<std::int32_t>(fog::kRateInvalid);
  table.words.back() = static_cast<std::int32_t>(fog::model_table_crc(table.span()));
  table.notes = {{0, "as " + header + ", with no flags but the usual"}};
  fogcomp::write_file(output, fogcomp::board::header_text(table, "lenient", 0));
}

}  // namespace

int main(int argc, char** argv) {
  if (argc < 3) {
    std::fputs("usage: make_model OUT.model INPUTS [EFFECT...] | OUT.h lenient HEADER\n", stderr);
    return 2;
  }
  try {
    if (argc == 4 && std::string(argv[2]) == "lenient") {
      write_lenient(argv[3], argv[1]);
    } else {
      run(argv[1], std::stoi(argv[2]), {argv + 3, argv + argc});
    }
    return 0;
  } catch (const std::exception& error) {
    std::fprintf(stderr, "make_model: %s\n", error.what());
    return 1;
  }
}
