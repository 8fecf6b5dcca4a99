#include "io/read/line_reader.hpp"

#include "scratch.hpp"

#include <sys/resource.h>

#include <algorithm>
#include <fstream>
#include <string>
#include <vector>

namespace abut::io::testing {
namespace {

const ProgressHook no_hook;

/// Lines of many lengths, so that they meet the ends of blocks at every offset.
std::vector<std::string> many_lines() {
  std::vector<std::string> lines;
  for (std::size_t k = 0; k < 3000; ++k) {
    lines.push_back(std::string(k * k % 997, static_cast<char>('a' + k % 26)));
  }
  lines[1500] = std::string(900'000, 'L');
  return lines;
}

std::string joined(const std::vector<std::string>& lines) {
  std::string text;
  for (const std::string& line : lines) text += line + "\n";
  return text;
}

TEST(LineReader, LinesAcrossBlocks) {
  const Scratch scratch;
  const std::vector<std::string> lines = many_lines();
  LineReader reader(scratch.file("a", joined(lines)), no_hook);
  for (std::size_t k = 0; k < lines.size(); ++k) {
    const auto line = reader.next();
    ASSERT_TRUE(line && *line == lines[k]) << k;
    ASSERT_EQ(reader.position().line, k + 1);
  }
  EXPECT_FALSE(reader.next());
  EXPECT_FALSE(reader.next());
  EXPECT_EQ(reader.bytes_left(), 0u);
}

TEST(LineReader, SkippingCountsAsReadingDoes) {
  const Scratch scratch;
  const std::vector<std::string> lines = many_lines();
  const std::string path = scratch.file("a", joined(lines));
  for (const std::size_t count : {0u, 1u, 1499u, 1501u, 2999u}) {
    LineReader reader(path, no_hook);
    reader.skip(count);
    EXPECT_EQ(reader.position().line, count);
    EXPECT_EQ(reader.next(), lines[count]);
  }
  LineReader reader(path, no_hook);
  reader.skip(UINT64_MAX);
  EXPECT_EQ(reader.position().line, lines.size());
  LineReader unended(scratch.file("b", "1\n2\n3"), no_hook);
  unended.skip(9);
  EXPECT_EQ(unended.position().line, 3u);
}

TEST(LineReader, BackToAnEarlierPositionOfAFile) {
  const Scratch scratch;
  const std::vector<std::string> lines = many_lines();
  LineReader reader(scratch.file("a", joined(lines)), no_hook);
  reader.skip(7);
  const TextPosition early = reader.position();
  reader.skip(2500);
  const TextPosition late = reader.position();
  reader.skip(1);
  reader.seek(late);
  EXPECT_EQ(reader.next(), lines[2507]);
  reader.seek(early);
  EXPECT_EQ(reader.next(), lines[7]);
  EXPECT_EQ(reader.position().line, 8u);
}

TEST(LineReader, ALineMayBeAsLongAsOneMebibyte) {
  const Scratch scratch;
  const std::string longest(1 << 20, 'x');
  LineReader fits(scratch.file("a", longest + "x\nend"), no_hook);
  sentence_of(ErrorCode::invalid_input, [&] { static_cast<void>(fits.next()); });
  LineReader exactly(scratch.file("b", longest + "\nend"), no_hook);
  EXPECT_EQ(exactly.next(), longest);
  EXPECT_EQ(exactly.next(), "end");
}

TEST(LineReader, FilesThatCannotBeRead) {
  const Scratch scratch;
  const auto sentence = [](const std::string& path) {
    return sentence_of(ErrorCode::invalid_input,
                       [&] { static_cast<void>(LineReader(path, no_hook)); });
  };
  const std::string missing = scratch.path("missing.csv");
  EXPECT_TRUE(sentence(missing).starts_with(missing + ": cannot be opened"));
  EXPECT_NE(sentence(scratch.path(".")).find("is a folder"), std::string::npos);
  EXPECT_NE(sentence("").find("cannot be opened"), std::string::npos);
  EXPECT_NE(sentence(std::string("a\0b", 3)).find("NUL"), std::string::npos);
}

TEST(LineReader, FilesOfProcWhoseSizeIsNotKnown) {
  LineReader reader("/proc/self/status", no_hook);
  EXPECT_FALSE(reader.bytes_left());
  EXPECT_TRUE(reader.next()->starts_with("Name:"));
}

std::string csv_of(std::size_t rows) {
  std::string text = "x,y,z,radius\n";
  for (std::size_t k = 0; k < rows; ++k) text += "0.12345678901234567,1.5,-2.5,1e-3\n";
  return text;
}

TEST(ReadProgress, BytesOfTheFileEveryFewMebibytes) {
  const std::string text = csv_of(600'000);
  std::vector<Progress> calls;
  ReadOptions options;
  options.progress = [&](const Progress& progress) {
    calls.push_back(progress);
    return ProgressAction::proceed;
  };
  EXPECT_EQ(read_text("a.csv", text, options).size(), 600'000u);
  ASSERT_GE(calls.size(), 3u);
  EXPECT_LE(calls.size(), 3 + (text.size() >> 20));
  for (const Progress& call : calls) {
    EXPECT_EQ(call.phase, "read");
    EXPECT_EQ(call.total, text.size());
    EXPECT_LE(call.done, text.size());
  }
  EXPECT_TRUE(std::is_sorted(calls.begin(), calls.end(),
                             [](const auto& a, const auto& b) { return a.done < b.done; }));
  calls.clear();
  EXPECT_EQ(read_piped(text, options).size(), 600'000u);
  ASSERT_GE(calls.size(), 3u);
  for (const Progress& call : calls) EXPECT_EQ(call.total, 0u);
}

TEST(ReadProgress, CancelStopsTheReading) {
  int calls = 0;
  ReadOptions options;
  options.progress = [&](const Progress&) {
    return ++calls == 2 ? ProgressAction::cancel : ProgressAction::proceed;
  };
  const std::string sentence = sentence_of(ErrorCode::cancelled, [&] {
    static_cast<void>(read_text("a.csv", csv_of(600'000), options));
  });
  EXPECT_NE(sentence.find("cancelled while reading"), std::string::npos);
  EXPECT_EQ(calls, 2);
}

/// Peak memory in KiB of a child process that runs an action.
template <class Action>
long peak_kib(const Action& action) {
  int ends[2];
  if (::pipe(ends) != 0) return -1;
  const pid_t child = ::fork();
  if (child == 0) {
    rusage before{};
    ::getrusage(RUSAGE_SELF, &before);
    action();
    rusage after{};
    ::getrusage(RUSAGE_SELF, &after);
    const long grown = after.ru_maxrss - before.ru_maxrss;
    const bool sent = ::write(ends[1], &grown, sizeof grown) == sizeof grown;
    ::_exit(sent ? 0 : 1);
  }
  ::close(ends[1]);
  long grown = -1;
  const bool received = ::read(ends[0], &grown, sizeof grown) == sizeof grown;
  ::close(ends[0]);
  return received ? grown : -1;
}

TEST(ReadMemory, FollowsTheFrameNotTheFile) {
  const Scratch scratch;
  const std::string head =
      "ITEM: TIMESTEP\n0\nITEM: NUMBER OF ATOMS\n20000\nITEM: BOX BOUNDS\n0 1\n0 1\n0 1\n"
      "ITEM: ATOMS x y z radius\n";
  std::string frame = head;
  for (int k = 0; k < 20'000; ++k) frame += "0.12345678901234567 0.5 0.25 0.0001\n";
  const std::string path = scratch.path("a.dump");
  {
    std::ofstream file(path, std::ios::binary);
    for (int k = 0; k < 60; ++k) file << frame;
  }
  frame = {};
  const std::string command = "cat " + path;
  const auto read_file = [&] {
    if (read_snapshot(path).size() != 20'000) ::_exit(1);
  };
  const auto read_pipe = [&] {
    FILE* const source = ::popen(command.c_str(), "r");
    if (read_snapshot("/dev/fd/" + std::to_string(::fileno(source))).size() != 20'000) ::_exit(1);
  };
  for (const long kib : {peak_kib(read_file), peak_kib(read_pipe)}) {
    EXPECT_GE(kib, 0);
    EXPECT_LT(kib, 25'000) << "the file has 44 MB, a frame 0.7 MB";
  }
}

}  // namespace
}  // namespace abut::io::testing
