// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef SEGMENT_MESH_BATCH_H
#define SEGMENT_MESH_BATCH_H

#include "Child_runs.h"
#include "../meshes/Failure.h"
#include "Mesh_table.h"
#include "Output_files.h"
#include "../meshes/read_input.h"

#ifndef _WIN32
#include <fcntl.h>
#include <signal.h>
#include <sys/file.h>
#include <unistd.h>
#endif

#include <algorithm>
#include <cerrno>
#include <chrono>
#include <cstddef>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <functional>
#include <iostream>
#include <string>
#include <system_error>
#include <unordered_set>
#include <utility>
#include <vector>

namespace segment_mesh {

// Returns the place of the outputs of an input in the directory of outputs. It is under the path of
// the input, without its root and without the steps that lead out of the working directory.
inline Path place_of(const std::string& input)
{
  Path result;
  for (const Path& part : Path(input).lexically_normal().relative_path())
    if (part != "..")
      result /= part;
  return result;
}

// Returns the meshes in a folder and in the folders in it, in ascending order, except those in the
// directory of outputs. Throws `Failure` if there are none. Returns the name itself if it is no
// folder.
inline std::vector<std::string> meshes_in(const std::string& folder, const Path& outputs)
{
  std::vector<std::string> result;
  std::error_code error, ignored;
  if (!std::filesystem::is_directory(folder, ignored))
    return {folder};
  if (std::filesystem::equivalent(outputs / place_of(folder), folder, ignored))
    throw Failure(Status::USAGE, "the outputs would be among the meshes of " + folder +
                                   "; choose another --out-dir");
  std::filesystem::recursive_directory_iterator entry(folder, error);
  for (; !error && entry != end(entry); entry.increment(error))
    if (entry->is_directory(ignored) && std::filesystem::equivalent(*entry, outputs, ignored))
      entry.disable_recursion_pending();
    else if (entry->is_regular_file(ignored) && has_mesh_ending(entry->path()))
      result.push_back(entry->path().string());
  if (error)
    throw Failure(Status::INPUT, "cannot search " + folder + ": " + error.message());
  if (result.empty())
    throw Failure(Status::INPUT, "there is no mesh in " + folder + ", by the endings of names");
  std::sort(result.begin(), result.end());
  return result;
}

// Returns the names in a list, one a line.
inline std::vector<std::string> read_list(const std::string& name)
{
  const auto fail = [&](const std::string& what)
  { throw Failure(Status::INPUT, "the list " + name + ' ' + what); };
  std::ifstream file;
  if (name != "-") {
    std::error_code ignored;
    file.open(name);
    if (!file || std::filesystem::is_directory(name, ignored))
      fail("cannot be opened");
  }
  std::vector<std::string> result;
  std::istream& in = name == "-" ? std::cin : file;
  for (std::string line; std::getline(in, line);) {
    if (result.empty() && line.compare(0, 3, "\xEF\xBB\xBF") == 0) // byte order mark of UTF-8
      line.erase(0, 3);
    if (!line.empty() && line.back() == '\r')
      line.pop_back();
    if (line.find('\0') != std::string::npos)
      fail("has a zero byte in line " + std::to_string(result.size() + 1) + ", so it is no text");
    if (!line.empty())
      result.push_back(line);
  }
  if (in.bad())
    fail("cannot be read");
  return result;
}

// Runs for many inputs, whose outputs are in one directory. A mesh that fails does not stop the
// others, and a later batch does what is missing:
// - parameters.json: what the results depend on, which is the same in all batches of a directory;
// - table.jsonl: how the run of each mesh ended;
// - .lock, which one batch at a time has;
// - for each input, under its path, the outputs of its run, among them the report PATH.json.
class Batch
{
public:
  // Writes outputs, whose names begin with the path, and returns a row of the table. It throws
  // nothing.
  typedef std::function<Json(const std::string& input, const Path& path)> Run;

  // Returns the row of a run that was ended by a signal, and writes its report.
  typedef std::function<Json(const std::string& input, const Path& path, const Failure&)> Report;

private:
  typedef std::chrono::steady_clock Clock;

  const Path directory_;
  const bool shows_progress_;
  Clock::time_point start_ = Clock::now();
  Clock::time_point last_shown_ = start_;
  std::size_t done_ = 0, failed_ = 0, kept_ = 0;

  void lock() const
  {
#ifndef _WIN32
    // Opens the file for writing, without which NFS locks nothing, until the program ends.
    const int file = open((directory_ / ".lock").c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0666);
    if (file < 0)
      throw_cannot_write(directory_ / ".lock", std::strerror(errno));
    if (flock(file, LOCK_EX | LOCK_NB) != 0 && errno == EWOULDBLOCK) // some systems have no locks
      throw Failure(Status::USAGE, "another batch runs in " + directory_.string());
#endif
  }

  void check_parameters(const Json& parameters) const
  {
    const Path file = directory_ / "parameters.json";
    std::ifstream in(file);
    if (in) {
      const Json earlier = Json::parse(in, nullptr, false);
      if (earlier.is_discarded() || earlier != parameters) // what is discarded differs from nothing
        throw Failure(Status::USAGE, "the results in " + directory_.string() +
                                       " have other parameters: see " + file.string());
      return;
    }
    Output_files files;
    files.write(file, [&](std::ostream& out) { out << parameters.dump(1) << "\n"; });
    files.commit();
  }

  Path path_of(const std::string& input) const { return directory_ / place_of(input); }

