#include "recording/foreign_format.hpp"

#include <algorithm>
#include <cctype>

#include "support/input_error.hpp"

namespace fogcomp::recording {
namespace {

using namespace std::string_view_literals;

/// A format and how a CSV is made of it.
struct Format {
  std::string_view start;  ///< its first bytes
  const char* is;
  const char* way;
};

constexpr const char* kHdf5Way =
    "write its columns as CSV: python3 -c \"import h5py, numpy as n; f = h5py.File('FILE'); "
    "n.savetxt('run.csv', n.c_[f['time'], f['temperature'], f['rate']], '%.17g', ',')\"";
constexpr const char* kRosWay =
    "write its topic as CSV: ros2 topic echo --csv /imu > run.csv, beside ros2 bag play FILE";

constexpr Format kFormats[] = {
    {"\x1F\x8B"sv, "is compressed by gzip", "give it unpacked: zcat FILE | fogcomp ... -"},
    {"BZh"sv, "is compressed by bzip2", "give it unpacked: bzcat FILE | fogcomp ... -"},
    {"\xFD\x37zXZ"sv, "is compressed by xz", "give it unpacked: xzcat FILE | fogcomp ... -"},
    {"PK\x03\x04"sv, "is a ZIP archive or an Excel workbook", "save the sheet as CSV"},
    {"MATLAB 5.0 MAT-file"sv, "is a MATLAB file",
     "write it with writetable as CSV, or octave --eval \"load FILE; dlmwrite('run.csv', [time "
     "temperature rate], 'precision', 17)\""},
    {"MATLAB 7.3 MAT-file"sv, "is a MATLAB 7.3 file (HDF5)", kHdf5Way},
    {"\x89HDF"sv, "is an HDF5 file", kHdf5Way},
    {"#ROSBAG"sv, "is a ROS bag",
     "write its topic as CSV: rostopic echo -b FILE -p /imu > run.csv"},
    {"\x89MCAP"sv, "is an MCAP file", kRosWay},
    {"SQLite format 3\0"sv, "is a database (a ROS 2 bag?)", kRosWay},
    {"ULog\x01\x12\x35"sv, "is a ULog of PX4",
     "make CSVs of it: ulog2csv FILE (pip install pyulog)"},
    {"\xA3\x95\x80\x80"sv, "is a log of ArduPilot",
     "make a CSV of it: mavlogdump.py --types IMU --format csv FILE > run.csv (pip install "
     "pymavlink)"},
    {"TDSm"sv, "is a TDMS file",
     "make a CSV of it: python3 -c \"from nptdms import TdmsFile as t; "
     "t.read('FILE').as_dataframe(time_index=True).to_csv('run.csv')\""},
    {"\x93NUMPY"sv, "is an array of NumPy",
     "make a CSV of it: python3 -c \"import numpy as n; n.savetxt('run.csv', n.load('FILE'), "
     "'%.17g', ',')\""},
    {"PAR1"sv, "is a Parquet file",
     "make a CSV of it: python3 -c \"import pandas as p; "
     "p.read_parquet('FILE').to_csv('run.csv', index=False)\""},
    {"RDX2\n"sv, "is a file of R", "make a CSV of it: load('FILE'), write.csv(data, 'run.csv')"},
    {"RDX3\n"sv, "is a file of R", "make a CSV of it: load('FILE'), write.csv(data, 'run.csv')"},
};

// A sequence number of six digits, the quality of the data, a blank.
bool is_miniseed(std::string_view head) {
  if (head.substr(0, 3) == "MS\x03"sv) return true;
  return head.size() >= 8 && "DRQM"sv.find(head[6]) != std::string_view::npos &&
         (head[7] == ' ' || head[7] == '\0') &&
         std::all_of(head.begin(), head.begin() + 6,
                     [](char c) { return std::isdigit(static_cast<unsigned char>(c)) != 0; });
}

}  // namespace

void refuse_foreign_format(std::string_view head, const std::string& path) {
  for (const Format& format : kFormats) {
    if (head.substr(0, format.start.size()) != format.start) continue;
    throw InputError(path, std::string(format.is) + "; " + format.way);
  }
  if (!is_miniseed(head)) return;
  throw InputError(path,
                   "is a miniSEED file; make a table of it: python3 -c \"import obspy; "
                   "obspy.read('FILE').write('run.txt', 'TSPAIR')\"");
}

}  // namespace fogcomp::recording
