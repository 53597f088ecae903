// Files for the loading station, and their history.
#include "batch/tables.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>

#include "board/table_files.hpp"
#include "support/input_error.hpp"
#include "support/output_file.hpp"
#include "support/sample_models.hpp"

namespace fogcomp::batch {
namespace {

class Tables : public testing::Test {
 protected:
  Tables() {
    std::string folder =
        (std::filesystem::temp_directory_path() / "fogcomp_tables_XXXXXX").string();
    folder_ = mkdtemp(folder.data());
  }
  ~Tables() override { std::filesystem::remove_all(folder_); }

  // A gyro that passes, or not, with a model of this bias.
  void calibrate(const std::string& gyro, double bias_dph, bool passes = true) {
    model::Model model = fog::test::paper_like_model();
    model.terms.front().coefficients_dph[0].value = bias_dph;
    model.serial = gyro;
    std::filesystem::create_directories(folder_ + "/" + gyro);
    write_file(folder_ + "/" + gyro + "/fog_model.h",
               board::header_text(board::make_board_table(model, {}), "test", 1));
    Summary summary;
    summary.gyros.push_back({{gyro, "", "", {}}, passes ? Outcome::pass : Outcome::fail, "", {}});
    write_tables(summary, folder_);
  }
  std::string file(const std::string& name) const { return read_file(folder_ + "/" + name); }
  // The word of a slot that orders the slots by age.
  int sequence(const std::string& name) const { return file(name).at(8); }
  std::size_t lines(const std::string& name) const {
    const std::string text = file(name);
    return static_cast<std::size_t>(std::count(text.begin(), text.end(), '\n'));
  }

  std::string folder_;
};

TEST_F(Tables, OfAGyroThatIsCalibratedAgainIsNewerAndTheOneBeforeIsKept) {
  calibrate("G1", 1);
  const std::string first = file("tables/G1.bin");
  EXPECT_EQ(sequence("tables/G1.bin"), 1);
  calibrate("G1", 1);
  EXPECT_EQ(file("tables/G1.bin"), first) << "the same calibration";
  EXPECT_EQ(lines("history/tables.csv"), 2U);
  calibrate("G1", 2);
  EXPECT_EQ(sequence("tables/G1.bin"), 2);
  EXPECT_EQ(file("history/G1-1.bin"), first);
  EXPECT_EQ(file("history/G1-2.bin"), file("tables/G1.bin"));
  calibrate("G2", 1);
  EXPECT_EQ(sequence("tables/G2.bin"), 1);
  calibrate("G1", 3, false);
  EXPECT_FALSE(std::filesystem::exists(folder_ + "/tables/G1.bin"));
  calibrate("G1", 1);
  EXPECT_EQ(sequence("tables/G1.bin"), 3) << "newer than the last, whatever it was before";
  EXPECT_EQ(lines("history/tables.csv"), 5U);
}

TEST_F(Tables, AHistoryThatIsNoneIsRefusedAndLeftAsItIs) {
  calibrate("G1", 1);
  const std::string spoilt = file("history/tables.csv") + "\"G1\",many,00000000\n";
  write_file(folder_ + "/history/tables.csv", spoilt);
  EXPECT_THROW(calibrate("G1", 2), InputError);
  EXPECT_EQ(file("history/tables.csv"), spoilt);
}

// RFC 4180.
TEST_F(Tables, ASerialNumberWithACommaIsOneCell) {
  calibrate("A,1", 1);
  const std::string line = file("tables/sheet.csv").substr(file("tables/sheet.csv").find('\n') + 1);
  EXPECT_EQ(line.rfind("\"A,1\",\"A,1\",any,", 0), 0U) << line;
  EXPECT_NE(file("history/tables.csv").find(",\"A,1\",any,\"A,1-1.bin\""), std::string::npos);
}

}  // namespace
}  // namespace fogcomp::batch
