// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "../Output_files.h"
#include "../../files/Segmented_soup.h"

#include <boost/test/unit_test.hpp>

#include <fcntl.h>
#include <grp.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <csignal>
#include <cstddef>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <iterator>
#include <new>
#include <random>
#include <set>
#include <stdexcept>
#include <string>
#include <thread>
#include <vector>

BOOST_AUTO_TEST_SUITE(output_files)

using segment_mesh::check_outputs;
using segment_mesh::Output_files;
using segment_mesh::Path;

namespace {

typedef std::set<std::string> Names;

// A new directory, which is the working directory for the time of a test.
class In_directory
{
  Path before_ = std::filesystem::current_path();
  Path directory_;

public:
  In_directory()
  {
    std::string name = (std::filesystem::temp_directory_path() / "output_files.XXXXXX").string();
    BOOST_REQUIRE(mkdtemp(name.data()) != nullptr);
    directory_ = name;
    std::filesystem::current_path(directory_);
  }

  ~In_directory()
  {
    std::filesystem::current_path(before_);
    std::filesystem::remove_all(directory_);
  }
};

void make(const Path& name, const std::string& content) { std::ofstream(name) << content; }

std::string content(const Path& name)
{
  std::ifstream in(name);
  return {std::istreambuf_iterator<char>(in), {}};
}

Names names_in(const Path& directory)
{
  Names result;
  for (const auto& entry : std::filesystem::directory_iterator(directory))
    result.insert(entry.path().filename().string());
  return result;
}

auto text(const std::string& content)
{
  return [content](std::ostream& out) { out << content; };
}

void write(const Path& name, const std::string& content)
{
  Output_files files;
  files.write(name, text(content));
  files.commit();
}

void write_segments(const Path& directory, std::size_t n, const std::string& extension = ".ply")
{
  Output_files files;
  files.start_segments(directory);
  for (std::size_t i = 0; i < n; ++i)
    files.write_segment(mesh_file::segment_name(i) + extension, text("new"));
  files.commit();
}

template <class Function>
std::string sentence_of(const Function& function)
{
  try {
    function();
  }
  catch (const std::runtime_error& e) {
    return e.what();
  }
  return "";
}

std::string checked(const std::vector<Path>& outputs, const Path& split_directory = "",
                    const std::vector<Path>& inputs = {})
{ return sentence_of([&] { check_outputs(inputs, outputs, {split_directory}); }); }

template <class Function>
pid_t start_child(const Function& function)
{
  std::cout << std::flush; // else the child prints it again
  const pid_t child = fork();
  BOOST_REQUIRE(child >= 0);
  if (child == 0) {
    for (int number : {SIGHUP, SIGINT, SIGQUIT, SIGTERM, SIGXCPU, SIGPIPE, SIGXFSZ, SIGABRT})
      std::signal(number, SIG_DFL); // Boost.Test has handlers of its own
    try {
      function();
    }
    catch (const std::exception&) {
      _exit(EXIT_FAILURE);
    }
    _exit(EXIT_SUCCESS);
  }
  return child;
}

int status_of_child(pid_t child)
{
  int status = 0;
  BOOST_REQUIRE(waitpid(child, &status, 0) == child);
  return status;
}

template <class Function>
int exit_status(const Function& function)
{
  const int status = status_of_child(start_child(function));
  BOOST_REQUIRE(WIFEXITED(status));
  return WEXITSTATUS(status);
}

template <class Function>
int signal_that_ended(const Function& function)
{
  const int status = status_of_child(start_child(function));
  return WIFSIGNALED(status) ? WTERMSIG(status) : 0;
}

// File permissions mean nothing to the superuser.
void become_nobody()
{
  const unsigned nobody = 65534;
  if (getuid() == 0 && (setgroups(0, nullptr) != 0 || setgid(nobody) != 0 || setuid(nobody) != 0))
    _exit(EXIT_FAILURE);
}

mode_t mode_of(const Path& name)
{
  struct stat status;
  BOOST_REQUIRE(stat(name.c_str(), &status) == 0);
  return status.st_mode & 07777;
}

const std::string old_content = "what was there before";

} // namespace

