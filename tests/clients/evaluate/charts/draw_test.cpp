#include "clients/evaluate/charts/draw.hpp"

#include <gmock/gmock.h>

#include <fstream>
#include <sstream>

#include "clients/evaluate/files.hpp"
#include "tests/storage/temporary_directory.hpp"

namespace weft::evaluate {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

class PicturesOfStudies : public testing::Test {
 protected:
  PicturesOfStudies() {
    std::ofstream(folder.path() / "relocalise.csv") << "floor,light,seed,along,x,y,heading,found_m,wrong,refused\n"
                                                       "epoxy,same,4,forwards,0,2,0.25,,0,no_consensus\n"
                                                       "epoxy,same,4,forwards,1,2,0.25,0.5,0,\n";
  }
  std::vector<std::string> draw(const std::string& study, const Drawer& drawer = {}) {
    const Surroundings around{out, progress, [] { return 0.0; }, [] { return false; }};
    return draw_pictures(study, folder.path(), around, drawer);
  }
  /// Writes an executable that is run in place of Python.
  std::filesystem::path program(const std::string& text) const {
    const std::filesystem::path file = folder.path() / "python";
    std::ofstream(file) << "#!/bin/sh\n" << text << '\n';
    std::filesystem::permissions(file, std::filesystem::perms::owner_all);
    return file;
  }

  storage::TemporaryDirectory folder;
  std::ostringstream out, progress;
};

TEST_F(PicturesOfStudies, AreDrawnFromTheFilesInTheFolder) {
  EXPECT_THAT(draw("floor-relocalise"), ElementsAre("floor-relocalise.png"));
  EXPECT_EQ(progress.str(), "");
  const std::string picture = read_text(folder.path() / "floor-relocalise.png", "picture").value();
  EXPECT_EQ(picture.substr(1, 3), "PNG");
  EXPECT_GT(picture.size(), 3'000U);
}

TEST_F(PicturesOfStudies, WithoutPythonTheWarningSaysHowToDrawLater) {
  Drawer drawer;
  drawer.python = folder.path() / "no-python";
  EXPECT_THAT(draw("floor-relocalise", drawer), IsEmpty());
  EXPECT_THAT(progress.str(), HasSubstr((folder.path() / "no-python").string() + ": No such file or directory"));
  EXPECT_THAT(progress.str(), HasSubstr("what was measured is kept"));
  EXPECT_THAT(progress.str(), HasSubstr(drawer.python.string() + " " + drawer.script.string() + " floor-relocalise " +
                                        folder.path().string() + "\n"));
}

TEST_F(PicturesOfStudies, WithoutMatplotlibTheWarningNamesIt) {
  Drawer drawer;
  drawer.python = program("exec /usr/bin/python3 -S \"$@\"");  // without what Debian has packaged
  EXPECT_THAT(draw("floor-relocalise", drawer), IsEmpty());
  EXPECT_THAT(progress.str(), HasSubstr("matplotlib is missing; apt-get install python3-matplotlib"));
}

TEST_F(PicturesOfStudies, AFileThatIsMissingIsNamedAndAProgramThatDiesToo) {
  EXPECT_THAT(draw("floor"), IsEmpty());
  EXPECT_THAT(progress.str(), HasSubstr("floor.json: No such file or directory"));
  Drawer drawer;
  drawer.python = program("echo 'drawn: first.png'; kill -9 $$");
  EXPECT_THAT(draw("floor", drawer), ElementsAre("first.png"));
  EXPECT_THAT(progress.str(), HasSubstr("not all pictures are drawn: it failed without a word"));
}

TEST_F(PicturesOfStudies, AreCountedInWords) {
  EXPECT_EQ(words_of(std::vector<std::string>{}), "no pictures");
  EXPECT_EQ(words_of(std::vector<std::string>{"replay.png"}), "replay.png");
  EXPECT_EQ(words_of(std::vector<std::string>{"a.png", "b.png"}), "2 pictures");
}

}  // namespace
}  // namespace weft::evaluate
