#pragma once

#include <cstddef>

/// All thresholds for reading and dividing a recording: unit, origin, and the test that examines
/// the decision (in tests/unit/recording). The board's own limits are in the core and in
/// board_limits.hpp.
namespace fogcomp::recording::rules {

// ---- Gaps and segments ------------------------------------------------------------------------
/// Spacing of two rows (or samples), in row lengths, above which rows are missing: a lost row makes
/// 2. csv_reader_test, segments_test.
constexpr double kMaxSpacing = 1.5;

/// Seconds: gaps up to this do not end a segment. Chosen. Across gaps longer than kMaxUsualPeriodS,
/// which are no logger's rhythm, nothing is known of the chamber. segments_test.
constexpr double kMaxDropoutS = 1;

/// Definition of a ramp: minimum change, in degC or tolerances, however long it takes; and the
/// rate, degC/min, from which on a smaller change belongs to the ramp beside it. segments_test.
constexpr double kMinRampDegcPerMin = 0.05;
constexpr double kMinRampDegc = 2;
constexpr double kMinRampTolerances = 4;
/// Seconds; a shorter rest is a corner. Chosen. segments_test.
constexpr double kMinSoakS = 120;
/// Largest deviation of the temperature from a straight line, degC: at least this, what
/// is certainly no noise of it, and so many steps of its sensor. segments_test.
constexpr double kMinToleranceDegc = 0.3;
constexpr double kToleranceSteps = 1.25;

// ---- Rows that the board would refuse ---------------------------------------------------------
/// Seconds: a longer excursion may be a soak in a recording joined from several. row_judge_test.
constexpr double kMaxExcursionS = 600;
/// Seconds between samples: with longer ones a working sensor may repeat its value. row_judge_test.
constexpr double kMaxFrozenSampleS = 1;

/// Usual steps by which a value that stands for no reading is away from the samples around it: 6
/// sigma of white noise. Chosen. row_judge_test.
constexpr double kMinSentinelSteps = 6;

// ---- What kind of file is it? -----------------------------------------------------------------
/// A file with one control character in so many is not text. stream_reader_test.
constexpr std::ptrdiff_t kControlOneIn = 50;
/// Blocks of 1 MiB without a frame after which the file is no sensor stream. stream_reader_test.
constexpr std::size_t kMaxBlocksWithoutFrame = 64;
/// Detection of UTF-16 by its first characters, of which few are Latin in a sensor stream: number
/// examined, number needed, and fraction that has to be Latin. foreign_files_test.
constexpr std::size_t kUtf16UnitsLookedAt = 512;
constexpr std::size_t kMinUtf16Units = 8;
constexpr double kMinLatinShare = 0.9;
/// Seconds between rows; outside these time_s has another unit. csv_reader_test.
constexpr double kMinPeriodS = 1e-6;
constexpr double kMaxPeriodS = 86400;

/// Lines before the header (a logger's remarks), and rows used to find separator and decimal mark:
/// more than any logger writes, and more than are whole numbers by chance. foreign_files_test.
constexpr std::size_t kMaxLinesBeforeHeader = 200;
constexpr std::size_t kMaxRowsLookedAt = 2000;
/// Columns whose names are compared closely: ten times the widest log of an autopilot.
constexpr std::size_t kMaxColumnsUnderstood = 1000;
/// Sensors that one file has by turns. row_filter_test.
constexpr std::size_t kMaxSensors = 16;
/// Seconds since 1970 that a date is believed between, 2001 and 2100: no gyro has been powered for
/// 31 years. time_scale_test.
constexpr double kMinUnixTimeS = 1e9;
constexpr double kMaxUnixTimeS = 4.1e9;
/// Seconds between samples that a unit without a name is believed to give: 10 kHz is beyond any
/// gyro, and 10 min beyond a logger of one. time_scale_test.
constexpr double kMinUsualPeriodS = 1e-4;
constexpr double kMaxUsualPeriodS = 600;
/// A curve between readings of the input rate is unknown if its error is so many times the median
/// of that record's. Chosen: noise of the readings reaches six. sparse_input_rate_test.
constexpr double kMaxUsualErrors = 10;

// ---- Are the times those at which samples arrived? ----------------------------------------------
/// Samples that are looked at together: several times the longest pause, so that some came in time.
/// arrival_stamps_test.
constexpr double kWindowPauses = 4;
/// Fewer cases tell no rule: windows, or gaps that are none, whether samples are late or lost;
/// flanks, whether there is a delay. arrival_stamps_test, table_flanks_test.
constexpr std::size_t kMinCases = 8;
/// Share of windows that lose nothing, at least; with fewer, lost samples cannot be counted. And
/// scatter of the times between anchors about whole samples, in samples, below which they can:
/// without any grid it is 0.29. arrival_stamps_test.
constexpr double kShareWithoutLoss = 0.05;
constexpr double kMaxAnchorScatter = 0.12;
/// Rows for each reading of the gyro from which on repeats are left out: below, they change an
/// Allan deviation by less than its uncertainty. held_readings_test.
constexpr double kMinRowsPerReading = 1.05;

// ---- Does a record of the input rate tell the flanks of a rate table? -------------------------
/// Median of the flanks' angles, and of their scatter about one delay, in standard deviations of
/// the gyro's noise, above which there is a delay, or another movement: noise alone has 0.67; three
/// times it may still be that. table_flanks_test.
constexpr double kMaxFlankScatter = 2;
/// Seconds on either side of a flank by which a table has settled, twice: the outer half is taken
/// for steady. A longer movement is no flank. Chosen. table_flanks_test.
constexpr double kFlankReachS = 10;
/// Seconds of steady rate within one flank (a table that approaches its rate in two moves).
constexpr double kFlankPauseS = 1;
/// Smallest number of rows that show a steady rate on either side. table_flanks_test.
constexpr std::size_t kMinSteadyRows = 3;
/// Multiples of what is certainly no noise of the record by which the steady rates before and after
/// differ. table_flanks_test.
constexpr double kMinFlankSteps = 10;

// ---- Recordings longer than memory should hold ------------------------------------------------
/// Rows that are judged together: hours at 200 Hz, longer than any excursion (kMaxExcursionS).
/// long_recording_test.
constexpr std::size_t kPartRows = std::size_t{1} << 20U;
/// Largest number of stored means: 100 MB in three columns. long_recording_test.
constexpr std::size_t kMaxMeanRows = std::size_t{1} << 22U;

// ---- Figures that nothing has: another unit? --------------------------------------------------
/// deg/sqrt(h). Minimum: shot noise of 100 uW at 1550 nm, sqrt(2 h nu / P) = 5e-8 rad/sqrt(Hz),
/// over the Sagnac phase of 5 km on a diameter of 0.2 m, 2 pi L D / (lambda c) = 13 s, is 1.3e-5:
/// more light and fibre than gyros have. Maximum: 1 deg/s in a mean of 1 s, a hundred times a cheap
/// MEMS gyro's. plausibility_test.
constexpr double kMinAngleRandomWalkDprh = 1e-5;
constexpr double kMaxAngleRandomWalkDprh = 60;
/// Hours: a year without interruption. plausibility_test.
constexpr double kMaxRunHours = 8766;
/// degC/min over kHoldSeconds: chambers for thermal stress reach 15 to 25 in the air, and a coil
/// follows in minutes. plausibility_test.
constexpr double kMaxCoilDegcPerMin = 30;
/// degC/min over an hour: a room changes more between day and night (3 degC in 12 h, 0.25 degC/h).
/// plausibility_test.
constexpr double kMinChamberDegcPerMin = 0.003;
constexpr double kSlowWindowS = 3600;
/// degC: smaller changes may be noise and steps of a sensor. plausibility_test.
constexpr double kMinDoubtedDegc = 10;

/// Rounding errors of double precision in a calculated value: a rate that changes by less is
/// constant. rate_resolution_test.
constexpr double kRoundings = 16;

}  // namespace fogcomp::recording::rules
