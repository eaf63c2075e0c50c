// Requests to a session: what a line says, what a broken file does, and what is read when.
#include "study/control.h"

#include <fcntl.h>
#include <sys/stat.h>

#include <fstream>

#include "folder.h"
#include "motion/files.h"

namespace promenade::study {
namespace {

constexpr const char* now = "2026-11-22T16:00:10Z";

Request request(const std::string& id, const std::string& what = "pause") {
  Request one;
  one.id = id;
  one.session = "ours";
  one.what = what;
  one.written_utc = now;
  return one;
}

class ControlTest : public FolderTest {
 protected:
  ControlTest() { std::ofstream(file()) << "a database"; }
  std::string control() const { return requests_file(file()); }
  void append(const std::string& bytes) const {
    std::ofstream(control(), std::ios::app | std::ios::binary) << bytes;
  }
  static std::vector<std::string> ids(const std::vector<Request>& requests) {
    std::vector<std::string> ids;
    for (const Request& one : requests) ids.push_back(one.id);
    return ids;
  }
  std::vector<std::string> take(RequestReader& reader) {
    return ids(reader.take("ours", now).asked);
  }
};

using Ids = std::vector<std::string>;

TEST_F(ControlTest, ARequestComesBackAsItWasWritten) {
  Request one = request("a-1", "repeat");
  one.words = "the \"phone\" rang\nand 地震";
  one.block = true;
  one.page = 7;
  const auto again = read_request(line_of(one));
  ASSERT_TRUE(again);
  EXPECT_EQ(line_of(*again), line_of(one));
  EXPECT_EQ(again->words, one.words);
  EXPECT_TRUE(again->block);
  EXPECT_EQ(again->page, 7);
}

TEST_F(ControlTest, ReadsEachRequestOnceAndInOrder) {
  RequestReader reader(file());
  EXPECT_EQ(take(reader), Ids());
  ask(file(), request("a"));
  ask(file(), request("b"));
  EXPECT_EQ(take(reader), (Ids{"a", "b"}));
  EXPECT_EQ(take(reader), Ids());
  ask(file(), request("b"));
  ask(file(), request("c"));
  EXPECT_EQ(take(reader), Ids{"c"}) << "what has come once is not done again";
}

TEST_F(ControlTest, ReadsNothingFromBeforeItBegan) {
  ask(file(), request("old"));
  append(line_of(request("half")).substr(0, 20));
  RequestReader reader(file());
  append(line_of(request("half")).substr(20));
  ask(file(), request("new"));
  const RequestReader::News news = reader.take("ours", now);
  EXPECT_EQ(ids(news.asked), Ids{"new"});
  EXPECT_FALSE(news.broken) << "half of a line that is not for us";
}

TEST_F(ControlTest, ReadsWholeLinesAlone) {
  RequestReader reader(file());
  const std::string line = line_of(request("a"));
  append(line.substr(0, 30));
  EXPECT_EQ(take(reader), Ids());
  append(line.substr(30, line.size() - 31));
  EXPECT_EQ(take(reader), Ids());
  append("\n");
  EXPECT_EQ(take(reader), Ids{"a"});
}

TEST_F(ControlTest, LeavesRequestsToOthersAlone) {
  RequestReader reader(file());
  Request one = request("a");
  one.session = "theirs";
  ask(file(), one);
  const RequestReader::News news = reader.take("ours", now);
  EXPECT_TRUE(news.asked.empty() && news.late.empty() && !news.broken);
}

TEST_F(ControlTest, TellsWhatCameTooLate) {
  RequestReader reader(file());
  for (const char* written : {"2026-11-21T16:00:10Z", "2026-11-22T16:00:04Z", "soon", ""}) {
    Request one = request("late" + std::to_string(std::string(written).size()));
    one.written_utc = written;
    if (one.written_utc.starts_with("2026-11-21")) one.id = "yesterday";
    ask(file(), one);
  }
  Request fresh = request("fresh");
  fresh.written_utc = "2026-11-22T16:00:05Z";
  ask(file(), fresh);
  const RequestReader::News news = reader.take("ours", now);
  EXPECT_EQ(ids(news.asked), Ids{"fresh"});
  EXPECT_EQ(ids(news.late), (Ids{"yesterday", "late20", "late4", "late0"}));
}

struct Broken {
  const char* name;
  std::string bytes;
  bool told = true;
};

class BrokenControl : public ControlTest, public testing::WithParamInterface<Broken> {};

TEST_P(BrokenControl, IsPassedByAndToldOnce) {
  RequestReader reader(file());
  append(GetParam().bytes);
  RequestReader::News news;
  bool told = false;
  for (int k = 0; k < 40; ++k) {
    news = reader.take("ours", now);
    EXPECT_TRUE(news.asked.empty() && news.late.empty());
    EXPECT_FALSE(told && news.broken) << "twice";
    told = told || news.broken;
  }
  EXPECT_EQ(told, GetParam().told);
  ask(file(), request("good"));
  append("{ broken again\n");
  news = reader.take("ours", now);
  EXPECT_EQ(ids(news.asked), Ids{"good"});
  EXPECT_EQ(news.broken, !told);
}

std::string object(const std::string& members) {
  return R"({"id":"x","session":"ours","do":"pause",)" + members + "}\n";
}

INSTANTIATE_TEST_SUITE_P(
    Files, BrokenControl,
    testing::Values(
        Broken{"blank", "\n \r\n\t\n", false}, Broken{"text", "please pause\n"},
        Broken{"array", "[1, 2, 3]\n"}, Broken{"number", "7\n"},
        Broken{"half", R"({"id":"x","session":"ours","do":"pau)" + std::string("\n")},
        Broken{"no_id", R"({"session":"ours","do":"pause"})" + std::string("\n")},
        Broken{"odd_id", R"({"id":"a\"b","session":"ours","do":"pause"})" + std::string("\n")},
        Broken{"id_of_another_type",
               R"({"id":7,"session":"ours","do":"pause"})" + std::string("\n")},
        Broken{"long_id",
               R"({"session":"ours","do":"pause","id":")" + std::string(65, 'a') + "\"}\n"},
        Broken{"nothing_to_do", R"({"id":"x","session":"ours"})" + std::string("\n")},
        Broken{"bad_utf8", object("\"reason\":\"\xff\xfe\"")},
        Broken{"zeros", std::string(5000, '\0') + "\n"},
        Broken{"a_line_too_long", object("\"reason\":\"" + std::string(20'000, 'a') + "\"")},
        Broken{"a_line_far_too_long", std::string(900'000, 'a') + "\n"},
        Broken{"more_than_anybody_wrote", std::string(3'000'000, 'a') + "\n"},
        Broken{"deep", std::string(15'000, '[') + "\n"}),
    [](const auto& broken) { return broken.param.name; });

TEST_F(ControlTest, TakesOddMembersForWhatTheyAre) {
  const auto one = read_request(object(R"("page":-3,"block":"yes","reason":[1],"more":{})"));
  ASSERT_TRUE(one);
  EXPECT_EQ(one->page, -1);
  EXPECT_FALSE(one->block);
  EXPECT_EQ(one->words, "");
  EXPECT_EQ(read_request(object(R"("page":99999999999999999999)"))->page, -1);
  EXPECT_EQ(read_request(R"({"id":"x","session":"s","do":"dance"})")->what, "unknown");
}

TEST_F(ControlTest, CutsWordsThatAreTooLong) {
  std::string words;
  for (int k = 0; k < 600; ++k) words += "あ";
  Request one = request("a", "note");
  one.words = words;
  EXPECT_EQ(read_request(line_of(one))->words, words.substr(0, 3 * 500));
}

TEST_F(ControlTest, AsksForWordsWhereTheyAreNeeded) {
  for (const char* what : {"skip", "repeat", "note", "stop"}) {
    Request one = request("a", what);
    one.words = " \n";
    EXPECT_FALSE(action_of(one)) << what;
    one.words = "why";
    EXPECT_TRUE(action_of(one)) << what;
  }
  for (const char* what : {"pause", "resume", "release"})
    EXPECT_TRUE(action_of(request("a", what)));
  EXPECT_FALSE(action_of(request("a", "unknown")));
}

TEST_F(ControlTest, WaitsForNoPipeAndReadsNoFolder) {
  RequestReader reader(file());
  ASSERT_EQ(::mkfifo(control().c_str(), 0600), 0);
  EXPECT_EQ(take(reader), Ids());
  EXPECT_NE(message_of([&] { ask(file(), request("a")); }), "");
  std::filesystem::remove(control());
  std::filesystem::create_directory(control());
  EXPECT_EQ(take(reader), Ids());
  EXPECT_NE(message_of([&] { ask(file(), request("a")); }), "");
  std::filesystem::remove(control());
  ask(file(), request("a"));
  EXPECT_EQ(take(reader), Ids{"a"}) << "as soon as it is a file";
}

TEST_F(ControlTest, GoesOnInAFileThatWasMadeAnewOrEmptied) {
  RequestReader reader(file());
  ask(file(), request("a"));
  EXPECT_EQ(take(reader), Ids{"a"});
  remove_requests(file());
  ask(file(), request("b"));
  EXPECT_EQ(take(reader), Ids{"b"}) << "of the same size, perhaps under the same inode";
  std::filesystem::resize_file(control(), 0);
  EXPECT_EQ(take(reader), Ids());
  ask(file(), request("c"));
  EXPECT_EQ(take(reader), Ids{"c"});
}

TEST_F(ControlTest, IsMadeWithTheRightsOfTheDatabase) {
  for (const mode_t rights : {0600U, 0660U, 0644U}) {
    ASSERT_EQ(::chmod(file().c_str(), rights), 0);
    remove_requests(file());
    ask(file(), request("a"));
    struct stat state {};
    ASSERT_EQ(::stat(control().c_str(), &state), 0);
    EXPECT_EQ(state.st_mode & 0777U, rights);
  }
}

TEST_F(ControlTest, SaysThatItCannotBeWritten) {
  const std::string message = message_of([&] { ask(file("none/toy.db"), request("a")); });
  EXPECT_NE(message.find("cannot write"), std::string::npos) << message;
}

TEST_F(ControlTest, DoesNotFollowALinkToAnotherFile) {
  std::ofstream(file("theirs")) << "text";
  std::filesystem::create_symlink(file("theirs"), control());
  EXPECT_NE(message_of([&] { ask(file(), request("a")); }), "");
  EXPECT_EQ(read_file(file("theirs")), "text");
}

}  // namespace
}  // namespace promenade::study
