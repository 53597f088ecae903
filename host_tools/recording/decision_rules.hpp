#pragma once

#include <cstddef>

/// Every number by which a recording is read and cut: its unit, where it comes from, and what looks
/// at the decision (a test of tests/unit/recording). The board's own limits are the core's and
/// board_limits.hpp.
namespace fogcomp::recording::rules {

// ---- Gaps and segments ------------------------------------------------------------------------
/// Lengths of a row (or sample) between two beyond which something is missing: a row that is lost
/// makes 2. csv_reader_test, segments_test.
constexpr double kMaxSpacing = 1.5;

/// Seconds: shorter gaps do not end a segment, across longer ones than the second the chamber may
/// have done anything. Chosen: a coil follows in minutes. segments_test.
constexpr double kMaxDropoutS = 1;
constexpr double kMaxKnownGapS = 60;

/// What is a ramp: so fast, degC/min (an hour for 3 degC), and so far, degC, or so many tolerances.
/// Ramps of 0.1 to 10 degC/min are found alike. segments_test.
constexpr double kMinRampDegcPerMin = 0.05;
constexpr double kMinRampDegc = 2;
constexpr double kMinRampTolerances = 4;
/// Seconds; what is shorter is a corner. Chosen. segments_test.
constexpr double kMinSoakS = 120;
/// How far a temperature may leave a straight line, degC: at least this, so many standard
/// deviations of its noise, so many steps of its sensor. segments_test.
constexpr double kMinToleranceDegc = 0.3;
constexpr double kToleranceSigmas = 5;
constexpr double kToleranceSteps = 1.25;

// ---- Rows that the board would refuse ---------------------------------------------------------
/// Seconds: an excursion that lasts longer may be a soak of a recording that was joined from
/// several. row_judge_test.
constexpr double kMaxExcursionS = 600;
/// Seconds between samples: between longer ones a live sensor may well repeat itself.
/// row_judge_test.
constexpr double kMaxFrozenSampleS = 1;

// ---- What kind of file is it? -----------------------------------------------------------------
/// One in so many characters is a control character: no text. stream_reader_test.
constexpr std::ptrdiff_t kControlOneIn = 50;
/// Blocks of 1 MiB without a frame: what comes then is no sensor's. stream_reader_test.
constexpr std::size_t kMaxBlocksWithoutFrame = 64;
/// UTF-16 is told by its first characters, of which a sensor stream has few that are Latin: so many
/// are looked at, so many are needed, and so large a part has to be Latin. foreign_files_test.
constexpr std::size_t kUtf16UnitsLookedAt = 512;
constexpr std::size_t kMinUtf16Units = 8;
constexpr double kMinLatinShare = 0.9;
/// Seconds between rows: beyond, time_s has another unit. csv_reader_test.
constexpr double kMinPeriodS = 1e-6;
constexpr double kMaxPeriodS = 86400;

/// Lines before the header (what a logger says of itself), and rows by which separator and decimal
/// mark are told: more than any logger writes, and more than begin with whole numbers by chance.
/// foreign_files_test.
constexpr std::size_t kMaxLinesBeforeHeader = 200;
constexpr std::size_t kMaxRowsLookedAt = 2000;
/// Columns whose names are looked at closely: ten times the widest log of an autopilot.
constexpr std::size_t kMaxColumnsUnderstood = 1000;
/// Seconds: no gyro has been powered for 31 years, so such a time counts from 1970.
/// foreign_files_test.
constexpr double kMinUnixTimeS = 1e9;
/// Seconds: readings of a slow column that lie further apart are not joined by a line, as a board
/// holds a temperature no longer (board_limits.hpp, kHoldSeconds). foreign_files_test.
constexpr double kMaxBridgeS = 60;

// ---- Recordings longer than memory should hold ------------------------------------------------
/// Rows that are judged together: hours at 200 Hz, longer than any excursion (kMaxExcursionS).
/// long_recording_test.
constexpr std::size_t kPartRows = std::size_t{1} << 20U;
/// Means that are kept: 100 MB in three columns. long_recording_test.
constexpr std::size_t kMaxMeanRows = std::size_t{1} << 22U;

// ---- Figures that nothing has: another unit? --------------------------------------------------
/// deg/sqrt(h). Shot noise of 100 uW at 1550 nm, sqrt(2 h nu / P) = 5e-8 rad/sqrt(Hz), over the
/// Sagnac phase of 5 km on a diameter of 0.2 m, 2 pi L D / (lambda c) = 13 s, is 1.3e-5: more light
/// and fibre than gyros have. The maximum: 1 deg/s in a mean of 1 s, a hundred times a cheap MEMS
/// gyro's. plausibility_test.
constexpr double kMinAngleRandomWalkDprh = 1e-5;
constexpr double kMaxAngleRandomWalkDprh = 60;
/// Hours: a year without a pause. plausibility_test.
constexpr double kMaxRunHours = 8766;
/// degC/min over a minute: chambers for thermal stress do 15 to 25 with the air, and a coil follows
/// in minutes. plausibility_test.
constexpr double kMaxCoilDegcPerMin = 30;
constexpr double kFastWindowS = 60;
/// degC/min over an hour: a room does more between day and night (3 degC in 12 h, 0.25 degC/h).
/// plausibility_test.
constexpr double kMinChamberDegcPerMin = 0.003;
constexpr double kSlowWindowS = 3600;
/// degC: smaller changes may be noise and steps of a sensor. plausibility_test.
constexpr double kMinDoubtedDegc = 10;

/// Roundings of double precision in a value that was calculated: a rate that moves by less stands
/// still. rate_resolution_test.
constexpr double kRoundings = 16;

}  // namespace fogcomp::recording::rules