BOOST_AUTO_TEST_CASE(all_files_or_none)
{
  const In_directory directory;
  make("a", old_content);
  {
    Output_files files;
    files.write("a", text("new a"));
    files.write("b", text("new b"));
    for (const char* name : {"parts", "hulls"}) {
      files.start_segments(name);
      files.write_segment("segment_000.ply", text("part"));
    }
    BOOST_TEST(content("a") == old_content);
    BOOST_TEST(!std::filesystem::exists("b"));
  }
  BOOST_TEST(names_in(".") == Names{"a"}, boost::test_tools::per_element());
  BOOST_TEST(content("a") == old_content);
  BOOST_CHECK_THROW(Output_files().write("a", [](std::ostream& out) {
    out << "half";
    throw std::bad_alloc();
  }), std::bad_alloc);
  BOOST_TEST(names_in(".").size() == 1);
  write("a", "new a");
  BOOST_TEST(content("a") == "new a");
  BOOST_TEST(names_in(".").size() == 1);
}

BOOST_AUTO_TEST_CASE(links_stay)
{
  const In_directory directory;
  std::filesystem::create_directories("far/away");
  make("far/old", old_content);
  std::filesystem::create_symlink("../old", "far/away/link");
  std::filesystem::create_symlink("far/away/link", "link");
  std::filesystem::create_symlink("far/away/missing", "dangling");
  std::filesystem::create_symlink("loop", "loop");
  std::filesystem::create_symlink("parts_behind", "parts");
  write("link", "new");
  write("dangling", "made");
  write_segments("parts", 1);
  BOOST_TEST(std::filesystem::is_symlink("link"));
  BOOST_TEST(std::filesystem::is_symlink("far/away/link"));
  BOOST_TEST(content("far/old") == "new");
  BOOST_TEST(std::filesystem::is_symlink("dangling"));
  BOOST_TEST(content("far/away/missing") == "made");
  BOOST_TEST(content("parts_behind/segment_000.ply") == "new");
  BOOST_TEST(checked({"loop"}).find("cannot write loop: ") == 0);
}

BOOST_AUTO_TEST_CASE(modes)
{
  const In_directory directory;
  make("private", old_content);
  chmod("private", 0640);
  const mode_t before = umask(027);
  {
    Output_files files;
    files.write("private", [](std::ostream&) {
      for (const auto& entry : std::filesystem::directory_iterator("."))
        BOOST_TEST(mode_of(entry.path()) == 0640); // the temporary file, from its first byte on
    });
    files.commit();
  }
  write("fresh", "new");
  umask(before);
  BOOST_TEST(mode_of("private") == 0640);
  BOOST_TEST(mode_of("fresh") == 0640);
  chmod("private", 0600);
  write("private", "new");
  BOOST_TEST(mode_of("private") == 0600);
  if (getuid() == 0) {
    BOOST_REQUIRE(chown("private", 65534, 65534) == 0);
    write("private", "newer");
    struct stat status;
    stat("private", &status);
    BOOST_TEST(status.st_uid == 65534u);
  }
}

BOOST_AUTO_TEST_CASE(missing_permission)
{
  const In_directory directory;
  make("protected", old_content);
  chmod("protected", 0444);
  BOOST_TEST(checked({"protected"}) == "cannot write protected: it is write-protected");
  BOOST_CHECK_THROW(write("protected", "new"), std::runtime_error);
  BOOST_TEST(content("protected") == old_content);
  std::filesystem::create_directory("closed");
  chmod("closed", 0555);
  chmod(".", 0755);
  BOOST_TEST(exit_status([] {
    become_nobody();
    const std::string end = ": there is no permission to write to the directory closed";
    if (checked({"closed/x"}) != "cannot write closed/x" + end ||
        checked({}, "closed/parts") != "cannot write closed/parts" + end ||
        checked({}, "closed/") != "cannot write closed" + end)
      throw std::logic_error("no message");
  }) == EXIT_SUCCESS);
}

