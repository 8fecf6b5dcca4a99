#include "io/write/output_file.hpp"

#include "scratch.hpp"

#include <fcntl.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <sys/wait.h>

#include <csignal>
#include <string>
#include <string_view>

namespace abut::io::testing {
namespace {

namespace fs = std::filesystem;

void write_whole(const std::string& path, std::string_view text) {
  OutputFile file(path);
  file.write(text);
  file.commit();
}

std::string refusal(const std::string& path, std::string_view text = "new") {
  const std::string sentence =
      sentence_of(ErrorCode::output_failed, [&] { write_whole(path, text); });
  EXPECT_TRUE(sentence.starts_with(path + ": cannot ")) << sentence;
  return sentence;
}

mode_t mode_of(const std::string& path) {
  struct stat status {};
  EXPECT_EQ(::lstat(path.c_str(), &status), 0);
  return status.st_mode & 07777;
}

TEST(OutputFile, AppearsAtTheCommitAndNotBefore) {
  const Scratch scratch;
  const std::string path = scratch.file("a.csv", "old");
  const std::string large(5 << 20, 'x');
  {
    OutputFile file(path);
    file.write(large);
    EXPECT_EQ(text_of(path), "old");
    file.commit();
  }
  EXPECT_EQ(text_of(path), large);
  EXPECT_EQ(scratch.file_count(), 1u);
}

TEST(OutputFile, WithoutCommitTheOldFileStays) {
  const Scratch scratch;
  const std::string path = scratch.file("a.csv", "old");
  {
    OutputFile file(path);
    file.write(std::string(5 << 20, 'x'));
    EXPECT_EQ(scratch.file_count(), 2u);
  }
  EXPECT_EQ(text_of(path), "old");
  EXPECT_EQ(scratch.file_count(), 1u);
}

TEST(OutputFile, GivenUpItLeavesNoHalfFile) {
  const Scratch scratch;
  const std::string path = scratch.file("a.csv", "old");
  // Asked once a buffer of 1 MiB and once before the file appears.
  for (int last = 0; last < 4; ++last) {
    int asked = 0;
    const std::string sentence = sentence_of(ErrorCode::cancelled, [&] {
      OutputFile file(path, [&] { return asked++ == last; });
      for (int part = 0; part < 3; ++part) file.write(std::string(1 << 20, 'x'));
      file.commit();
    });
    EXPECT_EQ(sentence, "cancelled while writing " + path);
    EXPECT_EQ(asked, last + 1);
    EXPECT_EQ(text_of(path), "old");
    EXPECT_EQ(scratch.file_count(), 1u);
  }
}

TEST(OutputFile, NamesWithoutFolder) {
  const Scratch scratch;
  const fs::path before = fs::current_path();
  fs::current_path(scratch.path("."));
  write_whole("plain.csv", "here");
  fs::current_path(before);
  EXPECT_EQ(text_of(scratch.path("plain.csv")), "here");
}

TEST(OutputFile, NewFilesObeyTheUmaskOldOnesKeepTheirPermissions) {
  const Scratch scratch;
  const mode_t before = ::umask(027);
  write_whole(scratch.path("fresh"), "");
  const std::string kept = scratch.file("kept", "old");
  ::chmod(kept.c_str(), 0604);
  write_whole(kept, "new");
  ::umask(before);
  EXPECT_EQ(mode_of(scratch.path("fresh")), 0640u);
  EXPECT_EQ(mode_of(kept), 0604u);
  EXPECT_EQ(text_of(kept), "new");
}

TEST(OutputFile, LinksAreFollowed) {
  const Scratch scratch;
  fs::create_directory(scratch.path("folder"));
  const std::string target = scratch.file("folder/target", "old");
  fs::create_symlink("folder/target", scratch.path("one"));
  fs::create_symlink(scratch.path("one"), scratch.path("two"));
  fs::create_symlink("folder/not yet", scratch.path("dangling"));
  write_whole(scratch.path("two"), "new");
  write_whole(scratch.path("dangling"), "first");
  EXPECT_EQ(text_of(target), "new");
  EXPECT_TRUE(fs::is_symlink(scratch.path("one")) && fs::is_symlink(scratch.path("two")));
  EXPECT_TRUE(fs::is_symlink(scratch.path("dangling")));
  EXPECT_EQ(text_of(scratch.path("folder/not yet")), "first");
  fs::create_symlink("circle", scratch.path("circle"));
  refusal(scratch.path("circle"));
}

TEST(OutputFile, DevicesAreWrittenAndNotReplaced) {
  write_whole("/dev/null", "gone");
  EXPECT_TRUE(fs::is_character_file("/dev/null"));
  const Scratch scratch;
  fs::create_symlink("/dev/null", scratch.path("null"));
  write_whole(scratch.path("null"), "gone");
  EXPECT_TRUE(fs::is_symlink(scratch.path("null")));
}

TEST(OutputFile, AFullDeviceIsReported) {
  EXPECT_NE(refusal("/dev/full").find("No space left"), std::string::npos);
  refusal("/dev/full", std::string(3 << 20, 'x'));
}

TEST(OutputFile, PlacesWhereNoFileCanBe) {
  const Scratch scratch;
  EXPECT_NE(refusal(scratch.path("no/such/a.csv")).find(scratch.path("no/such")),
            std::string::npos);
  refusal(scratch.path("."));
  const std::string file = scratch.file("file", "old");
  refusal(file + "/below");
  refusal(scratch.path(std::string(300, 'n')));
  refusal("/proc/no_file_can_be_made_here.csv");
  refusal("");
  EXPECT_EQ(text_of(file), "old");
  EXPECT_EQ(scratch.file_count(), 1u);
}

/// Runs an action in a child of its own; what it returns is the child's exit code.
template <class Action>
int in_child(const Action& action) {
  const pid_t child = ::fork();
  if (child == 0) ::_exit(action());
  int status = -1;
  ::waitpid(child, &status, 0);
  return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
}

/// 0 if the output failed as it should.
int fails(const std::string& path, std::string_view text) {
  try {
    write_whole(path, text);
  } catch (const Error& error) {
    return error.code() == ErrorCode::output_failed ? 0 : 2;
  }
  return 1;
}

TEST(OutputFile, AFailureHalfWayLeavesTheOldFileAlone) {
  const Scratch scratch;
  const std::string path = scratch.file("a.csv", "old");
  EXPECT_EQ(in_child([&] {
              std::signal(SIGXFSZ, SIG_IGN);
              const rlimit limit{2 << 20, 2 << 20};
              ::setrlimit(RLIMIT_FSIZE, &limit);
              return fails(path, std::string(5 << 20, 'x'));
            }),
            0);
  EXPECT_EQ(text_of(path), "old");
  EXPECT_EQ(scratch.file_count(), 1u);
}

TEST(OutputFile, WriteProtectedFilesAndFoldersStay) {
  const Scratch scratch;
  fs::create_directory(scratch.path("folder"));
  const std::string file = scratch.file("file", "old");
  ::chmod(file.c_str(), 0444);
  ::chmod(scratch.path(".").c_str(), 0777);
  ::chmod(scratch.path("folder").c_str(), 0555);
  // The superuser may write anywhere: the child becomes somebody else.
  constexpr uid_t nobody = 65534;
  const auto as_nobody = [](const std::string& path) {
    return in_child([&] {
      if (::geteuid() == 0 && ::setuid(nobody) != 0) return 3;
      return fails(path, "new");
    });
  };
  EXPECT_EQ(as_nobody(scratch.path("folder/a.csv")), 0);
  EXPECT_EQ(as_nobody(file), 0);
  EXPECT_EQ(text_of(file), "old");
  EXPECT_EQ(scratch.file_count(), 2u);
}

/// Runs an action with standard output going to a descriptor.
template <class Action>
int with_standard_output(int descriptor, const Action& action) {
  return in_child([&] {
    std::signal(SIGPIPE, SIG_IGN);
    if (::dup2(descriptor, STDOUT_FILENO) < 0) return 9;
    return action();
  });
}

TEST(OutputFile, StandardOutputByItsNames) {
  for (const char* name : {"-", "/dev/stdout", "/dev/fd/1", "/proc/self/fd/1"}) {
    SCOPED_TRACE(name);
    const Scratch scratch;
    const int descriptor =
        ::open(scratch.path("out").c_str(), O_WRONLY | O_CREAT | O_CLOEXEC, 0600);
    const auto write_twice = [&] {
      write_whole(name, "one ");
      write_whole(name, "two");
      return 0;
    };
    EXPECT_EQ(with_standard_output(descriptor, write_twice), 0);
    ::close(descriptor);
    EXPECT_EQ(text_of(scratch.path("out")), "one two");
    EXPECT_EQ(scratch.file_count(), 1u);
  }
}

TEST(OutputFile, StandardOutputClosedOrFull) {
  int ends[2];
  ASSERT_EQ(::pipe(ends), 0);
  ::close(ends[0]);
  const auto meets_closed_pipe = [] {
    try {
      write_whole("-", "text");
    } catch (const ClosedPipe&) {
      return 0;
    } catch (const Error&) {
      return 1;
    }
    return 2;
  };
  EXPECT_EQ(with_standard_output(ends[1], meets_closed_pipe), 0);
  ::close(ends[1]);
  const int full = ::open("/dev/full", O_WRONLY | O_CLOEXEC);
  EXPECT_EQ(with_standard_output(full, [] { return fails("-", "text"); }), 0);
  ::close(full);
  EXPECT_EQ(in_child([] {
              ::close(STDOUT_FILENO);
              return fails("-", "text");
            }),
            0);
}

}  // namespace
}  // namespace abut::io::testing
