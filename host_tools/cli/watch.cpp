#include "cli/watch.hpp"

#include <cstdio>

namespace fogcomp::cli {

void print_note(const std::string& note) {
  std::fprintf(stderr, "note: %s\n", note.c_str());
}

workflow::Observer Watch::observer() {
  return {[this](const std::string& note) {
            bar_.reset();
            print_note(note);
          },
          [this](const std::string& stage, double done) { return update(stage, done); }};
}

bool Watch::update(const std::string& stage, double done) {
  if (stage != stage_ || !bar_) {
    stage_ = stage;
    bar_.emplace(stage);
    guard_.reset();
    if (stage == workflow::kTraining && on_interrupt_ == OnInterrupt::keep_best) guard_.emplace();
  }
  bar_->update(done);
  return !guard_ || !guard_->interrupted();
}

}  // namespace fogcomp::cli
