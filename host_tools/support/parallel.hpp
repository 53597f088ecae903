#pragma once

#include <cstddef>
#include <functional>

namespace fogcomp {

/// Calls body(0) ... body(count - 1), each once, on the processor's cores in any order, and returns
/// when all have returned. What the bodies write must be apart; then the result is the same
/// whatever the number of threads. A call from within a body shares the threads of the outer one.
/// If bodies throw, the exception of the smallest index is thrown again.
void for_each_index(std::size_t count, const std::function<void(std::size_t)>& body);

/// The same. After each body, `progress` (may be empty) is called with the fraction of the bodies
/// that have returned, above 0 to 1: one call at a time, by the body's thread. It may throw as a
/// body may.
void for_each_index(std::size_t count, const std::function<void(std::size_t)>& body,
                    const std::function<void(double)>& progress);

/// Largest number of threads of later calls, at least 1; the number of cores if never called. For a
/// process that shares the cores with others of its kind.
void set_max_threads(std::size_t threads);

}  // namespace fogcomp
