#include "reference_data/strd_sets.hpp"

#include <cmath>
#include <fstream>
#include <sstream>
#include <stdexcept>

namespace fog::test {
namespace {

// y = exp(-b1 x) / (b2 + b3 x)
Values chwirut_posed(Values b) {
  b["ratio"] = b["b3"] / b["b2"];
  return b;
}
Values chwirut_strd(Values b) {
  b["b2"] = 1 / b["factor"];
  b["b3"] = b["ratio"] / b["factor"];
  return b;
}
const std::vector<PosedTerm> kChwirut{{"factor", "exp(-{b1}*T)/(1+{ratio}*T)"}};

// A quotient of polynomials: the numerator's coefficients, each divided by the first.
Values quotient_posed(Values b) {
  for (const char* k : {"2", "3", "4"}) {
    b[std::string("r") + k] = b[std::string("b") + k] / b["b1"];
  }
  return b;
}
template <int kSize>
Values quotient_strd(Values b) {
  for (int k = 2; k <= kSize; ++k) {
    b["b" + std::to_string(k)] = b["r" + std::to_string(k)] * b["b1"];
  }
  return b;
}
const std::vector<PosedTerm> kCubicByCubic{
    {"b1", "(1+{r2}*T+{r3}*T^2+{r4}*T^3)/(1+{b5}*T+{b6}*T^2+{b7}*T^3)"}};

Values eckerle_strd(Values b) {
  b["b1"] = b["factor"] * b["b2"];
  return b;
}

// Cosine and sine of a period as an amplitude and a phase.
Values enso_posed(Values b) {
  b["phase4"] = std::atan2(b["b6"], b["b5"]);
  b["phase7"] = std::atan2(b["b9"], b["b8"]);
  return b;
}
Values enso_strd(Values b) {
  b["b5"] = b["amplitude4"] * std::cos(b["phase4"]);
  b["b6"] = b["amplitude4"] * std::sin(b["phase4"]);
  b["b8"] = b["amplitude7"] * std::cos(b["phase7"]);
  b["b9"] = b["amplitude7"] * std::sin(b["phase7"]);
  return b;
}

const std::vector<PosedTerm> kLanczos{
    {"b1", "exp(-{b2}*T)"}, {"b3", "exp(-{b4}*T)"}, {"b5", "exp(-{b6}*T)"}};
const std::vector<PosedTerm> kGauss{
    {"b1", "exp(-{b2}*T)"}, {"b3", "exp(-(T-{b4})^2/{b5}^2)"}, {"b6", "exp(-(T-{b7})^2/{b8}^2)"}};
const std::vector<PosedTerm> kEnso{{"b1", ""},
                                   {"b2", "cos(6.283185307179586*T/12)"},
                                   {"b3", "sin(6.283185307179586*T/12)"},
                                   {"amplitude4", "cos(6.283185307179586*T/{b4}-{phase4})"},
                                   {"amplitude7", "cos(6.283185307179586*T/{b7}-{phase7})"}};

}  // namespace

const std::vector<PosedModel>& posed_models() {
  static const std::vector<PosedModel> models{
      {"Misra1a", {{"b1", "1-exp(-{b2}*T)"}}},
      {"Misra1b", {{"b1", "1-(1+{b2}*T/2)^(-2)"}}},
      {"Misra1c", {{"b1", "1-(1+2*{b2}*T)^(-0.5)"}}},
      {"Misra1d", {{"b1", "{b2}*T/(1+{b2}*T)"}}},
      {"Chwirut1", kChwirut, chwirut_posed, chwirut_strd},
      {"Chwirut2", kChwirut, chwirut_posed, chwirut_strd},
      {"Lanczos1", kLanczos},
      {"Lanczos2", kLanczos},
      {"Lanczos3", kLanczos},
      {"Gauss1", kGauss},
      {"Gauss2", kGauss},
      {"Gauss3", kGauss},
      {"DanWood", {{"b1", "T^{b2}"}}},
      {"Kirby2",
       {{"b1", "(1+{r2}*T+{r3}*T^2)/(1+{b4}*T+{b5}*T^2)"}},
       quotient_posed,
       quotient_strd<3>},
      {"Hahn1", kCubicByCubic, quotient_posed, quotient_strd<4>},
      {"Thurber", kCubicByCubic, quotient_posed, quotient_strd<4>},
      {"Nelson", {{"b1", ""}, {"b2", "-T*exp(-{b3}*V)"}}, nullptr, nullptr, true},
      {"MGH17", {{"b1", ""}, {"b2", "exp(-T*{b4})"}, {"b3", "exp(-T*{b5})"}}},
      {"MGH09", {{"b1", "(T^2+T*{b2})/(T^2+T*{b3}+{b4})"}}},
      {"MGH10", {{"b1", "exp({b2}/(T+{b3}))"}}},
      {"ENSO", kEnso, enso_posed, enso_strd},
      {"Rat42", {{"b1", "1/(1+exp({b2}-{b3}*T))"}}},
      {"Rat43", {{"b1", "(1+exp({b2}-{b3}*T))^(-1/{b4})"}}},
      {"Eckerle4", {{"factor", "exp(-0.5*((T-{b3})/{b2})^2)"}}, nullptr, eckerle_strd},
      {"Bennett5", {{"b1", "({b2}+T)^(-1/{b3})"}}},
      {"BoxBOD", {{"b1", "1-exp(-{b2}*T)"}}},
  };
  return models;
}

StrdSet read_strd_set(const std::string& name) {
  std::ifstream file(std::string(FOG_SOURCE_DIR) + "/tests/reference_data/strd/" + name + ".dat");
  StrdSet set;
  bool in_data = false;
  for (std::string line; std::getline(file, line);) {
    std::istringstream words(line);
    std::string word;
    if (in_data) {
      std::vector<double> row;
      for (double value = 0; words >> value;) row.push_back(value);
      if (!row.empty()) set.rows.push_back(row);
      continue;
    }
    words >> word;
    if (word == "Data:") {
      in_data = words >> word && word == "y";  // else the description of the data
    } else if (word == "Residual" && line.find("Sum of Squares:") != std::string::npos) {
      set.residual_squares = std::stod(line.substr(line.find(':') + 1));
    } else if (word.size() == 2 && word[0] == 'b') {
      char equals = 0;
      words >> equals >> set.starts[0][word] >> set.starts[1][word] >> set.certified[word] >>
          set.sigma[word];
    }
  }
  if (set.rows.empty() || set.certified.empty()) throw std::runtime_error("no StRD set " + name);
  return set;
}

}  // namespace fog::test
