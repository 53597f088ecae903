#include "recording/input_file.hpp"

#include <algorithm>
#include <cctype>
#include <iterator>

#include "support/input_error.hpp"
#include "support/text.hpp"

namespace fogcomp::recording {
namespace {

using namespace std::string_view_literals;

/// A format and how a CSV is made of it: by a script of importers/, or in words.
struct Format {
  std::string_view start;  ///< its first bytes
  const char* is;
  const char* way = nullptr;
  const char* importer = "";
};

constexpr const char* kRWay =
    "make a CSV of it: Rscript -e \"write.csv(get(load('FILE')), 'run.csv', row.names = FALSE)\"";

constexpr Format kFormats[] = {
    {"\x1F\x8B"sv, "is compressed by gzip", "give it unpacked: zcat FILE | fogcomp ... -"},
    {"BZh"sv, "is compressed by bzip2", "give it unpacked: bzcat FILE | fogcomp ... -"},
    {"\xFD\x37zXZ"sv, "is compressed by xz", "give it unpacked: xzcat FILE | fogcomp ... -"},
    {"\x28\xB5\x2F\xFD"sv, "is compressed by zstd", "give it unpacked: zstd -d FILE"},
    {"PK\x03\x04"sv, "is a ZIP archive or an Excel workbook", "save the sheet as CSV"},
    {"MATLAB 5.0 MAT-file"sv, "is a MATLAB file",
     "make a CSV of it: octave --eval \"load FILE; dlmwrite('run.csv', [time(:) "
     "temperature(:) rate(:)], 'precision', 17)\""},
    {"MATLAB 7.3 MAT-file"sv, "is a MATLAB 7.3 file (HDF5)", nullptr, "hdf5"},
    {"\x89HDF"sv, "is an HDF5 file", nullptr, "hdf5"},
    {"#ROSBAG"sv, "is a ROS bag", nullptr, "rosbag"},
    {"\x89MCAP"sv, "is an MCAP file", nullptr, "mcap"},
    {"SQLite format 3\0"sv, "is a database (a ROS 2 bag?)", nullptr, "db3"},
    {"ULog\x01\x12\x35"sv, "is a ULog of PX4", nullptr, "ulog"},
    {"\xA3\x95\x80\x80"sv, "is a log of ArduPilot",
     "make a CSV of it: mavlogdump.py --types IMU --format csv FILE > run.csv (pip install "
     "pymavlink)"},
    {"TDSm"sv, "is a TDMS file",
     "make a CSV of it: python3 -c \"from nptdms import TdmsFile as t; "
     "t.read('FILE').as_dataframe(time_index=True).to_csv('run.csv')\""},
    {"\x93NUMPY"sv, "is an array of NumPy",
     "make a CSV of it: python3 -c \"import numpy as n; n.savetxt('run.csv', n.load('FILE'), "
     "'%.17g', ',')\""},
    {"PAR1"sv, "is a Parquet file", nullptr, "parquet"},
    {"RDX2\n"sv, "is a file of R", kRWay},
    {"RDX3\n"sv, "is a file of R", kRWay},
};

constexpr Format kMiniseed{""sv, "is a miniSEED file",
                           "make a table of it: python3 -c \"import obspy; "
                           "obspy.read('FILE').write('run.txt', 'TSPAIR')\""};

// A sequence number of six digits, the quality of the data, a blank.
bool is_miniseed(std::string_view head) {
  if (head.substr(0, 3) == "MS\x03"sv) return true;
  return head.size() >= 8 && "DRQM"sv.find(head[6]) != std::string_view::npos &&
         (head[7] == ' ' || head[7] == '\0') &&
         std::all_of(head.begin(), head.begin() + 6,
                     [](char c) { return std::isdigit(static_cast<unsigned char>(c)) != 0; });
}

const Format* format_of(std::string_view head) {
  const auto* found = std::find_if(
      std::begin(kFormats), std::end(kFormats),
      [&](const Format& each) { return head.substr(0, each.start.size()) == each.start; });
  if (found != std::end(kFormats)) return found;
  return is_miniseed(head) ? &kMiniseed : nullptr;
}

}  // namespace

std::string importer_of(std::string_view head) {
  const Format* format = format_of(head);
  return format == nullptr ? "" : format->importer;
}

void refuse_foreign_format(std::string_view head, const std::string& path) {
  const Format* format = format_of(head);
  if (format == nullptr) return;
  const std::string importing =
      "make a CSV of it: fogcomp convert " + shell_word(path) + " -o run.csv";
  throw InputError(
      path, std::string(format->is) + "; " + (format->way == nullptr ? importing : format->way));
}

}  // namespace fogcomp::recording