BOOST_AUTO_TEST_CASE(files_of_other_users)
{
  if (getuid() != 0)
    return; // only the superuser can make them
  const In_directory directory;
  const gid_t shared_group = 4242;
  chmod(".", 0755);
  for (const char* name : {"shared", "sticky"}) {
    std::filesystem::create_directory(name);
    const Path file = Path(name) / "x";
    make(file, old_content);
    chmod(file.c_str(), 0666);
    BOOST_REQUIRE(chown(file.c_str(), 1234, shared_group) == 0);
  }
  chmod("shared", 0777);
  chmod("sticky", 01777); // as /tmp
  BOOST_TEST(exit_status([&] {
    if (setgroups(1, &shared_group) != 0 || setgid(65534) != 0 || setuid(65534) != 0)
      throw std::logic_error("no other user");
    write("shared/x", "new");
    if (checked({"sticky/x"}) != "cannot write sticky/x: only its owner may replace it" ||
        checked({"sticky/y"}) != "")
      throw std::logic_error("no message");
  }) == EXIT_SUCCESS);
  struct stat status;
  BOOST_REQUIRE(stat("shared/x", &status) == 0);
  BOOST_TEST(status.st_gid == shared_group);
  BOOST_TEST((status.st_mode & 07777) == 0666u);
}

BOOST_AUTO_TEST_CASE(long_names)
{
  const In_directory directory;
  for (std::size_t length : {244, 245, 254, 255}) {
    const std::string name(length, 'x');
    BOOST_TEST(checked({name}) == "");
    write(name, "new");
    write(name, "newer");
    BOOST_TEST(content(name) == "newer");
  }
  BOOST_TEST(checked({std::string(256, 'x')}).find("too long") != std::string::npos);
}

BOOST_AUTO_TEST_CASE(names_that_cannot_be_written)
{
  const In_directory directory;
  std::filesystem::create_directory("d");
  make("file", old_content);
  BOOST_TEST(checked({"d"}) == "cannot write d: it is not a file");
  BOOST_TEST(checked({"d/"}) == "cannot write d/: it is not a file");
  BOOST_TEST(checked({"no/x"}) == "cannot write no/x: there is no directory no");
  BOOST_TEST(checked({"file/x"}) == "cannot write file/x: there is no directory file");
  BOOST_TEST(checked({"new/"}).find("cannot write new/") == 0);
  BOOST_TEST(checked({}, "file") == "cannot write file: it is not a directory");
  BOOST_TEST(checked({}, "no/parts") == "cannot write no/parts: there is no directory no");
}

BOOST_AUTO_TEST_CASE(inputs_are_not_overwritten)
{
  const In_directory directory;
  make("in", old_content);
  std::filesystem::create_symlink("in", "link");
  std::filesystem::create_hard_link("in", "hard");
  for (const char* name : {"in", "./in", "link", "hard"})
    BOOST_TEST(checked({name}, "", {"in"}) == std::string(name) + " is the input");
  BOOST_TEST(checked({"in"}, "", {"link"}) == "in is the input");
  BOOST_TEST(checked({"other"}, "", {"in"}) == "");
  BOOST_TEST(checked({"/dev/null"}, "", {"/dev/null"}) == "");
  write_segments("parts", 3);
  BOOST_TEST(checked({}, "parts", {"parts/segment_001.ply"}) ==
             "parts/segment_001.ply is the input");
  BOOST_TEST(exit_status([] {
    if (dup2(open("in", O_RDONLY), STDIN_FILENO) != STDIN_FILENO ||
        checked({"link"}, "", {"-"}) != "link is the input")
      throw std::logic_error("no message");
  }) == EXIT_SUCCESS);
}

