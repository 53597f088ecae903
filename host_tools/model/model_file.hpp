#pragma once

#include <string>

#include "model/model.hpp"

namespace fogcomp::model {

/// Largest value in a model file, deg/h: above any drift, and small enough for finite sums and
/// products. Recordings contain rates up to 1e9 deg/h; coefficients of terms that nearly cancel are
/// larger.
constexpr double kMaxModelDph = 1e15;

/// A model as text, a fact per line, doubles in the shortest form that reads back to the same bits,
/// a CRC-32 of everything before it at the end (host_tools/REFERENCE.md, "Model file").
std::string model_text(const Model& model);

/// Parses model_text(). `file` is its name for errors: InputError for a file that is not a model,
/// has another version, or is damaged.
Model parse_model(const std::string& text, const std::string& file);

/// Whether a text begins like a model file.
bool looks_like_model(const std::string& text);

void save_model(const Model& model, const std::string& path);
Model load_model(const std::string& path);

}  // namespace fogcomp::model
