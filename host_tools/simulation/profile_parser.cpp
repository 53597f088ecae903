#include "simulation/programme.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <vector>

#include "simulation/profile_line.hpp"
#include "support/input_error.hpp"
#include "support/random.hpp"
#include "support/text.hpp"

namespace fogcomp::simulation {
namespace {

constexpr double kLongestProgramme_s = 10000.0 * 3600.0;
// Limit of statements times passes of nested repeats: above any test, and still fast to read.
constexpr int kMaxStatements = 1000000;
constexpr int kMaxNesting = 20;
constexpr double kFastestSweep_s = 10;

class ProfileParser {
 public:
  ProfileParser(const std::string& text, const std::string& name, std::uint64_t seed)
      : name_(name), random_(seed, "random_steps") {
    std::size_t number = 0;
    for (const std::string& line : split(text, '\n')) {
      ProfileLine words(name, ++number, line);
      if (!words.at_end()) lines_.push_back(words);
    }
  }

  Programme parse() {
    run_block(0, lines_.size(), 0);
    if (programme_.legs.empty()) {
      throw InputError(name_, "the programme takes no time; add a soak or a ramp");
    }
    return programme_;
  }

 private:
  void count(const ProfileLine& line) {
    if (++statements_run_ <= kMaxStatements) return;
    line.fail("the programme has more than a million statements; repeat less often");
  }

  // Executes statements [first, last), with repeated blocks.
  void run_block(std::size_t first, std::size_t last, int nesting) {
    for (std::size_t i = first; i < last; ++i) {
      ProfileLine line = lines_[i];
      count(line);
      const std::string keyword = line.word("a statement");
      if (keyword == "end") line.fail("'end' without a 'repeat' above it");
      if (keyword == "repeat") {
        const int times = line.whole_number(1, 100000);
        line.expect_end();
        if (nesting == kMaxNesting) {
          line.fail(format("'repeat' within %d others; nest fewer", kMaxNesting));
        }
        const std::size_t end = matching_end(i, last);
        for (int pass = 0; pass < times; ++pass) {
          count(line);
          run_block(i + 1, end, nesting + 1);
        }
        i = end;
      } else {
        statement(keyword, line);
        line.expect_end();
      }
      started_ = true;
    }
  }

  std::size_t matching_end(std::size_t repeat, std::size_t last) const {
    int depth = 0;
    for (std::size_t i = repeat; i < last; ++i) {
      ProfileLine line = lines_[i];
      const std::string keyword = line.word("a statement");
      if (keyword == "repeat") ++depth;
      if (keyword == "end" && --depth == 0) return i;
    }
    lines_[repeat].fail("'repeat' without an 'end' below it");
  }

  void statement(const std::string& keyword, ProfileLine& line) {
    static const std::map<std::string, void (ProfileParser::*)(ProfileLine&)> statements{
        {"start", &ProfileParser::start},         {"segment", &ProfileParser::segment},
        {"soak", &ProfileParser::soak},           {"ramp", &ProfileParser::ramp},
        {"step", &ProfileParser::step},           {"random_steps", &ProfileParser::random_steps},
        {"power", &ProfileParser::power},         {"heater", &ProfileParser::heater},
        {"axis", &ProfileParser::axis},           {"rate", &ProfileParser::rate},
        {"vibration", &ProfileParser::vibration}, {"field", &ProfileParser::field},
        {"azimuth", &ProfileParser::azimuth},     {"sweep", &ProfileParser::sweep},
    };
    const auto found = statements.find(keyword);
    if (found == statements.end()) {
      std::vector<std::string> names{"repeat", "end"};
      for (const auto& known : statements) names.push_back(known.first);
      line.fail("unknown statement '" + keyword + "'" + did_you_mean(keyword, names) +
                "; fogcomp simulate --list shows the statements");
    }
    (this->*found->second)(line);
  }

  void start(ProfileLine& line) {
    if (started_) line.fail("'start' must be the first statement");
    set_point_degc_ = line.quantity(Dimension::temperature);
    programme_.start_degc = set_point_degc_;
  }

  void segment(ProfileLine& line) { segment_ = line.word("the segment's name"); }

  void soak(ProfileLine& line) {
    add_leg(line, line.quantity(Dimension::duration), set_point_degc_);
  }

  void ramp(ProfileLine& line) {
    line.expect_word("to");
    const double target_degc = line.quantity(Dimension::temperature);
    line.expect_word("at");
    move_to(line, target_degc, line.quantity(Dimension::temperature_rate));
  }