BOOST_AUTO_TEST_CASE(clashes_of_names)
{
  const In_directory directory;
  std::filesystem::create_directory("d");
  std::filesystem::create_directory_symlink("d", "e");
  std::filesystem::create_symlink("d/x", "to_x");
  for (const char* name : {"d/x", "./d/x", "d/../d//x", "e/x", "to_x"})
    BOOST_TEST(checked({"d/x", "", name}) == std::string("two outputs have the name ") + name);
  make("d/x", old_content);
  BOOST_TEST(checked({"to_x", "e/x"}) == "two outputs have the name e/x");
  BOOST_TEST(checked({"-", "-"}) == "two outputs have the name -");
  BOOST_TEST(checked({"/dev/null", "/dev/null"}) == "");
  BOOST_TEST(checked({"d/x", "d/y", "-", "", ""}) == "");
  BOOST_TEST(checked({"parts"}, "parts/") == "two outputs have the name parts");
  std::filesystem::create_directory("parts");
  std::filesystem::create_symlink("parts/segment_123.ply", "to_segment");
  BOOST_TEST(checked({"parts/segment_00000.txt"}, "./parts/") != "");
  BOOST_TEST(checked({"to_segment"}, "parts").find("two outputs have the name parts/") == 0);
  BOOST_TEST(checked({"parts/segments.json"}, "parts").find("two outputs") == 0);
  for (const char* name : {"parts/segment_00.ply", "parts/segment_x.ply", "segment_000.ply"})
    BOOST_TEST(checked({name}, "parts") == "");
  BOOST_TEST(exit_status([] {
    if (dup2(open("d/x", O_WRONLY), STDOUT_FILENO) != STDOUT_FILENO ||
        checked({"-", "e/x"}) == "" || checked({"e/x", "-"}) == "")
      throw std::logic_error("no message");
  }) == EXIT_SUCCESS);
}

BOOST_AUTO_TEST_CASE(segments_of_an_earlier_run)
{
  const In_directory directory;
  BOOST_TEST(checked({}, "parts/") == "");
  write_segments("parts/", 5);
  make("parts/notes.txt", "of the user");
  BOOST_TEST(checked({}, "parts") == "");
  write_segments("parts", 2);
  const Names two{"notes.txt", "segment_000.ply", "segment_001.ply", "segments.json"};
  BOOST_TEST(names_in("parts") == two, boost::test_tools::per_element());
  {
    Output_files files; // it fails
    files.start_segments("parts");
    files.write_segment("segment_000.obj", text("new"));
  }
  BOOST_TEST(names_in("parts") == two, boost::test_tools::per_element());
  write_segments("parts", 1, ".obj");
  BOOST_TEST(names_in("parts") == (Names{"notes.txt", "segment_000.obj", "segments.json"}),
             boost::test_tools::per_element());
  write_segments("parts", 1200);
  BOOST_TEST(std::filesystem::exists("parts/segment_1199.ply"));
  write_segments("parts", 0);
  BOOST_TEST(names_in("parts").size() == 2);
}

BOOST_AUTO_TEST_CASE(files_of_an_earlier_run_that_stay)
{
  const In_directory directory;
  write_segments("parts", 3);
  chmod("parts/segment_002.ply", 0444);
  const std::string message = "cannot write parts/segment_002.ply: it is ";
  BOOST_TEST(checked({}, "parts") == message + "write-protected");
  BOOST_CHECK_THROW(write_segments("parts", 1), std::runtime_error);
  BOOST_TEST(content("parts/segment_002.ply") == "new");
  std::filesystem::remove("parts/segment_002.ply");
  std::filesystem::create_directory("parts/segment_002.ply"); // an empty one of the user
  BOOST_TEST(checked({}, "parts") == message + "not a file");
  BOOST_CHECK_THROW(write_segments("parts", 1), std::runtime_error);
  BOOST_TEST(std::filesystem::is_directory("parts/segment_002.ply"));
  std::filesystem::remove("parts/segment_002.ply");
  BOOST_TEST(checked({}, "parts") == "");
  make("other", old_content);
  std::filesystem::remove("parts/segment_001.ply");
  std::filesystem::create_symlink("../other", "parts/segment_001.ply");
  BOOST_TEST(checked({"other"}, "parts") == "two outputs have the name parts/segment_001.ply");
  chmod("parts/segments.json", 0444);
  BOOST_TEST(checked({}, "parts") == "cannot write parts/segments.json: it is write-protected");
  std::filesystem::remove("parts/segments.json");
  BOOST_REQUIRE(mkfifo("parts/segments.json", 0600) == 0);
  BOOST_TEST(checked({}, "parts") == "cannot write parts/segments.json: it is not a file");
}

