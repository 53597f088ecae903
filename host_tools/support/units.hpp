#pragma once

namespace fogcomp {

constexpr double kSecondsPerMinute = 60;
constexpr double kSecondsPerHour = 3600;
constexpr double kDphPerDegreePerSecond = 3600;  // deg/h in one deg/s
constexpr double kPi = 3.14159265358979323846;

}  // namespace fogcomp