  void step(ProfileLine& line) {
    line.expect_word("to");
    set_point_degc_ = line.quantity(Dimension::temperature);
  }

  void random_steps(ProfileLine& line) {
    const double low_degc = line.quantity(Dimension::temperature);
    line.expect_word("to");
    const double high_degc = line.quantity(Dimension::temperature);
    if (high_degc <= low_degc) line.fail("the second temperature must be above the first");
    line.expect_word("at");
    const double rate_kps = line.quantity(Dimension::temperature_rate);
    line.expect_word("every");
    const double every_s = line.quantity(Dimension::duration);
    line.expect_word("for");
    const double all_s = line.quantity(Dimension::duration);
    for (double spent_s = 0; spent_s < all_s;) {
      const double target_degc = low_degc + (high_degc - low_degc) * random_.uniform();
      const double move_s = std::abs(target_degc - set_point_degc_) / rate_kps;
      move_to(line, target_degc, rate_kps);
      if (every_s > move_s) add_leg(line, every_s - move_s, target_degc);
      spent_s += std::max(every_s, move_s);
    }
  }

  void power(ProfileLine& line) {
    conditions_.powered = line.choice({"off", "on"}) == 1;
    programme_.switches_power = programme_.switches_power || !conditions_.powered;
  }
  void heater(ProfileLine& line) { conditions_.heater_w = line.quantity(Dimension::power); }
  void axis(ProfileLine& line) {
    conditions_.axis =
        static_cast<Axis>(line.choice({"up", "down", "north", "south", "east", "west"}));
    programme_.sets_axis = true;
  }
  void rate(ProfileLine& line) {
    conditions_.table_rate_dph = line.quantity(Dimension::rate);
    conditions_.sweep_dph = 0;
    programme_.sets_rate = true;
  }
  void sweep(ProfileLine& line) {
    conditions_.table_rate_dph = 0;
    conditions_.sweep_dph = line.quantity(Dimension::rate);
    line.expect_word("every");
    conditions_.sweep_period_s = line.quantity(Dimension::duration);
    conditions_.sweep_from_s = programme_.duration_s();
    if (conditions_.sweep_period_s < kFastestSweep_s) {
      line.fail(
          format("a sweep takes %g s or more: the simulator's steps are 1 s", kFastestSweep_s));
    }
    programme_.sets_rate = true;
  }
  void vibration(ProfileLine& line) {
    conditions_.vibration_grms = line.quantity(Dimension::acceleration);
  }
  void field(ProfileLine& line) { conditions_.field_ut = line.quantity(Dimension::field); }
  void azimuth(ProfileLine& line) { conditions_.azimuth_deg = line.quantity(Dimension::angle); }

  void move_to(ProfileLine& line, double target_degc, double rate_kps) {
    const double duration_s = std::abs(target_degc - set_point_degc_) / rate_kps;
    if (duration_s > 0) add_leg(line, duration_s, target_degc);
  }

  void add_leg(ProfileLine& line, double duration_s, double target_degc) {
    const double start_s = programme_.duration_s();
    if (start_s + duration_s > kLongestProgramme_s) {
      line.fail("the programme gets longer than 10000 h; make it shorter");
    }
    if (programme_.legs.empty() && !conditions_.powered) {
      line.fail("the programme must begin with the power on: time counts from there");
    }
    programme_.legs.push_back(
        {start_s, start_s + duration_s, set_point_degc_, target_degc, conditions_, segment_});
    set_point_degc_ = target_degc;
  }

  std::string name_;
  std::vector<ProfileLine> lines_;
  Random random_;
  Programme programme_;
  Conditions conditions_;
  double set_point_degc_ = 20;
  std::string segment_;
  bool started_ = false;
  int statements_run_ = 0;
};

}  // namespace

double table_rate_dph(const Conditions& conditions, double time_s) {
  if (conditions.sweep_dph == 0) return conditions.table_rate_dph;
  const double turns = (time_s - conditions.sweep_from_s) / conditions.sweep_period_s;
  return conditions.table_rate_dph + conditions.sweep_dph * std::sin(2 * M_PI * turns);
}

Programme parse_profile(const std::string& text, const std::string& name, std::uint64_t seed) {
  return ProfileParser(text, name, seed).parse();
}

}  // namespace fogcomp::simulation