BOOST_AUTO_TEST_CASE(directories_of_other_use)
{
  const In_directory directory;
  for (const char* index : {"", "[]", "{}", "{\"files\": [\"segment_000.ply\"]}",
                            "{\"writer\": \"segment_mesh\", \"files\": 1}"}) {
    std::filesystem::create_directory("d");
    make("d/segments.json", index);
    make("d/segment_000.ply", old_content);
    BOOST_TEST(checked({}, "d").find("cannot write d: its file ") == 0);
    BOOST_CHECK_THROW(write_segments("d", 1), std::runtime_error);
    BOOST_TEST(content("d/segment_000.ply") == old_content);
    BOOST_TEST(names_in("d").size() == 2);
    std::filesystem::remove_all("d");
  }
  write_segments("d", 1);
  make("d/segment_007.ply", old_content);
  BOOST_TEST(checked({}, "d").find("segment_007.ply") != std::string::npos);
  std::filesystem::remove("d/segment_007.ply");
  make("kept.ply", old_content);
  make("d/kept.ply", old_content);
  make("d/segments.json", R"({"writer": "segment_mesh", "files": ["../kept.ply", "kept.ply",
                          "segment_000.ply", "segment_001./../../kept.ply"]})");
  write_segments("d", 0);
  BOOST_TEST(content("kept.ply") == old_content);
  BOOST_TEST(names_in("d") == (Names{"kept.ply", "segments.json"}),
             boost::test_tools::per_element());
}

BOOST_AUTO_TEST_CASE(targets_that_change_during_a_run)
{
  const In_directory directory;
  make("a", old_content);
  make("c", old_content);
  {
    Output_files files;
    for (const char* name : {"a", "b", "c"})
      files.write(name, text("new"));
    std::filesystem::create_directory("b");
    BOOST_TEST(sentence_of([&] { files.commit(); }) == "cannot write b: it is not a file");
  }
  BOOST_TEST(names_in(".") == (Names{"a", "b", "c"}), boost::test_tools::per_element());
  BOOST_TEST(names_in("b").empty());
  BOOST_TEST(content("a") == old_content);
  BOOST_TEST(content("c") == old_content);
  write_segments("parts", 2);
  {
    Output_files files;
    files.start_segments("parts");
    files.write_segment("segment_000.ply", text("newer"));
    std::filesystem::remove("parts/segment_000.ply");
    std::filesystem::create_directory("parts/segment_000.ply");
    BOOST_CHECK_THROW(files.commit(), std::runtime_error);
  }
  BOOST_TEST(content("parts/segment_001.ply") == "new");
}

BOOST_AUTO_TEST_CASE(a_failure_names_the_files_that_were_written)
{
  const In_directory directory;
  {
    Output_files files;
    files.write("a", text("new"));
    const Names temporary = names_in(".");
    for (const char* name : {"b", "c"})
      files.write(name, text("new"));
    std::filesystem::remove(*temporary.begin());
    BOOST_TEST(sentence_of([&] { files.commit(); }) == "cannot write a: No such file or directory; "
                                                       "2 of 3 outputs were written before");
  }
  BOOST_TEST(names_in(".") == (Names{"b", "c"}), boost::test_tools::per_element());
}

// The temporary files of a run that is killed while it writes a segment.
Names leave_temporary_files(const Path& split_directory)
{
  const pid_t child = start_child([&] {
    Output_files files;
    files.start_segments(split_directory);
    for (std::size_t i = 0; i < 3; ++i)
      files.write_segment(mesh_file::segment_name(i) + ".ply", [&](std::ostream& out) {
        out << "half";
        if (i == 2)
          raise(SIGKILL);
      });
  });
  const int status = status_of_child(child);
  BOOST_TEST((WIFSIGNALED(status) && WTERMSIG(status) == SIGKILL));
  Names result;
  for (const std::string& name : names_in(split_directory))
    if (segment_mesh::is_temporary_file(name))
      result.insert(name);
  return result;
}

