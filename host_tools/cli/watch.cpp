#include "cli/watch.hpp"

#include <cstdio>

namespace fogcomp::cli {

workflow::Observer on_stderr() {
  workflow::Observer observer;
  observer.note = [](const std::string& note) { std::fprintf(stderr, "note: %s\n", note.c_str()); };
  observer.remark = [](const std::string& remark) { std::fprintf(stderr, "%s\n", remark.c_str()); };
  return observer;
}

workflow::Observer Watch::observer() {
  const auto below_the_bar = [this](const std::function<void(const std::string&)>& print) {
    return [this, print](const std::string& line) {
      bar_.reset();
      print(line);
    };
  };
  const workflow::Observer plain = on_stderr();
  return {below_the_bar(plain.note), below_the_bar(plain.remark),
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