  // Throws if two inputs have the same place of outputs, or the same name in the table.
  static void check_places(const std::vector<std::string>& inputs)
  {
    typedef std::pair<std::string, std::string> Place_and_input;
    std::vector<Place_and_input> places = {{"parameters", "'parameters'"}}; // a file of the batch
    const auto check = [&] {
      std::sort(places.begin(), places.end());
      const auto same = std::adjacent_find(places.begin(), places.end(),
                                           [](const Place_and_input& a, const Place_and_input& b)
                                           { return a.first == b.first; });
      if (same != places.end())
        throw Failure(Status::USAGE, "the inputs " + same->second + " and " + (same + 1)->second +
                                       " would have the same outputs");
      places.clear();
    };
    for (const std::string& input : inputs)
      places.emplace_back(place_of(input).string(), input);
    check();
    for (const std::string& input : inputs)
      places.emplace_back(Mesh_table::name_in_table(input), input);
    check();
  }

  // Throws if a file that the batch reads or writes is something else, which might wait for ever.
  void check_files(const std::vector<std::string>& inputs) const
  {
    std::vector<Path> files = {directory_ / ".lock", directory_ / "parameters.json",
                               directory_ / "table.jsonl"};
    for (const std::string& input : inputs)
      files.push_back(path_of(input) += ".json");
    for (const Path& file : files) {
      std::error_code ignored;
      const std::filesystem::file_status status = std::filesystem::status(file, ignored);
      if (exists(status) && !is_regular_file(status))
        throw_cannot_write(file, "it is not a file");
    }
  }

  static bool is_newer(const Path& a, const Path& b)
  {
    std::error_code error_a, error_b;
    const auto time_a = std::filesystem::last_write_time(a, error_a);
    const auto time_b = std::filesystem::last_write_time(b, error_b);
    return !error_a && !error_b && time_a >= time_b;
  }

  // Returns whether each input is done. Leaves only the last line of each mesh in the table.
  std::vector<bool> which_are_done(Mesh_table& table, const std::vector<std::string>& inputs) const
  {
    const std::unordered_set<std::string> succeeded = table.tidy();
    std::vector<bool> result;
    for (const std::string& input : inputs)
      result.push_back(succeeded.count(Mesh_table::name_in_table(input)) > 0 &&
                       is_newer(path_of(input) += ".json", input));
    return result;
  }

  static Failure failure_of_signal(int signal)
  {
#ifndef _WIN32
    if (signal == SIGALRM || signal == SIGXCPU)
      return Failure(Status::TIME, "the run took longer than the time limit");
    if (signal == SIGKILL) // as the system does where memory is short
      return Failure(Status::MEMORY, "the run was killed, as where memory is short");
#endif
    return Failure(Status::BUG, "the run was ended by signal " + std::to_string(signal));
  }

  void show_progress(std::size_t total)
  {
    last_shown_ = Clock::now();
    const double seconds = std::chrono::duration<double>(last_shown_ - start_).count();
    std::cerr << '\r' << kept_ + done_ << " of " << total << " meshes, " << failed_ << " failed, "
              << static_cast<long>(seconds) << " s";
    if (done_ > 0)
      std::cerr << ", "
                << static_cast<long>(seconds * static_cast<double>(total - kept_ - done_) /
                                       static_cast<double>(done_) + 1)
                << " s to go ";
    std::cerr << std::flush;
  }

public:
  struct Counts
  {
    std::size_t done, failed, kept; // counted in an earlier batch
  };

  Batch(const std::string& directory, bool shows_progress)
    : directory_(directory), shows_progress_(shows_progress) {}

  // Runs all inputs that are not done. May be called once, before this process starts threads.
  Counts operator()(const std::vector<std::string>& inputs, const Json& parameters,
                    std::size_t number_of_jobs, const Run& run, const Report& report)
  {
    check_places(inputs);
    std::error_code error;
    std::filesystem::create_directories(directory_, error);
    if (!std::filesystem::is_directory(directory_))
      throw_cannot_write(directory_, error && !is_symlink(directory_) ? error.message()
                                                                      : "it is not a directory");
    check_files(inputs);
    lock();
    check_parameters(parameters);
    Mesh_table table(directory_ / "table.jsonl");
    const std::vector<bool> is_done = which_are_done(table, inputs);
    Child_runs runs;
    const auto end_run = [&] {
      const Child_runs::Ended_run ended = runs.wait();
      const std::string& input = inputs[ended.number];
      Json row = ended.result
        ? *ended.result : report(input, path_of(input), failure_of_signal(ended.signal));
      row["input"] = Mesh_table::name_in_table(input);
      table.add(row);
      ++done_;
      failed_ += row.value("status", "") != name_of(Status::OK);
      if (shows_progress_ && Clock::now() - last_shown_ > std::chrono::milliseconds(200))
        show_progress(inputs.size());
    };
    for (std::size_t i = 0; i < inputs.size(); ++i) {
      if (is_done[i]) {
        ++kept_;
        continue;
      }
      if (runs.size() == number_of_jobs)
        end_run();
      const Path path = path_of(inputs[i]);
      std::filesystem::create_directories(path.parent_path(), error);
      runs.start(i, [&, path] { return run(inputs[i], path); });
    }
    while (runs.size() > 0)
      end_run();
    table.tidy();
    if (shows_progress_)
      std::cerr << "\r\33[K" << std::flush;
    return {done_, failed_, kept_};
  }
};

} // namespace segment_mesh

#endif // SEGMENT_MESH_BATCH_H