BOOST_AUTO_TEST_CASE(segments_of_a_run_that_was_killed)
{
  const In_directory directory;
  BOOST_TEST(leave_temporary_files("parts").size() == 3u);
  BOOST_TEST(checked({}, "parts") == "");
  write_segments("parts", 2);
  const Names two{"segment_000.ply", "segment_001.ply", "segments.json"};
  BOOST_TEST(names_in("parts") == two, boost::test_tools::per_element());
  BOOST_TEST(leave_temporary_files("parts").size() == 3u);
  write_segments("parts", 2);
  BOOST_TEST(names_in("parts") == two, boost::test_tools::per_element());
  for (const char* name :
       {".segment_mesh_0123456789abcde.tmp", ".segment_mesh_0123456789abcdeg.tmp",
        ".segment_mesh_0123456789abcdef.tmp2", ".0123456789abcdef.tmp",
        "segment_mesh_0123456789abcdef.tmp"}) {
    BOOST_TEST(!segment_mesh::is_temporary_file(name));
    std::filesystem::create_directory("others");
    make(Path("others") / name, old_content);
    BOOST_TEST(checked({}, "others").find("is not of an earlier run") != std::string::npos);
    std::filesystem::remove_all("others");
  }
}

BOOST_AUTO_TEST_CASE(streams)
{
  const In_directory directory;
  BOOST_REQUIRE(mkfifo("fifo", 0600) == 0);
  const pid_t child = start_child([] {
    if (dup2(open("out", O_WRONLY | O_CREAT, 0600), STDOUT_FILENO) != STDOUT_FILENO)
      _exit(EXIT_FAILURE);
    Output_files files;
    files.write("-", text("to standard output"));
    files.write("/dev/null", text("nowhere"));
    files.write("fifo", text("to a reader"));
    files.commit();
  });
  BOOST_TEST(content("fifo") == "to a reader");
  BOOST_TEST(status_of_child(child) == 0);
  BOOST_TEST(content("out") == "to standard output");
  BOOST_TEST(std::filesystem::is_fifo("fifo"));
  BOOST_TEST(std::filesystem::is_character_file("/dev/null"));
}

BOOST_AUTO_TEST_CASE(streams_that_take_nothing)
{
  const In_directory directory;
  make("a", old_content);
  const std::string message = "cannot write to standard output";
  const auto fails = [&](const auto& spoil) {
    return exit_status([&] {
      spoil();
      if (sentence_of([] {
            Output_files files;
            files.write("-", text(std::string(100000, 'x')));
            files.write("a", text("new"));
            files.commit();
          }) != message)
        throw std::logic_error("no message");
    }) == EXIT_SUCCESS;
  };
  BOOST_TEST(fails([] { close(STDOUT_FILENO); }));
  BOOST_TEST(fails([] { dup2(open("/dev/full", O_WRONLY), STDOUT_FILENO); }));
  BOOST_TEST(fails([] {
    int ends[2];
    if (pipe(ends) != 0 || close(ends[0]) != 0)
      _exit(EXIT_FAILURE);
    dup2(ends[1], STDOUT_FILENO);
  }));
  BOOST_TEST(sentence_of([] { write("/dev/full", "new"); }) == "cannot write /dev/full");
  BOOST_TEST(names_in(".") == Names{"a"}, boost::test_tools::per_element());
  BOOST_TEST(content("a") == old_content);
}

BOOST_AUTO_TEST_CASE(a_file_that_gets_too_large)
{
  const In_directory directory;
  make("a", old_content);
  BOOST_TEST(exit_status([] {
    const struct rlimit limit = {10000, 10000};
    setrlimit(RLIMIT_FSIZE, &limit);
    if (sentence_of([] { write("a", std::string(20000, 'x')); }) != "cannot write a")
      throw std::logic_error("no message");
  }) == EXIT_SUCCESS);
  BOOST_TEST(names_in(".") == Names{"a"}, boost::test_tools::per_element());
  BOOST_TEST(content("a") == old_content);
}

BOOST_AUTO_TEST_CASE(signals_in_any_thread)
{
  const In_directory directory;
  for (int number : {SIGHUP, SIGINT, SIGQUIT, SIGTERM, SIGXCPU})
    for (bool in_other_thread : {false, true}) {
      BOOST_TEST(signal_that_ended([&] {
        Output_files files;
        files.write("a", text("new"));
        files.start_segments("parts");
        if (!in_other_thread)
          raise(number);
        std::thread([&] { usleep(20000); raise(number); }).detach();
        for (std::size_t i = 0;; ++i) // while the signal is handled there, files are made here
          files.write_segment(mesh_file::segment_name(i) + ".ply", text("new"));
      }) == number);
      BOOST_TEST(names_in(".").empty());
    }
}

