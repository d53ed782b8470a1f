// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef SEGMENT_MESH_OUTPUT_FILES_H
#define SEGMENT_MESH_OUTPUT_FILES_H

#include "Signal_handlers.h"
#include "check_outputs.h"

#ifndef _WIN32
#include <sys/stat.h>
#include <unistd.h>
#endif

#include <algorithm>
#include <cstddef>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <random>
#include <set>
#include <sstream>
#include <string>
#include <system_error>
#include <utility>
#include <vector>

namespace segment_mesh {

// The files that a run writes, each under a temporary name in its own directory. All get their
// names in `commit()`, when they are complete. Files without a commit are removed, by a signal too;
// a run that is killed leaves its temporary files. Only one thread may use this class.
class Output_files
{
  struct File
  {
    Path name, temporary, target; // the target is behind the links of the name
  };

  struct Segment_directory
  {
    Path path;
    std::set<std::string> files, earlier_files;
    nlohmann::ordered_json closed_segments; // of the index
  };

  // Changes only under `Signal_block`, because a signal calls `remove_temporaries()`.
  std::vector<File> files_;
  std::vector<Path> new_directories_;

  std::vector<std::pair<Path, std::string> > streams_; // their names and contents
  std::vector<Segment_directory> segment_directories_;
  Signal_handlers handlers_;

  // Removes a file or an empty directory by functions that signal handlers may call.
  static void remove(const Path& name)
  {
#ifdef _WIN32
    std::error_code ignored;
    std::filesystem::remove(name, ignored);
#else
    if (unlink(name.c_str()) != 0)
      rmdir(name.c_str());
#endif
  }

  static void remove_temporaries(void* of)
  {
    const Output_files& files = *static_cast<const Output_files*>(of);
    for (std::size_t i = 0; i < files.files_.size(); ++i)
      remove(files.files_[i].temporary);
    for (std::size_t i = 0; i < files.new_directories_.size(); ++i)
      remove(files.new_directories_[i]);
  }

  static std::string temporary_name()
  {
    std::random_device random;
    char digits[number_of_temporary_digits + 1];
    std::snprintf(digits, sizeof digits, "%08x%08x", random(), random());
    return temporary_start + digits + temporary_end;
  }

  // Gives a file the owner and mode of the target as far as permitted.
  static void take_owner_and_mode([[maybe_unused]] const Path& temporary,
                                  [[maybe_unused]] const Path& target)
  {
#ifndef _WIN32
    struct stat status;
    if (stat(target.c_str(), &status) != 0)
      return;
    const uid_t same_user = static_cast<uid_t>(-1);
    [[maybe_unused]] const bool is_group_kept =
      chown(temporary.c_str(), status.st_uid, status.st_gid) == 0 ||
      chown(temporary.c_str(), same_user, status.st_gid) == 0;
    chmod(temporary.c_str(), status.st_mode & 0777);
#endif
  }

  static void write_stream(const Path& name, const std::string& content)
  {
    if (is_standard_output(name)) {
      if (!(std::cout << content << std::flush))
        throw Failure(Status::OUTPUT, "cannot write to standard output");
      return;
    }
    std::ofstream out(name, std::ios::binary);
    out << content;
    out.close();
    if (!out)
      throw_cannot_write(name);
  }

  // Throws after a renaming failed, which no earlier check foresaw.
  [[noreturn]] void throw_cannot_rename(std::size_t number_of_outputs, const std::string& reason)
  {
    const std::size_t number_written = number_of_outputs - files_.size();
    throw_cannot_write(files_.back().name, reason + (number_written == 0 ? "" :
                         "; " + std::to_string(number_written) + " of " +
                         std::to_string(number_of_outputs) + " outputs were written before"));
  }

  // Throws if an output cannot be written. Comes before any old file is touched.
  void check_targets() const
  {
    for (const File& f : files_)
      check_output_name(f.name);
  }

public:
  Output_files() : handlers_(remove_temporaries, this) {}
  Output_files(const Output_files&) = delete;
  Output_files& operator=(const Output_files&) = delete;

  ~Output_files() { remove_temporaries(this); }

  // Writes a temporary file, or keeps the content for a stream until `commit()`. `writer` writes to
  // a std::ostream.
  template <class Writer>
  void write(const Path& name, const Writer& writer)
  {
    check_output_name(name);
    if (is_stream(name)) {
      std::ostringstream out;
      writer(out);
      streams_.emplace_back(name, out.str());
      return;
    }
    const Path target = behind_links(name);
    const Path temporary = target.parent_path() / temporary_name();
    {
      const Signal_block block;
      files_.push_back({name, temporary, target});
    }
    std::ofstream out(temporary, std::ios::binary);
    take_owner_and_mode(temporary, target);
    writer(out);
    out.close();
    if (!out)
      throw_cannot_write(name);
  }

  // Prepares `commit()` to remove the files that an earlier run wrote to the directory, or left
  // there when it was killed. Two runs at a time must not write to one directory.
  void start_segments(const Path& directory,
                      const nlohmann::ordered_json& closed_segments = nullptr)
  {
    const Path path = split_directory_of(directory);
    segment_directories_.push_back({path, {}, earlier_segment_files(path), closed_segments});
    for (const File& f : files_) // this run may have other outputs there
      segment_directories_.back().earlier_files.erase(f.temporary.filename().string());
    if (std::filesystem::is_directory(path))
      return;
    const Signal_block block;
    std::error_code error;
    if (!std::filesystem::create_directory(path, error))
      throw_cannot_write(path, error.message());
    new_directories_.push_back(path);
  }

  // Writes a file to the directory that was started last. `is_segment_file()` must be true for its
  // name.
  template <class Writer>
  void write_segment(const std::string& name, const Writer& writer)
  {
    write(segment_directories_.back().path / name, writer);
    segment_directories_.back().files.insert(name);
  }

  // Writes to the streams, and gives all files their names. A signal comes before or after this,
  // except for what streams have got. An index of segments gets its name first, so that a later run
  // knows the files even if this one is killed.
  void commit()
  {
    for (const Segment_directory& d : segment_directories_)
      write(d.path / segment_index_name,
            [&](std::ostream& out) { out << segment_index(d.files, d.closed_segments); });
    for (const auto& stream : streams_)
      write_stream(stream.first, stream.second);
    check_targets();
    const Signal_block block;
    for (const Segment_directory& d : segment_directories_)
      for (const std::string& name : d.earlier_files)
        if (d.files.count(name) == 0)
          remove(d.path / name);
    const std::size_t number_of_outputs = files_.size();
    for (; !files_.empty(); files_.pop_back()) {
      std::error_code error;
      std::filesystem::rename(files_.back().temporary, files_.back().target, error);
      if (error)
        throw_cannot_rename(number_of_outputs, error.message());
    }
    new_directories_.clear();
  }
};

} // namespace segment_mesh

#endif // SEGMENT_MESH_OUTPUT_FILES_H