BOOST_AUTO_TEST_CASE(signals_wait_for_the_thread_of_the_files)
{
  const In_directory directory;
  BOOST_TEST(signal_that_ended([] {
    Output_files files;
    files.write("a", text("new"));
    {
      const segment_mesh::Signal_block block;
      std::thread other([] {
        sigset_t none;
        sigemptyset(&none);
        pthread_sigmask(SIG_SETMASK, &none, nullptr);
        raise(SIGTERM);
      });
      other.join();
      make("after_the_signal", "");
    }
    make("after_the_block", "");
  }) == SIGTERM);
  BOOST_TEST(names_in(".") == Names{"after_the_signal"}, boost::test_tools::per_element());
}

BOOST_AUTO_TEST_CASE(signals_handled_otherwise)
{
  const In_directory directory;
  static std::atomic<bool> handled{false};
  BOOST_TEST(exit_status([] {
    std::signal(SIGHUP, SIG_IGN); // as nohup does
    std::signal(SIGTERM, [](int) { handled = true; });
    {
      Output_files files;
      files.write("a", text("new"));
      raise(SIGHUP);
      raise(SIGTERM);
      files.commit();
    }
    struct sigaction action;
    for (int number : {SIGINT, SIGQUIT, SIGXCPU, SIGPIPE, SIGXFSZ})
      if (sigaction(number, nullptr, &action) != 0 || action.sa_handler != SIG_DFL)
        throw std::logic_error("a handler stays");
    if (!handled || content("a") != "new" || std::signal(SIGHUP, SIG_DFL) != SIG_IGN)
      throw std::logic_error("a handler was lost");
  }) == EXIT_SUCCESS);
}

// 80 runs of 10 megabytes, each ended by a signal at some time: all of its files are new, or none.
BOOST_AUTO_TEST_CASE(signals_at_random_times)
{
  const In_directory directory;
  std::mt19937 random(1);
  const auto run = [] {
    Output_files files;
    const std::string block(50000, 'x');
    const auto megabytes = [&](int n) {
      return [&block, n](std::ostream& out) {
        for (int i = 0; i < 20 * n; ++i)
          out << block;
      };
    };
    files.write("a", megabytes(4));
    files.write("b", megabytes(2));
    files.start_segments("parts");
    files.write_segment("segment_000.ply", megabytes(4));
    files.commit();
  };
  typedef std::chrono::steady_clock Clock;
  std::chrono::duration<double, std::micro> whole(1e9);
  for (int i = 0; i < 3; ++i) { // the first may be much slower
    const Clock::time_point start = Clock::now();
    BOOST_TEST(exit_status(run) == EXIT_SUCCESS);
    whole = (std::min)(whole, std::chrono::duration<double, std::micro>(Clock::now() - start));
  }

  int number_of_commits = 0, number_of_ends = 0;
  for (int i = 0; i < 80; ++i) {
    for (const char* name : {"b", "parts"})
      std::filesystem::remove_all(name);
    make("a", old_content);
    const int number = std::vector<int>{SIGHUP, SIGINT, SIGTERM}[random() % 3];
    const pid_t child = start_child(run);
    usleep(static_cast<useconds_t>(random() % static_cast<unsigned>(1.2 * whole.count() + 1)));
    kill(child, number);
    const int status = status_of_child(child);
    BOOST_TEST((status == 0 || (WIFSIGNALED(status) && WTERMSIG(status) == number)));
    if (names_in(".").size() == 1) {
      BOOST_TEST(content("a") == old_content);
      ++number_of_ends;
    }
    else {
      BOOST_TEST(names_in(".") == (Names{"a", "b", "parts"}), boost::test_tools::per_element());
      BOOST_TEST(std::filesystem::file_size("a") == 4000000u);
      BOOST_TEST(std::filesystem::file_size("b") == 2000000u);
      BOOST_TEST(std::filesystem::file_size("parts/segment_000.ply") == 4000000u);
      BOOST_TEST(names_in("parts").size() == 2);
      ++number_of_commits;
    }
  }
  BOOST_TEST_MESSAGE(number_of_ends << " ended before, " << number_of_commits << " after commit");
  BOOST_TEST(number_of_ends > 8);
}

BOOST_AUTO_TEST_SUITE_END()
